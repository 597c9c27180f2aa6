#!/bin/sh
# Meshes this case, solves the flow at 0 and 10 degrees, and holds it against what is known of it. nearwall must be on the
# PATH.
set -eu
cd "$(dirname "$0")"
sh ../openfoam/solve.sh 700 0
sh ../openfoam/solve.sh 900 10
/usr/bin/python3 evaluate.py "$@"
