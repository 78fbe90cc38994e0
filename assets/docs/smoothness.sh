#!/usr/bin/env bash
# smoothness.sh: draws one surface at T_sa 1e-5, 2e-5, 5e-5 and 1e-4 side by side, as in figure 4.3 of the thesis.
#   smoothness.sh OUT.png [INPUT [OPTIONS of sonoskin run ...]]     INPUT: a volume file, or "phantom" (the default)
# Needs build/release/sonoskin (or SONOSKIN), ImageMagick and the DejaVu fonts. About half a minute.
set -euo pipefail

out=$1
input=${2:-phantom}
shift $(( $# > 1 ? 2 : 1 ))
sonoskin=${SONOSKIN:-$(cd "$(dirname "$0")/../.." && pwd)/build/release/sonoskin}
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

pictures=()
for smoothness in 1e-5 2e-5 5e-5 1e-4; do
  "$sonoskin" run "$input" --out "$work/$smoothness" --reconstruction.smoothness "$smoothness" --size 720x720 "$@" >"$work/log" 2>&1
  pictures+=(-label "T_sa $smoothness" "$work/$smoothness/mesh.png")
done
montage -font "$font" -background '#15171b' -fill '#d8d8d8' -pointsize 28 -geometry 720x720+4+4 -tile 4x1 "${pictures[@]}" "$work/all.png"
convert "$work/all.png" -strip -resize 50% -colors 256 "$out"
