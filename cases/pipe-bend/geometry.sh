#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape bend --radius 0.5 --bend-radius 1.5 --angle 90 --size 0.06 -o pipe-bend.obj
