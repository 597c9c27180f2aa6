#!/bin/sh
# Meshes one case and prints where the results are. nearwall must be on the PATH.
# usage: cmake/run-case.sh CASE.toml
# Where the case's folder has a geometry.sh and the surface is not there yet, the script makes it first.
set -eu
case_file="${1:?usage: cmake/run-case.sh CASE.toml}"
[ -f "$case_file" ] || { echo "run-case: no such case file: $case_file" >&2; exit 2; }
folder=$(dirname "$case_file")

# The value of `file` in [surface].
surface=$(awk '/^[[:space:]]*\[/ { in_surface = ($0 ~ /^[[:space:]]*\[surface\]/) }
               in_surface && /^[[:space:]]*file[[:space:]]*=/ { sub(/^[^=]*=[[:space:]]*["\047]/, ""); sub(/["\047].*$/, ""); print; exit }' "$case_file")
case "$surface" in
  /*) path="$surface" ;;
  *) path="$folder/$surface" ;;
esac
if [ -n "$surface" ] && [ ! -e "$path" ] && [ -f "$folder/geometry.sh" ]; then
  echo "making $path" >&2
  (cd "$folder" && sh geometry.sh)
fi
exec nearwall run "$case_file"
