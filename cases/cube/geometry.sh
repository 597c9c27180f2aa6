#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape cube --edge 1 --size 0.05 -o cube.obj
