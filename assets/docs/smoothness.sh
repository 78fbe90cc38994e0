#!/usr/bin/env bash
# smoothness.sh: draws one surface at T_sa 1e-5, 2e-5, 5e-5 and 1e-4 side by side, as in figure 4.3 of the thesis.
#   smoothness.sh OUT.jpg [INPUT [OPTIONS of sonoskin render ...]]     INPUT: a volume file; left out: a simulated scan
# Needs build/release/sonoskin (or SONOSKIN), ImageMagick and the DejaVu fonts. About half a minute.
set -euo pipefail

out=$1
shift
[ $# -gt 0 ] || set -- phantom --phantom.scene hands --phantom.seed 2 --phantom.shape 6 --phantom.dims 312x170x165
sonoskin=${SONOSKIN:-$(cd "$(dirname "$0")/../.." && pwd)/build/release/sonoskin}
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

pictures=()
for smoothness in 1e-5 2e-5 5e-5 1e-4; do
  "$sonoskin" render "$@" --out "$work/$smoothness.png" --reconstruction.smoothness "$smoothness" --view mesh --camera face \
    --size 660x740 >"$work/log" 2>&1
  pictures+=(-label "T_sa $smoothness" "$work/$smoothness.png")
done
montage -font "$font" -background '#15171b' -fill '#d8d8d8' -pointsize 28 -geometry 660x740+4+4 -tile 4x1 "${pictures[@]}" "$work/all.png"
convert "$work/all.png" -strip -resize 50% -quality 90 "$out"
