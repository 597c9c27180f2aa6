#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
/usr/bin/python3 geometry.py
