#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape ahmed-tunnel --slant-angle 25 --size 0.035 --box-size 0.25 -o ahmed-flow.obj
