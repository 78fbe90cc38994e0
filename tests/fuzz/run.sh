#!/usr/bin/env bash
# run.sh TARGET SECONDS [CORPUS]: whether the good files of the corpus are accepted, and then SECONDS of fuzzing from a fixed
# seed. What is learnt is kept in the folder CORPUS, where one is given; findings are left in build/fuzz/findings. Ends with
# 77 where the fuzzers are not built.
set -euo pipefail
cd "$(dirname "$0")/../.."
target=$1 seconds=$2 corpus=${3:-}
build=build/fuzz fuzzer=build/fuzz/${1}_fuzz

if [ ! -x "$fuzzer" ]; then
  echo "fuzz: skipped: $fuzzer is not built (tests/fuzz/build.sh)"
  exit 77
fi
TMPDIR=$(mktemp -d -p "$([ -w /dev/shm ] && echo /dev/shm || echo /tmp)")
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
corpus=${corpus:-$TMPDIR/corpus}
mkdir -p "$corpus" $build/findings
export UBSAN_OPTIONS=print_stacktrace=1

good=($build/seeds/"$target"/good_*)
if [ -e "${good[0]}" ] && ! SONOSKIN_FUZZ_ACCEPT=1 $fuzzer -runs=1 "${good[@]}" >"$TMPDIR/good" 2>&1; then
  cat "$TMPDIR/good"
  exit 1
fi
# Findings too: 80 MB asked for at once, by an input of two kilobytes, and ten seconds for one input.
$fuzzer -seed=1 -max_total_time="$seconds" -max_len=2048 -timeout=10 -malloc_limit_mb=80 -rss_limit_mb=1500 \
  -error_exitcode=1 -print_final_stats=1 -artifact_prefix="$build/findings/$target-" "$corpus" "$build/seeds/$target"
