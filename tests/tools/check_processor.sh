#!/usr/bin/env bash
# check_processor.sh OBJECT PROGRAM [QEMU]: the sentence for processors without AVX2 must not need AVX2 itself, and comes
# before all that does; with qemu's user mode the program is run on such a processor.
set -euo pipefail
if objdump -d "$1" | grep -E '%[yz]mm|\bv[a-z0-9]+ +.*%xmm'; then
  echo "$1 holds instructions that old processors lack"
  exit 1
fi
objdump -h "$1" | grep -q 'init_array\.00101' || { echo "$1 does not run before all others"; exit 1; }
[ $# -ge 3 ] || exit 0
status=0
words=$("$3" -cpu Nehalem "$2" --version 2>&1) || status=$?
echo "status $status: $words"
[ "$status" = 1 ] && grep -q '^sonoskin: error: This processor lacks AVX2' <<<"$words"
