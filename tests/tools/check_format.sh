#!/usr/bin/env bash
# check_format.sh CLANG_FORMAT: every source file is as .clang-format wants it.
set -euo pipefail
cd "$(dirname "$0")/../.."
find core render app tests \( -name '*.h' -o -name '*.cpp' \) -print0 | xargs -0 "$1" --dry-run --Werror
