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
failed=0
ctest --preset release -j "$(nproc)" "${left_out[@]}" || failed=$?
# Why tests, or parts of them, were skipped: as scripts of their own, unittest and pytest say it.
skipped=$(grep -aoP "^(skipped|left out): \K.*|\.\.\. skipped ['\"]\K.*(?=['\"]$)|^SKIPPED \[\d+\] \S+ \K.*" \
  build/release/Testing/Temporary/LastTest.log | sort | uniq -c) || true
if [[ -n $skipped ]]; then
  printf 'Left out, so many tests each (scripts/setup.sh ci installs what they need):\n%s\n' "$skipped"
fi
exit "$failed"
