#!/usr/bin/env bash
# build_release.sh [TARGET...]: installs what is missing and builds the release into build/release: all of it, or the targets.
set -euo pipefail
cd "$(dirname "$0")/.."

cmake/install_packages.sh

# ccache, where somebody has it, makes the second build of a clone a matter of seconds.
launcher=()
if command -v ccache >/dev/null; then
  # With precompiled headers it must be told that they are named by their contents.
  cached="env;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache"
  launcher=("-DCMAKE_C_COMPILER_LAUNCHER=$cached" "-DCMAKE_CXX_COMPILER_LAUNCHER=$cached")
fi
echo "build: configuring"
cmake --preset release --log-level=WARNING "${launcher[@]}" >/dev/null
echo "build: compiling (some minutes the first time)"
cmake --build --preset release --parallel "$(nproc)" ${1:+--target "$@"}
echo "build: build/release/sonoskin is ready"
