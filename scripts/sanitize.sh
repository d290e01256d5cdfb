#!/usr/bin/env bash
# Unit tests under the sanitizers, and the readers under the fuzzers. Any error ends the script.
#   scripts/sanitize.sh        everything: an hour and a half on two cores; before a release
#   scripts/sanitize.sh GROUP  one row of the table below: at most 25 minutes
#   scripts/sanitize.sh turn   the group whose turn it is at this commit: .ci/run calls it, and eight commits reach all
set -euo pipefail
cd "$(dirname "$0")/.."

# The programs of tests that a group builds and runs. What takes data from outside has the fuzzers too.
declare -A programs=(
  [readers]="units_tests text_tests formats_tests formats_actuator_tests formats_simulation_tests formats_data_tests formats_study_tests fuzzers"
  [physics]="algebra_tests magnetics_tests winding_tests drive_tests mechanics_tests thermal_tests"
  [actuator]="actuator_tests simulation_tests control_tests"
  [systems]="systems_tests truth_tests exports_tests video_tests"
  [sizing]="sizing_tests archive_tests"
  [measurement]="measurement_tests experiment_tests attribution_tests"
  [pages]="report_tests report_simulation_tests page_tests results_tests cli_tests"
)
groups=(readers physics actuator systems sizing measurement pages threads)  # threads: search and fit, another sanitizer

# Whole diagnoses would take hours, and run what the others run.
for program in $(grep -rhoP 'coilwright_test\(\K\w+' tests --include=CMakeLists.txt); do
  if [[ $program != diagnosis_tests && " ${programs[*]} " != *" $program "* ]]; then
    echo "sanitize.sh: $program is in no group" >&2
    exit 1
  fi
done

# In one of eight rounds of turns each file has only what it includes itself: precompiled headers hide what is missing.
precompiled=ON
address() {
  cmake --preset asan-ubsan -DCOILWRIGHT_PCH="$precompiled" >/dev/null
  cmake --build --preset asan-ubsan --target "$@"
  # Left out: minutes under the sanitizer of what other tests reach too. A program that is not built has no label.
  ctest --preset asan-ubsan -j "$(nproc)" -L unit -E 'OfAnyDesign|ThickOil|LaboratorySet|NamesTheConfounders'
  if [[ " $* " == *" fuzzers "* ]]; then scripts/fuzz.sh 5; fi
}

threads() {
  cmake --preset tsan >/dev/null
  cmake --build --preset tsan --target sizing_tests measurement_tests
  ctest --preset tsan -j 1 -R 'Thread|Interrupt|^Fit\.'
}

group=${1:-all}
if [[ $group == turn ]]; then
  commits=$(git rev-list --count HEAD)
  group=${groups[commits % ${#groups[@]}]}
  if ((commits / ${#groups[@]} % 8 == 0)); then precompiled=OFF; fi
  echo "At commit $commits it is the turn of $group."
fi
if [[ $group == all ]]; then
  read -ra all <<<"${programs[*]}"
  address "${all[@]}"
  threads
elif [[ $group == threads ]]; then
  threads
elif [[ -n ${programs[$group]:-} ]]; then
  read -ra some <<<"${programs[$group]}"
  address "${some[@]}"
else
  echo "sanitize.sh: must be turn, one of ${groups[*]}, or nothing; got \"$group\"" >&2
  exit 2
fi
