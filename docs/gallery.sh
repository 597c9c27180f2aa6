#!/bin/sh
# Makes the pictures of docs/gallery.md: each shape, its layers, and two close-ups of its special place.
# usage: sh docs/gallery.sh [NAME...]     all without a NAME; nearwall and ImageMagick must be on the PATH
# Meshes are kept in $GALLERY (default: build/gallery), pictures go to docs/images.
set -eu
cd "$(dirname "$0")/.."
meshes="${GALLERY:-build/gallery}"
page=docs/gallery.md

# name | shape and parameters | thickness of the layers | place x,y,z | half width of the close-ups | view of the front |
# cut | fluid
places() {
  cat <<'TABLE'
wedge-2          | wedge --angle 2 --size 0.1                                    | 0.12 | 1,0.4,0      | 0.25 | 1.5,1,0.7    | y=0.05    | outside
wedge-5          | wedge --angle 5 --size 0.1                                    | 0.12 | 1,0.4,0      | 0.25 | 1.5,1,0.7    | y=0.05    | outside
wedge-10         | wedge --angle 10 --size 0.1                                   | 0.12 | 1,0.4,0      | 0.25 | 1.5,1,0.7    | y=0.05    | outside
wedge-20         | wedge --angle 20 --size 0.1                                   | 0.12 | 1,0.4,0      | 0.25 | 1.5,1,0.7    | y=0.05    | outside
wedge-60         | wedge --angle 60 --size 0.1                                   | 0.12 | 1,0.4,0      | 0.25 | 1.5,1,0.7    | y=0.05    | outside
knife-plate      | knife-plate --size 0.1                                        | 0.12 | 0.5,0.5,0    | 0.25 | 1,0.6,0.8    | 1,-1,0    | outside
delta-wing       | delta-wing --size 0.06                                        | 0.08 | 0,0,0        | 0.15 | -1,-0.6,0.7  | y=0.002   | outside
kinked-wing      | kinked-wing --size 0.1                                        | 0.12 | 1.385,-0.333,0 | 0.3 | 1.5,0.4,1   | y=-0.333  | outside
wing-tip         | naca --rounded-tip=0 --span 1.5 --size 0.06                   | 0.06 | 1,0.75,0     | 0.15 | 1.2,1,0.6    | y=0.72    | outside
fin-on-plate     | fin-on-plate --size 0.1                                       | 0.1  | 0.5,0,0      | 0.3  | 1.3,-1,0.8   | z=0.05    | outside
fin-on-sphere    | fin-on-sphere --size 0.08                                     | 0.08 | 0.4,0,0.917  | 0.25 | 1.3,-1,0.8   | z=0.98    | outside
wing-body        | wing-body --size 0.1                                          | 0.08 | 4.1,0.48,-0.15 | 0.3 | 1.2,1,0.8   | z=-0.15   | outside
notch-10         | notch --angle 10 --size 0.06                                  | 0.04 | 0,0.5,0.5    | 0.15 | 0.3,1,0.9    | y=0       | outside
notch-20         | notch --angle 20 --size 0.06                                  | 0.04 | 0,0.5,0.5    | 0.15 | 0.3,1,0.9    | y=0       | outside
notch-60         | notch --angle 60 --size 0.06                                  | 0.08 | 0,0.5,0.5    | 0.25 | 0.3,1,0.9    | y=0       | outside
notch-120        | notch --angle 120 --size 0.06                                 | 0.08 | 0,0.5,0.5    | 0.25 | 0.3,1,0.9    | y=0       | outside
block-on-floor   | block-on-floor --size 0.15                                    | 0.15 | 0.5,0.5,0    | 0.4  | 1,0.6,0.8    | y=0.3     | outside
pit              | pit --size 0.15                                               | 0.15 | 0.5,0.5,1.4  | 0.4  | -0.6,-1,1    | y=0.3     | outside
two-convex       | octants --pattern 7 --size 0.15                               | 0.15 | 0,0,0        | 0.4  | 1,0.7,0.9    | z=-0.2    | outside
two-concave      | octants --pattern 248 --size 0.15                             | 0.15 | 0,0,0        | 0.5  | -1,-0.7,-0.6 | z=-0.2    | outside
three-and-three  | octants --pattern 23 --size 0.15                              | 0.15 | 0,0,0        | 0.5  | 1,0.9,0.8    | 1,-1,0    | outside
blind-octants    | octants --pattern 139 --size 0.15                             | 0.15 | 0,0,0        | 0.5  | 1,-0.6,0.7   | z=0.1     | outside
omni-saddle      | omni-saddle --size 0.15                                       | 0.12 | 0,0,0        | 0.5  | 0.4,-1,-0.7  | y=0.001   | outside
crown            | crown --points 3 --ridge-slope 50 --valley-slope 50 --size 0.15 | 0.15 | 0,0,2      | 0.5  | 0.6,-0.8,1.2 | y=0.001   | outside
crown-8          | crown --points 8 --ridge-slope 50 --valley-slope 50 --size 0.15 | 0.15 | 0,0,2      | 0.5  | 0.6,-0.8,1.2 | y=0.001   | outside
star             | star --size 0.08                                              | 0.08 | 0,0,0.5      | 0.3  | 0.6,-0.8,1   | y=0.001   | outside
ski-jump         | ski-jump --size 0.1                                           | 0.1  | 2,0.4,0.8    | 0.3  | 1,0.7,0.7    | y=0.05    | outside
ski-jump-corner  | ski-jump-corner --size 0.08                                   | 0.08 | 2,0,0.5      | 0.3  | 1,-0.5,0.8   | x=1.95    | outside
cone-5           | cone --half-angle 5 --size 0.03                               | 0.04 | 0,0,0        | 0.09 | -1,-1,0.8    | y=0.001   | outside
cone-20          | cone --half-angle 20 --size 0.06                              | 0.06 | 0,0,0        | 0.2  | -1,-1,0.8    | y=0.001   | outside
pyramid          | pyramid --sides 3 --half-angle 5 --size 0.05                  | 0.04 | 0,0,0        | 0.09 | -1,-1,0.8    | y=0.001   | outside
twisted-roof     | twisted-roof --size 0.1                                       | 0.1  | 0,0,1.2      | 0.5  | 0.3,-1,1     | y=0.001   | outside
kinked-roof      | kinked-roof --size 0.1                                        | 0.1  | 0,0,1.2      | 0.4  | 0.3,-1,1     | y=0.001   | outside
fading-convex    | fading-ridge --size 0.08                                      | 0.08 | 0.9,0,0.45   | 0.45 | 0.2,-1,1     | x=1.6     | outside
fading-saddle    | fading-ridge --saddle --size 0.08                           | 0.08 | 0.9,0,0.6    | 0.45 | 0.2,-1,1     | x=1.6     | outside
concentric       | concentric-spheres --inner-radius 0.85 --size 0.12            | 0.12 | 0.9,0,0      | 0.2  | 1,-1,0.8     | y=0.001   | inside
thin-gap         | two-spheres --second-radius 0.6 --gap 0.001 --size 0.08       | 0.1  | 1,0,0        | 0.15 | 0.5,-1,0.5   | y=0.001   | outside
hair-gap         | two-boxes --gap 1e-7 --size 0.1                               | 0.1  | 0,0,0.5      | 0.25 | 0.5,-1,0.6   | y=0.001   | outside
small-body       | two-spheres --second-radius 0.02 --gap 0.03 --size 0.08       | 0.1  | 1.03,0,0     | 0.1  | 0.5,-1,0.5   | y=0.001   | outside
TABLE
}

# The columns of one row.
make_pictures() {
  name=$1 shape=$2 thickness=$3 place=$4 half=$5 view=$6 cut=$7 fluid=$8
  folder="$meshes/$name"
  mkdir -p "$folder"
  # shellcheck disable=SC2086 # the shape's parameters are several words
  nearwall shape $shape -o "$folder/shape.obj" --quiet
  cat >"$folder/case.toml" <<CASE
format = 1
name   = "$name"
[surface]
file  = "shape.obj"
fluid = "$fluid"
[layers]
total_thickness = $thickness
growth          = 1.2
count           = 8
[output]
pictures = false
CASE
  nearwall run "$folder/case.toml" -o "$folder/out" --force --quiet
  box=$(echo "$place" | awk -F, -v h="$half" '{ printf "%g,%g,%g,%g,%g,%g", $1-h, $2-h, $3-h, $1+h, $2+h, $3+h }')
  nearwall picture "$folder/out/$name-front.vtp" -o "$folder/front.png" --size 440x352 --zoom="$box" --view="$view" \
    --quiet
  nearwall picture "$folder/out/$name.vtu" -o "$folder/layers.png" --size 440x352 --zoom="$box" --clip="$cut" \
    --color Layer --range 0,8 --quiet
  # A palette of 48 colours makes the files a fifth as large.
  for what in front layers; do
    convert "$folder/$what.png" -strip +dither -colors 48 "PNG8:docs/images/gallery-$name-$what.png"
  done
  for mentioned in "gallery-$name-front.png" "gallery-$name-layers.png" "\`nearwall shape $shape\`"; do
    grep -qF -- "$mentioned" "$page" || { echo "gallery: $page does not mention $mentioned" >&2; exit 1; }
  done
}

places | sed 's/ *| */|/g; s/ *$//' | while IFS='|' read -r name shape thickness place half view cut fluid; do
  wanted=no
  [ $# -eq 0 ] && wanted=yes
  for asked; do [ "$asked" = "$name" ] && wanted=yes; done
  [ "$wanted" = yes ] || continue
  echo "$name" >&2
  make_pictures "$name" "$shape" "$thickness" "$place" "$half" "$view" "$cut" "$fluid" </dev/null
done
