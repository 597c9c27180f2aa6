#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape quarter-cylinder --radius 0.5 --length 2 --size 0.05 -o quarter-cylinder.obj
