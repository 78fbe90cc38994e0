#!/usr/bin/env bash
# window.sh: pictures of the window on simulated scans: the four views, the comparing layout, a slice that is turned.
#   window.sh DIR
# Needs build/release/sonoskin (or SONOSKIN), Xvfb, xdotool and ImageMagick. About two minutes.
set -euo pipefail

out=$1
sonoskin=${SONOSKIN:-$(cd "$(dirname "$0")/../.." && pwd)/build/release/sonoskin}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# That of portrait.sh.
"$sonoskin" phantom --out "$work/scan.nrrd" --phantom.scene hands --phantom.seed 2 --phantom.shape 6 \
  --phantom.dims 312x170x165 --phantom.snr 30 >"$work/log" 2>&1

# shoot NAME WIDTHxHEIGHT LANGUAGE APPEARANCE SCAN, then the keys, each with the seconds to wait after it
shoot() {
  local name=$1 size=$2 language=$3 appearance=$4 scan=$5
  shift 5
  mkdir -p "$work/$name/sonoskin"
  printf '{"tourOffered": true, "width": %d, "height": %d, "language": "%s", "appearance": "%s"}' \
    "${size%x*}" "${size#*x}" "$language" "$appearance" >"$work/$name/sonoskin/settings.json"
  export XDG_CONFIG_HOME=$work/$name XDG_STATE_HOME=$work/$name SHOT=$work/$name.png
  export SONOSKIN_PROGRAM=$sonoskin SCAN=$scan KEYS="$*"
  xvfb-run -a -s "-screen 0 ${size}x24" bash -c '
    "$SONOSKIN_PROGRAM" $SCAN 2>/dev/null & program=$!
    sleep 15
    xdotool mousemove 5 300
    set -- $KEYS
    while [ $# -gt 1 ]; do xdotool key "$1"; sleep "$2"; shift 2; done
    import -window root "$SHOT"
    kill $program'
  convert "$SHOT" -strip -quality 88 "$out/$name.jpg"
}

shoot window 1600x1000 english dark "$work/scan.nrrd" ctrl+5 1 ctrl+Return 60
shoot window_compare 1280x720 german light "" F4 6
shoot window_oblique 1280x720 english dark "" F5 4
