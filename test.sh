#!/usr/bin/env bash
# test.sh [CTEST ARGUMENT...]: installs what is missing, builds Sonoskin and runs every test.
set -uo pipefail
cd "$(dirname "$0")" || exit 1

cmake/build_release.sh || { echo "test: the build failed" >&2; exit 1; }

echo "test: running every test"
start=$SECONDS
ctest --preset release --timeout 300 --parallel "$(nproc)" "$@"
status=$?
if [ $status -eq 0 ]; then
  echo "test: all passed in $((SECONDS - start)) s"
else
  echo "test: FAILED after $((SECONDS - start)) s; the list is above, the details in build/release/Testing/Temporary/LastTest.log" >&2
fi
exit $status
