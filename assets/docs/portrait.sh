#!/usr/bin/env bash
# portrait.sh: draws a simulated scan as it comes, ray-cast, and beside it the face that Sonoskin makes of it.
#   portrait.sh OUT.jpg [INPUT [OPTIONS of sonoskin render ...]]     INPUT: a volume file; left out: a simulated scan
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
  "$sonoskin" render "${scan[@]}" --out "$work/$1.png" --view "$1" --camera "face,zoom=$2" --size 1200x1440 >"$work/log" 2>&1
}
draw volume 1.15  # the view of a volume leaves room for what is around the face
draw skin 0.92
montage -background '#000000' -geometry 1200x1440+4+0 -tile 2x1 "$work"/{volume,skin}.png "$work/all.png"
convert "$work/all.png" -strip -resize 50% -quality 90 "$out"
