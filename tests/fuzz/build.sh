#!/usr/bin/env bash
# build.sh: builds the fuzzers into build/fuzz and makes their corpus; ends with 77 where clang's fuzzer is not installed.
set -euo pipefail
cd "$(dirname "$0")/../.."

if ! command -v clang++-14 >/dev/null || [ ! -e "$(clang++-14 -print-file-name=libclang_rt.fuzzer-x86_64.a)" ]; then
  echo "fuzz: skipped: needs clang-14 and libclang-rt-14-dev"
  exit 77
fi
cmake --preset fuzz --log-level=WARNING >/dev/null
cmake --build --preset fuzz --parallel "$(nproc)"
python3 tests/fuzz/make_corpus.py build/fuzz/seeds
echo "fuzz: $(ls build/fuzz/*_fuzz | wc -l) fuzzers are ready in build/fuzz"
