#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape wing-body --half --size 0.05 -o half-wing-body.obj
