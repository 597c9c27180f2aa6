#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape two-boxes --edge 1 --gap 0.1 --size 0.05 -o gap.obj
