#!/usr/bin/env bash
# Builds Coilwright if it is not built, then runs it with the arguments given: the README's first command.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
"$root/scripts/setup.sh"
program=$root/build/release/bin/coilwright

# What the command needs, and with --report the program that makes pages.
subject=${1:-}
if [[ $subject == help ]]; then subject=${2:-}; fi
case $subject in
  completion | man) targets=(programs) ;;
  *) if grep -q "^COMMAND($subject," "$root/src/cli/commands.def"; then targets=("command_$subject"); else targets=(coilwright); fi ;;
esac
if [[ " $* " == *" --report"* ]]; then targets+=(command_report); fi

(
  cd "$root"
  if [[ ! -x $program ]]; then
    echo "coilwright.sh: compiles first what this command needs: some minutes, once" >&2
  fi
  if ! { cmake --preset release </dev/null >build.log 2>&1 && scripts/build.py "${targets[@]}"; }; then
    cat build.log >&2
    exit 1
  fi
  rm build.log
)
exec "$program" "$@"
