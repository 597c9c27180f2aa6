#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape onera-m6 --half --size 0.0145 -o half-onera-m6.obj
