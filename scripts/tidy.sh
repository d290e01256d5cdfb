#!/usr/bin/env bash
# clang-tidy (Debian 12: 14) with the checks of .clang-tidy.
#   scripts/tidy.sh                             every source of src: about a quarter of an hour on two cores
#   scripts/tidy.sh text measurement            every source of these rooms
#   scripts/tidy.sh [text ..] --since REV       these, and every source of src that changed since the commit REV
set -euo pipefail
cd "$(dirname "$0")/.."
paths=() since=
while (($# > 0)); do
  if [[ $1 == --since ]]; then
    since=$2
    shift
  else
    paths+=("src/$1")
  fi
  shift
done
if ((${#paths[@]} == 0)) && [[ -z $since ]]; then paths=(src); fi
mapfile -t sources < <({
  if ((${#paths[@]} > 0)); then git ls-files "${paths[@]}"; fi
  if [[ -n $since ]]; then git diff --name-only --diff-filter=d "$since" -- src; fi
} | grep '\.cpp$' | sort -u)
if ((${#sources[@]} == 0)); then
  echo "no source to check"
  exit 0
fi
cmake --preset tidy >/dev/null
echo "${#sources[@]} sources"
printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/tidy --quiet 2>/dev/null
