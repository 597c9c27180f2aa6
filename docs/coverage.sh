#!/usr/bin/env bash
# Makes docs/coverage.md and its pictures anew: the figures of the layers on a folder of surfaces.
#   docs/coverage.sh SURFACES [BUILD]
# BUILD is a build folder with the program and the benchmarks (default: build/release). Figures that need a quiet
# machine (seconds) come from one run of this script.
set -euo pipefail

surfaces=${1:?usage: docs/coverage.sh SURFACES [BUILD]}
build=${2:-build/release}
docs=$(cd "$(dirname "$0")" && pwd)
sweep=$build/tests/benchmarks/nearwall_coverage_sweep
nearwall=$build/bin/nearwall
every=3        # surfaces of the ablation: every so many
left_out=_domain  # outer boundaries that enclose another surface of the folder
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$sweep" --schedule S --schedule R --root "$surfaces" --exclude "$left_out" \
  --summary "$work/summary.md" --markdown "$work/surfaces.md" --worst "$work/worst.tsv" "$surfaces" > "$work/sweep.txt"
"$sweep" --schedule S --schedule R --root "$surfaces" --exclude "$left_out" --every "$every" --ablation \
  --ablation-markdown "$work/ablation.md" "$surfaces" > "$work/ablation.txt"

# A box of a third of the diagonal round a place; a view along the normal there, from somewhat aside; and a plane that
# takes away what would stand before it.
box_round() { awk -v p="$1" -v d="$2" 'BEGIN { split(p, c, ","); h = 0.18 * d;
  printf "%g,%g,%g,%g,%g,%g", c[1]-h, c[2]-h, c[3]-h, c[1]+h, c[2]+h, c[3]+h }'; }
view_along() { awk -v n="$1" 'BEGIN { split(n, c, ","); l = sqrt(c[1]^2 + c[2]^2 + c[3]^2); if (l == 0) l = 1;
  printf "%g,%g,%g", c[1]/l + 0.2, c[2]/l - 0.25, c[3]/l + 0.15 }'; }
plane_before() { awk -v p="$1" -v n="$2" -v d="$3" 'BEGIN { split(p, c, ","); split(n, u, ","); h = 0.02 * d;
  printf "%g,%g,%g,%g,%g,%g", u[1], u[2], u[3], c[1]+h*u[1], c[2]+h*u[2], c[3]+h*u[3] }'; }

worst_of() {
  local n=0 name file all full first limits place normal diagonal
  while IFS=$'\t' read -r name file all full first limits place normal diagonal; do
    n=$((n + 1))
    "$nearwall" run "$docs/coverage.toml" --set "surface.file=$(realpath "$file")" --set name=worst --relative --quiet \
      -o "$work/run-$n" > /dev/null
    "$nearwall" picture "$work/run-$n/worst-surface.vtp" -o "$docs/images/coverage-$n.png" --color LimitReason --range 0,8 \
      --zoom "$(box_round "$place" "$diagonal")" --view "$(view_along "$normal")" \
      --clip "$(plane_before "$place" "$normal" "$diagonal")" --no-edges --size 480x320 --quiet > /dev/null
    rm -r "$work/run-$n"
    printf '| %s | %s | %s | %s | %s | ![%s](images/coverage-%d.png) |\n' \
      "$name" "$full" "$all" "$first" "$limits" "where $name has least" "$n"
  done < "$work/worst.tsv"
}

worst_of > "$work/worst.md"

{
  cat <<'TEXT'
# Coverage

What share of the wall has its layers, with default settings, on a folder of surfaces from many sources. Made by `docs/coverage.sh`;
every figure is by wall area, defined in [theory/quality.md](theory/quality.md).

- Schedule S: 20 layers, growth 1.2, together 1 % of the diagonal of the bounding box thick.
- Schedule R: 30 layers, growth 1.2, the first a millionth of the diagonal high.

## All surfaces together

TEXT
  cat "$work/summary.md"
  cat <<TEXT

"Late starts" are triangles that touch the end of a fan, where the first two layers are one ([theory/fans.md](theory/fans.md)).

## What each of the means contributes

Every ${every}rd surface again, each time with one of the means switched off. Limits that keep the mesh valid are never switched off:
without them the certificate takes away what they would have.

TEXT
  cat "$work/ablation.md"
  cat <<'TEXT'

## The ten with least at full thickness under S

Close up at the largest triangle of the largest reason. Colours: `LimitReason`, 0 none, 1 visibility, 2 curvature, 3 gap, 4 neighbour,
5 quality, 6 patch edge, 7 intersection, 8 isotropic (asked). What each means and what helps: [layers.md](layers.md).

| surface | full % | all % | first % | largest reason, % of the area | where |
| --- | ---: | ---: | ---: | --- | --- |
TEXT
  cat "$work/worst.md"
  cat <<'TEXT'

## All surfaces

`all %`, `full %`, `any %`: all layers; these at full thickness; any cell, be it no whole layer. `first %`: first height within 5 % of the asked one. `s`:
seconds of growing.

TEXT
  cat "$work/surfaces.md"
} > "$docs/coverage.md"
