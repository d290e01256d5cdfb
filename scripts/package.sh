#!/usr/bin/env bash
# Makes the packages by which others install Coilwright without a compiler, in build/packages: Debian packages of the
# programs, of the library and of what reads films, and a wheel of the Python package. They run on this release of Debian
# and on this kind of processor; the test packages_in_an_empty_root tries each.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh films python packages
if ! { cmake --preset release >build.log 2>&1 && scripts/build.py installable; }; then
  cat build.log >&2
  exit 1
fi
rm build.log
if [[ ! -e build/release/report_assets/packed/stamp.txt ]]; then
  echo "package.sh: pages of these packages could not draw charts: npm (Debian's package npm) fetches what draws them" >&2
  exit 1
fi
rm -rf build/packages
cpack --config build/release/CPackConfig.cmake -B build/packages
rm -rf build/packages/_CPack_Packages
/usr/bin/python3 -m pip wheel --quiet --no-deps --no-build-isolation --wheel-dir build/packages .
ls -l build/packages
