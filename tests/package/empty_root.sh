#!/usr/bin/env bash
# Makes the packages of a build and tries each, as a laboratory would, in a Debian that has nothing but what the package
# says it depends on. usage: empty_root.sh BUILD_DIR
set -euo pipefail
build=$(cd "$1" && pwd)
source=$(cd "$(dirname "$0")/../.." && pwd)

left_out() {
  echo "left out: it needs $1"
  exit 77  # shown as skipped
}
for program in mmdebstrap dpkg-shlibdeps; do
  command -v "$program" >/dev/null || left_out "$program (scripts/setup.sh packages)"
done
((EUID == 0)) || left_out "root, to change the root folder"

work=$(mktemp -d)
trap 'rm -rf --one-file-system "$work"' EXIT
root=$work/root

step() { printf '== %s (after %s s)\n' "$1" "$SECONDS"; }
# What is mounted in the root, and what is started there, ends with the command.
inside() { unshare --mount --pid --fork --mount-proc="$root/proc" chroot "$root" /bin/bash -euo pipefail -c "cd /tmp; $1"; }
install() { inside "apt-get install -y -qq --no-install-recommends $* >/tmp/apt.log 2>&1 || { cat /tmp/apt.log; exit 1; }"; }

step "an empty root"
# shellcheck source=/dev/null
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
mmdebstrap --variant=apt --quiet --dpkgopt=force-unsafe-io "$release" "$root" 2>"$work/mmdebstrap.log" ||
  left_out "the packages of Debian \"$release\": $(tail -n 1 "$work/mmdebstrap.log")"
inside "apt-get update -qq"

step "the packages"
cpack --config "$build/CPackConfig.cmake" -B "$work/packages" >"$work/cpack.log" || { cat "$work/cpack.log"; exit 1; }
mv "$work"/packages/*.deb "$root/tmp"

step "programs, and pages of what they found"
install "./coilwright_*.deb"
inside '
  coilwright evaluate /usr/share/coilwright/actuators/paper_finger.json --current-A 1.4 | grep "steady_angle_deg *63.6"
  coilwright init study --out study
  coilwright size study/study.json --out sized --report | grep "^peak_bending_speed_deg_s"
  coilwright init dataset --out records
  coilwright diagnose records --out diagnosed --report --quiet | grep "The declared model lacks dry_friction"
  for page in sized diagnosed; do grep -q vega-embed $page/report.html; done
  coilwright export sized/actuator.json --as workshop --out built
  test -s /usr/share/man/man1/coilwright-size.1
  source /usr/share/bash-completion/completions/coilwright
  complete -p coilwright'

wheels=("$build"/python/coilwright/_core.*.so)
if [[ -e ${wheels[0]} ]]; then
  step "the wheel"
  /usr/bin/python3 -c 'import pathlib, sys; sys.path.insert(0, sys.argv[1]); import build_backend
build_backend.wheel_of(pathlib.Path(sys.argv[2]), sys.argv[3])' \
    "$source/src/python" "$build/python/coilwright" "$root/tmp"
  install python3-numpy python3-venv
  inside '
    python3 -m venv --system-site-packages venv
    venv/bin/pip install --quiet --no-index coilwright-*.whl
    ln -s /usr/share/coilwright configs
    venv/bin/python -W ignore /usr/share/doc/coilwright/examples/python/first_design.py
    library=$(echo /usr/lib/*/libnlopt.so.0)
    mv "$library" .
    { venv/bin/python -c "import coilwright" 2>&1 || true; } | grep "the Debian package coilwright brings the libraries"
    mv libnlopt.so.0 "$library"'
else
  echo "left out: the wheel, which this build has not (scripts/setup.sh python)"
fi

if compgen -G "$root/tmp/coilwright-films_*.deb" >/dev/null; then
  step "what reads films"
  install "./coilwright-films_*.deb"
  inside '
    echo no film >film.mp4
    { coilwright lens film.mp4 --out lens.json 2>&1 || true; } | tee said
    if grep -q "OpenCV, which is not here" said; then exit 1; fi'
fi

step "the library"
install "./coilwright-dev_*.deb" g++ cmake ninja-build
cp -r "$source/tests/package/all" "$root/tmp/user"
inside '
  cmake -S user -B user/build -G Ninja -DCMAKE_BUILD_TYPE=Release
  cmake --build user/build
  user/build/user /usr/share/coilwright/actuators/paper_finger.json'
step "done"
