#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape ahmed --slant-angle 25 --stilts --size 0.015 -o ahmed-25.obj
