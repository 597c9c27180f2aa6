#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape sphere-in-box --radius 0.5 --edge 4 --size 0.04 -o sphere-in-box.obj
