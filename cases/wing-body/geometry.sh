#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape wing-body --size 0.05 -o wing-body.obj
