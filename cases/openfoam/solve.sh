#!/bin/sh
# Meshes a case and solves its flow with OpenFOAM's simpleFoam. Run in the folder of the case.
# usage: sh ../openfoam/solve.sh ITERATIONS [ANGLE]
# The mesh goes to out, the flow to out/flow, or out/flow-ANGLE. A mesh that is there is used again: rm -r out first for
# a new one. nearwall must be on the PATH. Exit code 77 where OpenFOAM is not installed.
set -eu
iterations="$1"
angle="${2:-}"
name=$(basename "$PWD")
flow="out/flow${angle:+-$angle}"
shared=../openfoam

export WM_PROJECT_DIR="${WM_PROJECT_DIR:-/usr/share/openfoam}"
command -v simpleFoam > /dev/null || { echo "solve.sh: no simpleFoam; apt-get install openfoam" >&2; exit 77; }

if [ ! -e "out/$name-openfoam" ]; then
  sh geometry.sh
  nearwall run case.toml --quiet --set output.pictures=false
fi

rm -rf "$flow"
cp -r "out/$name-openfoam" "$flow"
cp -r $shared/constant $shared/system openfoam/. "$flow"
/usr/bin/python3 $shared/flow.py case.toml out/report.json "$iterations" $angle > "$flow/flow"
[ ! -e openfoam/adapt.sh ] || (cd "$flow" && sh adapt.sh)
echo "$name: checkMesh, then $iterations iterations of simpleFoam in $flow" >&2
checkMesh -case "$flow" -allGeometry -allTopology > "$flow/log.checkMesh" || true
simpleFoam -case "$flow" > "$flow/log.simpleFoam" 2>&1 || { tail -n 20 "$flow/log.simpleFoam" >&2; exit 1; }
