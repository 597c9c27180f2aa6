#!/bin/sh
# Meshes this case, solves the flow, and holds it against what is known of it. nearwall must be on the PATH.
set -eu
cd "$(dirname "$0")"
sh ../openfoam/solve.sh 1000
/usr/bin/python3 evaluate.py "$@"
