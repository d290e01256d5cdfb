#!/usr/bin/env bash
# Installs a build into a fresh prefix and builds, links and runs users of it. usage: run.sh BUILD_DIR
set -euo pipefail
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix
cmake --install "$build" --prefix "$prefix" >/dev/null

# configure FOLDER BUILD [OPTION...]: a project against the prefix
configure() {
  local folder=$1 build=$work/$2
  shift 2
  cmake -S "$folder" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix" "$@"
}

# refused TEXT COMMAND...: the command must fail, and say that
refused() {
  local text=$1 said
  shift
  if said=$("$@" 2>&1); then
    echo "succeeded, and should not have: $*"
    exit 1
  fi
  # CMake breaks the lines of its messages.
  if ! tr -s '[:space:]' ' ' <<<"$said" | grep -qF "$text"; then
    printf '%s\nfailed as it should, and did not say "%s"\n' "$said" "$text"
    exit 1
  fi
}

echo "== a user of everything"
configure "$here/all" all >/dev/null
cmake --build "$work/all"
"$work/all/user" "$prefix/share/coilwright/actuators/paper_finger.json"
"$prefix/bin/coilwright" --version

echo "== a user of magnetics alone, where nothing that only other components link can be found"
hidden=()
for package in Ceres NLopt TBB nlohmann_json LibCsv Boost; do hidden+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON"); done
configure "$here/magnetics" magnetics "${hidden[@]}" >/dev/null
cmake --build "$work/magnetics"
"$work/magnetics/user"

echo "== a user of a component that links what cannot be found"
refused CMAKE_DISABLE_FIND_PACKAGE_NLopt configure "$here/all" without_nlopt -DCMAKE_DISABLE_FIND_PACKAGE_NLopt=ON

echo "== a user of a component that there is not"
refused 'coilwright has no component "magnetism"; its components are units, algebra, text, magnetics,' \
  configure "$here/unknown" unknown

echo "== the installed examples"
configure "$prefix/share/doc/coilwright/examples" examples >/dev/null
cmake --build "$work/examples" --target example_evaluate_design
ctest --test-dir "$work/examples" -R evaluate_design --output-on-failure

echo "== the components of the documentation"
components=$(sed -n 's/^set(coilwright_components \(.*\))$/\1/p' "$prefix"/lib*/cmake/coilwright/coilwright-config.cmake \
  "$prefix"/lib*/*/cmake/coilwright/coilwright-config.cmake 2>/dev/null || true)
test -n "$components"
for component in $components; do
  grep -q "^|.*\`$component\`.*|.*|.*|$" "$here/../../docs/how_to/use_as_a_library.md" ||
    { echo "docs/how_to/use_as_a_library.md does not know $component"; exit 1; }
done

echo "== what is installed beside the libraries"
for file in share/coilwright/studies/fastest_finger.json share/coilwright/schemas/study.schema.json \
  share/doc/coilwright/LICENSE share/doc/coilwright/docs/formats.md; do
  test -f "$prefix/$file" || { echo "$file is missing"; exit 1; }
done
