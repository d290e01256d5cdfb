#!/usr/bin/env bash
# Every C++ file is as clang-format (Debian 12: 14) would write it.
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files '*.cpp' '*.hpp' | xargs -r clang-format --dry-run -Werror
