#!/bin/sh
# Installs the Debian packages of cmake/debian-packages.txt that are missing, and asks nothing.
# usage: cmake/install-packages.sh [LABEL]...     adds those that carry one of the labels
set -eu
list="$(dirname "$0")/debian-packages.txt"
want=$(awk -v labels=" $* " '/^#/ || NF == 0 { next }
                             NF == 1 { print $1; next }
                             { for (i = 2; i <= NF; ++i) if (index(labels, " " $i " ")) { print $1; next } }' "$list")
missing=""
for package in $want; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q '^install ok installed$' || missing="$missing $package"
done
[ -n "$missing" ] || exit 0
if ! command -v apt-get >/dev/null; then
  echo "nearwall: apt-get is not here; install by hand:$missing" >&2
  exit 1
fi
root=""
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "nearwall: run as root or install sudo first; packages missing:$missing" >&2; exit 1; }
  root="sudo"
fi
echo "nearwall: installing$missing" >&2
$root env DEBIAN_FRONTEND=noninteractive apt-get update -qq
# shellcheck disable=SC2086
$root env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
