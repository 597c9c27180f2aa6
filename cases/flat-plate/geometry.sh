#!/bin/sh
# Makes the surface of this case beside case.toml.
set -eu
python3 geometry.py
