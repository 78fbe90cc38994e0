#!/usr/bin/env bash
# skin.sh: draws the simulated scan as a plain mesh and in the looks newborn, vernix and live side by side.
#   skin.sh OUT.jpg [INPUT [OPTIONS of sonoskin render ...]]     INPUT: a volume file; left out: a simulated scan
# Needs build/release/sonoskin (or SONOSKIN) and ImageMagick. About half a minute.
set -euo pipefail

out=$1
shift
[ $# -gt 0 ] || set -- phantom --phantom.scene hands --phantom.seed 2 --phantom.shape 6 --phantom.dims 312x170x165 --phantom.snr 30
sonoskin=${SONOSKIN:-$(cd "$(dirname "$0")/../.." && pwd)/build/release/sonoskin}
scan=("$@")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

draw() {
  "$sonoskin" render "${scan[@]}" --out "$work/$1.png" --camera face --size 596x682 "${@:2}" >"$work/log" 2>&1
}
draw mesh --view mesh
for look in newborn vernix live; do draw "$look" --look "$look"; done
montage -background '#000000' -geometry 596x682+2+2 -tile 4x1 "$work"/{mesh,newborn,vernix,live}.png "$work/all.png"
convert "$work/all.png" -strip -resize 50% -quality 90 "$out"
