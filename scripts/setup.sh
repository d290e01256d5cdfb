#!/usr/bin/env bash
# Installs what building and testing Coilwright needs on Debian 12. Idempotent: does nothing when all is there.
#   scripts/setup.sh [SET..]   also these: films, OpenCV, by which `coilwright track` reads films; python, what the Python
#                              package needs; packages, what makes packages (scripts/package.sh) and tries them; ci, all of
#                              these and what only the extra checks of continuous integration need
set -euo pipefail

packages=(
  g++ cmake ninja-build git pkg-config python3
  libnlopt-dev libeigen3-dev libboost-dev nlohmann-json3-dev libtbb-dev
  libceres-dev libfmt-dev libcli11-dev libcsv-dev libhwy-dev libmuparser-dev libpugixml-dev libsqlitecpp-dev libssl-dev
  libcpp-httplib-dev
  libgtest-dev libgmock-dev libbenchmark-dev python3-jsonschema
)
films=(libopencv-contrib-dev libopencv-videoio-dev libopencv-calib3d-dev)
python=(pybind11-dev python3-dev python3-numpy python3-pip python3-venv)
makers=(dpkg-dev mmdebstrap)
checks=(python3-pytest python3-matplotlib python3-pandas mypy clang clang-format clang-tidy doxygen libmujoco-dev
        liburdfdom-tools lua5.4 openscad gmsh getdp chromium python3-openturns strace coop-computing-tools ffmpeg)
for set in "$@"; do
  case $set in
    films) packages+=("${films[@]}") ;;
    python) packages+=("${python[@]}") ;;
    packages) packages+=("${makers[@]}") ;;
    ci) packages+=("${films[@]}" "${python[@]}" "${makers[@]}" "${checks[@]}") ;;
    *) echo "setup.sh: must be films, python, packages or ci; got \"$set\"" >&2; exit 2 ;;
  esac
done

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
# Of what apt says on its first output: its steps in percent, first those of fetching, then those of installing. At a
# terminal one line that is written over, elsewhere a line a minute.
progress() {
  awk -F: -v terminal="$(test -t 2 && echo 1)" '
    /^(dl|pm)status:/ {
      text = sprintf("setup.sh: %d %% of the packages %s", $3, $1 == "dlstatus" ? "fetched" : "installed")
      if (terminal) printf "\r%s\033[K", text
      else if (systime() - told >= 60) { print text; told = systime() }
      fflush()
    }
    END { if (terminal) printf "\r\033[K" }' >&2
}
echo "Installing: ${missing[*]}" >&2
"${as_root[@]}" apt-get update -qq >&2
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends -o APT::Status-Fd=1 \
  "${missing[@]}" | progress
