#!/usr/bin/env bash
# update_golden.sh PROGRAM: draws every expected.png of tests/golden anew. Look at each before committing it.
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")/../golden"
for case in */; do
  read -r -a words <"$case/arguments.txt"
  "$program" render "${words[@]}" --recipe "$case/recipe.json" --out "$case/expected.png"
done
