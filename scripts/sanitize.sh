#!/usr/bin/env bash
# Unit tests under the sanitizers, and the readers under the fuzzers. Any error ends the script.
#   scripts/sanitize.sh          everything, threads included: an hour on two cores; before a release
#   scripts/sanitize.sh readers  whatever takes data from outside, and the physics: a quarter of an hour; .ci/run calls it
#   scripts/sanitize.sh physics  text and the physics without files, no fuzzers: some minutes
#   scripts/sanitize.sh threads  search and fit under the thread sanitizer
set -euo pipefail
cd "$(dirname "$0")/.."
what=${1:-all}
case $what in
  all | readers | physics | threads) ;;
  *) echo "sanitize.sh: must be readers, physics, threads or nothing; got \"$what\"" >&2; exit 2 ;;
esac

if [[ $what != threads ]]; then
  physics=(units_tests text_tests magnetics_tests winding_tests mechanics_tests thermal_tests)
  targets=()
  case $what in
    physics) targets=("${physics[@]}") ;;
    readers) targets=("${physics[@]}" formats_tests formats_actuator_tests formats_simulation_tests formats_data_tests
                      formats_study_tests fuzzers) ;;
  esac
  cmake --preset asan-ubsan >/dev/null
  cmake --build --preset asan-ubsan ${targets:+--target "${targets[@]}"}
  # Left out: minutes under the sanitizer of what other tests reach too. A program that is not built has no label.
  ctest --preset asan-ubsan -j "$(nproc)" -L unit -E 'OfAnyDesign|ThickOil|LaboratorySet|NamesTheConfounders'
  case $what in
    all) scripts/fuzz.sh 10 ;;
    readers) scripts/fuzz.sh 5 ;;
  esac
fi
if [[ $what == all || $what == threads ]]; then
  cmake --preset tsan >/dev/null
  cmake --build --preset tsan --target sizing_tests measurement_tests
  ctest --preset tsan -j 1 -R 'Thread|Interrupt|^Fit\.'
fi
