#!/usr/bin/env bash
# update_golden.sh PROGRAM [CASE ...]: draws expected.png of all cases of tests/golden anew, or of some. Look at each before
# committing it.
set -euo pipefail
program=$(realpath "$1")
shift
cd "$(dirname "$0")/../golden"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$program" phantom --phantom.dims 156x85x62 --out "$work/scan.nrrd" --truth "$work/truth.ply" >/dev/null 2>&1
for case in ${@:-*/}; do
  case=${case%/}
  read -r -a words <"$case/arguments.txt"
  "$program" render "${words[@]/@truth/$work/truth.ply}" --recipe "$case/recipe.json" --out "$case/expected.png"
done
