#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape vessel --size 0.06 -o vessel.obj
