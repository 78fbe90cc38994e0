#!/usr/bin/env bash
# check_format.sh CLANG_FORMAT: every source file is as .clang-format wants it; ends with 77 where that is not installed.
set -euo pipefail
if ! command -v "$1" >/dev/null; then
  echo "format: skipped: needs $1"
  exit 77
fi
cd "$(dirname "$0")/../.."
find core render app tests \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 "$1" --dry-run --Werror
