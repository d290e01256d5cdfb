#!/usr/bin/env bash
# Builds the program and the tests and passes them: the README's second command. It builds where the first one does, so
# what that compiled is not compiled again; the warnings are the same, and errors in both where CI is set (.ci/run sets it).
#   scripts/test.sh         every test but a dozen of half a minute or more that have shorter ones beside them (label long)
#   scripts/test.sh --long  these too, and builds the benchmarks: before a release
set -euo pipefail
cd "$(dirname "$0")/.."
case ${1:-} in
  "") left_out=(-LE '^long$') targets=(all) ;;
  --long) left_out=() targets=(all benchmarks) ;;
  *) echo "test.sh: must be --long or nothing; got \"$1\"" >&2; exit 2 ;;
esac
scripts/setup.sh
cmake --preset release
cmake --build --preset release --target "${targets[@]}"
ctest --preset release -j "$(nproc)" "${left_out[@]}" | tee build/tests.log
if grep -q '(Skipped)$' build/tests.log; then
  echo "Tests that are Skipped above need programs or libraries that are not installed: scripts/setup.sh ci installs them."
fi
