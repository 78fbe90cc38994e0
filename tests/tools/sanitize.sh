#!/usr/bin/env bash
# sanitize.sh asan|tsan build core|app   builds the tests of a layer, and the program for those of app
# sanitize.sh asan|tsan core|app [N/OF]  runs part N of OF of them (all: 1/1); builds first what is not up to date
#
# asan: addresses, leaks and undefined behaviour; tsan: threads. A part ends at its first finding, with a status that is not 0.
# tests/README.md lists parts that stay below 20 minutes on two cores.
#
# What is known and not ours is in tests/tools/sanitize/*.supp, with its reason.
set -euo pipefail
cd "$(dirname "$0")/../.."

usage() {
  sed -n '2,3s/^# //p' "$0" >&2
  exit 2
}
kind=${1:-} what=${2:-} only=""
if [ "$what" = build ]; then what=${3:-} only=build part=1/1; else part=${3:-1/1}; fi
[[ $kind =~ ^(asan|tsan)$ && $what =~ ^(core|app)$ && $part =~ ^[1-9][0-9]*/[1-9][0-9]*$ ]] || usage

build=build/$kind known=$PWD/tests/tools/sanitize
cmake --preset "$kind" --log-level=WARNING >/dev/null
targets=("${what}_tests")
if [ "$what" = app ]; then targets+=(sonoskin); fi
cmake --build --preset "$kind" --parallel "$(nproc)" --target "${targets[@]}"
if [ $only ]; then exit 0; fi

export GTEST_TOTAL_SHARDS=${part#*/} GTEST_SHARD_INDEX=$((${part%/*} - 1)) GTEST_BRIEF=1
export UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1:suppressions=$known/undefined.supp
export ASAN_OPTIONS=detect_stack_use_after_return=1:allocator_may_return_null=1
export LSAN_OPTIONS=suppressions=$known/leaks.supp:print_suppressions=0
export TSAN_OPTIONS=halt_on_error=1:die_after_fork=0:handle_segv=0:ignore_noninstrumented_modules=1:suppressions=$known/threads.supp
# Its bound holds by 1 % at -O3; the rounding of -O1 is 2 % beyond it.
export GTEST_FILTER=-ChartSides.LooksFindTheLightOfTheSides
start=$SECONDS
"$build/${what}_tests"
echo "sanitize: $kind $what $part found nothing in $((SECONDS - start)) s"
