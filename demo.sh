#!/usr/bin/env bash
# demo.sh [FOLDER]: installs what is missing, builds the program (not its tests) and shows it at work on the simulated scan.
# With a display it opens the window; without one it runs the whole way into FOLDER (default: out).
set -euo pipefail
folder=$(realpath -m "${1:-$(dirname "$0")/out}")
cd "$(dirname "$0")"

cmake/build_release.sh sonoskin

if [ $# -eq 0 ] && [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
  echo "demo: opening the window on the simulated scan"
  exec build/release/sonoskin
fi

echo "demo: no window asked for or no display; running on the simulated scan"
build/release/sonoskin run phantom --out "$folder"
cat <<END
demo: done. Look at
  mesh      $folder/mesh.ply     (the true skin of the simulation: $folder/truth.ply)
  pictures  $folder/skin.png  $folder/mesh.png  $folder/volume.png  $folder/slices.png
  report    $folder/report.json  (repeat it with --recipe $folder/recipe.json)
END
