#!/bin/sh
# Solves a case in a folder of its own, so that the project's is left as it is.
# usage: solve_case.sh CASES NAME FOLDER      nearwall must be on the PATH
set -eu
cases="$1" name="$2" folder="$3"
mkdir -p "$folder/$name-run"
cd "$folder/$name-run"
rm -rf openfoam "$name"
cp -r "$cases/openfoam" openfoam
mkdir "$name"
cd "$cases/$name"
cp -r case.toml evaluate.py openfoam solve.sh geometry.* "$folder/$name-run/$name"
sh "$folder/$name-run/$name/solve.sh"
