#!/usr/bin/env bash
# Makes the packages by which others install Coilwright without a compiler: build/packages/*.deb of the programs and the
# library, and a wheel of the Python package where scripts/setup.sh python has been run. They run on this release of
# Debian and on this kind of processor.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh
if ! command -v dpkg-shlibdeps >/dev/null; then
  echo "package.sh: dpkg-shlibdeps is not installed, which finds what a package depends on: apt-get install dpkg-dev" >&2
  exit 1
fi
cmake --preset release
cmake --build --preset release
rm -rf build/packages
cpack --config build/release/CPackConfig.cmake -B build/packages
rm -rf build/packages/_CPack_Packages
if /usr/bin/python3 -c 'import pip, pybind11' 2>/dev/null || dpkg-query -W pybind11-dev >/dev/null 2>&1; then
  /usr/bin/python3 -m pip wheel --quiet --no-deps --no-build-isolation --wheel-dir build/packages .
else
  echo "package.sh: without a wheel: scripts/setup.sh python installs what it needs" >&2
fi
ls -l build/packages
