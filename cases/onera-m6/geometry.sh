#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape onera-m6 --size 0.0145 -o onera-m6.obj
