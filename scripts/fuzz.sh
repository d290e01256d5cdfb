#!/usr/bin/env bash
# Fuzzes every reader for the given number of seconds each (default 60), starting from the valid files of tests/data.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
cmake --preset asan-ubsan >/dev/null
cmake --build --preset asan-ubsan --target fuzzers
find build/asan-ubsan/tests/fuzz -maxdepth 1 -type f -name 'fuzz_*' -executable | sort | while read -r fuzzer; do
  echo "$(basename "$fuzzer"), $seconds s"
  corpus=$(mktemp -d)
  find tests/data/formats -maxdepth 1 -type f -exec cp {} "$corpus" \;
  "$fuzzer" -max_total_time="$seconds" -verbosity=0 "$corpus"
  rm -r "$corpus"
done
