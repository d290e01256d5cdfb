#!/usr/bin/env bash
# Builds and passes the tests: the README's second command.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release -DCOILWRIGHT_WERROR=ON
cmake --build --preset release
ctest --preset release -j "$(nproc)"
