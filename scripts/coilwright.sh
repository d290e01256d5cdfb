#!/usr/bin/env bash
# Builds Coilwright if it is not built, then runs it with the arguments given: the README's first command.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
"$root/scripts/setup.sh"
(
  cd "$root"
  if ! { cmake --preset release && cmake --build --preset release --target coilwright; } >build.log 2>&1; then
    cat build.log >&2
    exit 1
  fi
  rm build.log
)
exec "$root/build/release/bin/coilwright" "$@"
