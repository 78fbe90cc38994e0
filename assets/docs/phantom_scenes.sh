#!/usr/bin/env bash
# phantom_scenes.sh: draws the simulated scenes side by side, ray-cast as the probe sees them.
#   phantom_scenes.sh OUT.jpg
# Needs build/release/sonoskin (or SONOSKIN), ImageMagick and the DejaVu fonts. About a minute.
set -euo pipefail

out=$1
sonoskin=${SONOSKIN:-$(cd "$(dirname "$0")/../.." && pwd)/build/release/sonoskin}
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

pictures=()
for scene in clear,1,0 thick,1,1 haze,1,2 saturated,1,3 enhanced,1,4 planes,1,5 turned,5,3 attached,4,5 cord,2,0 hands,2,0 \
             hands,5,6 clinical,2,2; do
  IFS=, read -r name seed shape <<<"$scene"
  options=(--phantom.dims 256x144x124 --phantom.scene "$name" --phantom.seed "$seed" --phantom.shape "$shape")
  "$sonoskin" render phantom --out "$work/$scene.png" --view volume --size 600x600 "${options[@]}" >"$work/log" 2>&1
  pictures+=(-label "$name, head $shape" "$work/$scene.png")
done
montage -font "$font" -background '#15171b' -fill '#d8d8d8' -pointsize 24 -geometry 600x600+4+4 -tile 4x3 "${pictures[@]}" "$work/all.png"
convert "$work/all.png" -strip -resize 40% -quality 85 "$out"
