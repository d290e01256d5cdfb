#!/usr/bin/env bash
# clang-tidy (Debian 12: 14) with the checks of .clang-tidy.
#   scripts/tidy.sh                  every source of src: about a quarter of an hour on two cores
#   scripts/tidy.sh text measurement every source of these rooms
#   scripts/tidy.sh --since REV      every source of src that changed since the commit REV
set -euo pipefail
cd "$(dirname "$0")/.."
if [[ "${1:-}" == --since ]]; then
  mapfile -t sources < <(git diff --name-only --diff-filter=d "$2" -- 'src/*.cpp')
elif (($# > 0)); then
  mapfile -t sources < <(git ls-files "${@/#/src/}" | grep '\.cpp$')
else
  mapfile -t sources < <(git ls-files 'src/*.cpp')
fi
if ((${#sources[@]} == 0)); then
  echo "no source to check"
  exit 0
fi
cmake --preset tidy >/dev/null
echo "${#sources[@]} sources"
printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/tidy --quiet 2>/dev/null
