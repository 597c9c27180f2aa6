#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape two-spheres --half --radius 1 --second-radius 0.5 --gap 0.05 --size 0.05 -o two-bodies-in-a-gap.obj
