#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
nearwall shape ahmed-tunnel --slant-angle 25 --stilts --size 0.015 -o car-in-tunnel.obj
