#!/usr/bin/env bash
# Builds Coilwright if it is not built, then runs it with the arguments given: the README's first command.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
"$root/scripts/setup.sh"
program=$root/build/release/bin/coilwright

# Says how far ninja is, by its own count: in one line that is written over at a terminal, in a line a minute elsewhere.
# Silent where nothing is to be built.
progress() {
  local line last=$SECONDS terminal= shown=
  if [[ -t 2 ]]; then terminal=1; fi
  while IFS= read -r line; do
    if [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]]; then
      if [[ -n $terminal ]]; then
        printf '\rcoilwright.sh: step %s of %s\033[K' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" >&2
        shown=1
      elif ((SECONDS - last >= 60)); then
        printf 'coilwright.sh: step %s of %s after %s s\n' "${BASH_REMATCH[1]}" "${BASH_REMATCH[2]}" "$SECONDS" >&2
        last=$SECONDS
      fi
    fi
  done
  if [[ -n $shown ]]; then printf '\r\033[K' >&2; fi
}

(
  cd "$root"
  if [[ ! -x $program ]]; then
    echo "coilwright.sh: builds the program first, once: about ten minutes on two cores" >&2
  fi
  if ! { cmake --preset release && cmake --build --preset release --target coilwright; } </dev/null 2>&1 |
    tee build.log | progress; then
    cat build.log >&2
    exit 1
  fi
  rm build.log
)
exec "$program" "$@"
