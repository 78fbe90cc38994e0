#!/usr/bin/env bash
# window.sh: pictures of the window on the simulated scan: the four views, the comparing layout, a slice that is turned.
#   window.sh DIR [NAME=1600x1000 ...]
# Needs build/release/sonoskin (or SONOSKIN), Xvfb, xdotool and ImageMagick. About two minutes.
set -euo pipefail

out=$1
sonoskin=${SONOSKIN:-$(cd "$(dirname "$0")/../.." && pwd)/build/release/sonoskin}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# shoot NAME WIDTHxHEIGHT LANGUAGE APPEARANCE, then the keys, each with the seconds to wait after it
shoot() {
  local name=$1 size=$2 language=$3 appearance=$4
  shift 4
  mkdir -p "$work/$name/sonoskin"
  printf '{"tourOffered": true, "width": %d, "height": %d, "language": "%s", "appearance": "%s"}' \
    "${size%x*}" "${size#*x}" "$language" "$appearance" >"$work/$name/sonoskin/settings.json"
  export XDG_CONFIG_HOME=$work/$name XDG_STATE_HOME=$work/$name SHOT=$work/$name.png
  export SONOSKIN_PROGRAM=$sonoskin KEYS="$*"
  xvfb-run -a -s "-screen 0 ${size}x24" bash -c '
    "$SONOSKIN_PROGRAM" 2>/dev/null & program=$!
    sleep 12
    xdotool mousemove 5 300
    set -- $KEYS
    while [ $# -gt 1 ]; do xdotool key "$1"; sleep "$2"; shift 2; done
    import -window root "$SHOT"
    kill $program'
  convert "$SHOT" -strip -quality 88 "$out/$name.jpg"
}

shoot window 1600x1000 english dark ctrl+Return 60
shoot window_compare 1280x720 german light F4 6
shoot window_oblique 1280x720 english dark F5 4
