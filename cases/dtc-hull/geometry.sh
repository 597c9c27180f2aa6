#!/bin/sh
# Takes the hull from Debian's package openfoam-examples, beside case.toml.
set -eu
hull=/usr/share/doc/openfoam-examples/examples/resources/geometry/DTC-scaled.stl.gz
if [ ! -f "$hull" ]; then
  echo "dtc-hull: $hull is missing; install the package openfoam-examples" >&2
  exit 1
fi
cp "$hull" dtc-hull.stl.gz
