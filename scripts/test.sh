#!/usr/bin/env bash
# Builds everything with warnings as errors and passes the tests: the README's second command.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset ci
cmake --build --preset ci
ctest --preset ci -j "$(nproc)"
