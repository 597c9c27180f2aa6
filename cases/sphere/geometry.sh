#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape sphere --radius 1 --size 0.05 -o sphere.obj
