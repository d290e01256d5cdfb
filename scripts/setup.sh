#!/usr/bin/env bash
# Installs what building and testing Coilwright needs on Debian 12. Idempotent: does nothing when all is there.
# `scripts/setup.sh films` adds OpenCV, by which `coilwright track` reads films; `scripts/setup.sh python` what the Python
# package needs; `scripts/setup.sh ci` both and what only the extra checks of continuous integration need.
set -euo pipefail

packages=(
  g++ cmake ninja-build git python3
  libnlopt-dev libeigen3-dev libboost-dev nlohmann-json3-dev libtbb-dev
  libceres-dev libfmt-dev libcli11-dev libcsv-dev libhwy-dev libmuparser-dev libpugixml-dev libsqlitecpp-dev libssl-dev
  libgtest-dev libgmock-dev libbenchmark-dev python3-jsonschema
)
python=(pybind11-dev python3-dev python3-numpy python3-pip python3-venv)
if [[ "${1:-}" == python || "${1:-}" == ci ]]; then
  packages+=("${python[@]}")
fi
if [[ "${1:-}" == films || "${1:-}" == ci ]]; then
  packages+=(libopencv-contrib-dev libopencv-videoio-dev libopencv-calib3d-dev)
fi
if [[ "${1:-}" == ci ]]; then
  packages+=(python3-pytest python3-matplotlib python3-pandas mypy clang clang-format clang-tidy doxygen libmujoco-dev
             liburdfdom-tools lua5.4 openscad gmsh getdp chromium python3-openturns strace coop-computing-tools ffmpeg)
fi

missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed' || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  as_root=(sudo)
fi
echo "Installing: ${missing[*]}" >&2
"${as_root[@]}" apt-get update -qq >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
