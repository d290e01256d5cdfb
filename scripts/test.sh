#!/usr/bin/env bash
# Builds everything and passes the tests: the README's second command. It builds where the first one does, so what that
# compiled is not compiled again; the warnings are the same, and errors in both where CI is set (.ci/run sets it).
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
cmake --preset release
cmake --build --preset release
ctest --preset release -j "$(nproc)"
