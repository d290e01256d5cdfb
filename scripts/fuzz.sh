#!/usr/bin/env bash
# Fuzzes every reader for the given number of seconds each (default 60), starting from the valid files of tests/data. An
# input that takes 20 s or asks for a gigabyte is a finding too; how many were tried is printed.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
cmake --preset asan-ubsan >/dev/null
cmake --build --preset asan-ubsan --target fuzzers
find build/asan-ubsan/tests/fuzz -maxdepth 1 -type f -name 'fuzz_*' -executable | sort | while read -r fuzzer; do
  echo "$(basename "$fuzzer"), $seconds s"
  corpus=$(mktemp -d)
  find tests/data/formats -maxdepth 1 -type f -exec cp {} "$corpus" \;
  "$fuzzer" -max_total_time="$seconds" -timeout=20 -malloc_limit_mb=1000 -print_final_stats=1 -verbosity=0 "$corpus"
  rm -r "$corpus"
done
