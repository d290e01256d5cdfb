#!/usr/bin/env python3
"""Checks that every layer includes only what stands below it, and that third-party libraries stay in their places."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What each room may include directly; what that may include comes along. The same as the CMake link lists, written out
# so that neither can drift. `formats` and `report` are several libraries, each a layer of its own.
ROOMS = {
    "units": "",
    "algebra": "",
    "text": "units",
    "magnetics": "",
    "winding": "",
    "drive": "",
    "mechanics": "algebra",
    "thermal": "algebra",
    "actuator": "units magnetics winding drive mechanics thermal",
    "simulation": "actuator",
    "control": "simulation",
    "systems": "simulation",
    "sizing": "simulation",
    "archive": "text sizing",
    "measurement": "algebra simulation",
    "video": "text",
    "video/opencv": "video",
    "video/records": "video measurement",
    "formats/actuator": "text actuator",
    "formats/simulation": "text control",
    "formats/systems": "text systems",
    "formats/data": "formats/actuator formats/simulation measurement systems",
    "formats/film": "video/records formats/data",
    "formats/study": "formats/actuator formats/simulation archive formats/systems",
    "exports": "formats/actuator control",
    "report/simulation": "text control",
    "report/systems": "report/simulation formats/actuator systems",
    "report": "report/simulation formats/study",
    "report/diagnosis": "report formats/data",
    "page": "exports report formats/study",
    "results": "text",
    "results/diagnosis": "results report/diagnosis",
    "results/page": "results page",
    "cli": "results formats/actuator simulation",
    "cli/front": "cli formats/data",
    "cli/model": "cli control exports formats/simulation formats/systems report/systems",
    "cli/runs": "cli formats/study",
    "cli/search": "cli/front cli/runs report",
    "cli/records": "cli/front cli/runs report/systems results/diagnosis",
    "cli/parts": "cli/search cli/records exports",
    "cli/film": "cli/runs formats/data formats/film",
    "cli/page": "cli/model cli/runs results/page",
    "cli/export": "cli exports",
    "cli/bench": "cli/search cli/model results/diagnosis results/page",
    "cli/programs": "cli",
    "python": "results/diagnosis results/page report/systems formats/systems formats/film",
}

# Folders inside a room, in the order of its method: each includes only those before it, and what lies in the room itself
# stands on top of all of them. A folder's public headers and its sources are one.
FOLDERS = {
    "sizing": "problem sampling nlopt surrogate search study",
    "actuator": "parts model effects design",
    "measurement": "data signals replay fit records identification localise correction planning",
}

# Libraries that only the .cpp files of the named layers, or rooms with all their layers, may see (a private header
# counts as its source).
HIDDEN = {
    "nlopt": "sizing control",
    "muParser": "sizing",
    "pugixml": "exports",
    "SQLiteCpp/": "archive",
    "tbb/": "sizing measurement/fit",
    "oneapi/": "sizing measurement",
    "ceres/": "measurement/fit",
    "nlohmann/": "text",
    "csv.h": "text",
    "CLI/": "cli",
    "httplib.h": "cli/bench",
    "pybind11/": "python",
    "glog/": "cli python",
    "openssl/": "results",
    "hwy/": "magnetics",
    "opencv2/": "video/opencv",
    "dlfcn.h": "video",
    "boost/": "magnetics winding thermal actuator simulation control sizing archive measurement",
}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def layers() -> dict[str, set[str]]:
    """All that each room, and each folder of one, may include besides itself."""
    allowed: dict[str, set[str]] = {}

    def add(layer: str, directly: list[str]) -> None:
        allowed[layer] = set(directly).union(*(allowed[each] for each in directly))

    for room, directly in ROOMS.items():
        lower = directly.split()
        for folder in FOLDERS.get(room, "").split():
            add(f"{room}/{folder}", lower)
            lower = [f"{room}/{folder}"]
        add(room, lower)
    return allowed


ALLOWED = layers()


def layer_of(path: str) -> str | None:
    """The layer of "formats/data/run_file.cpp": its folder or, where a room has no order inside, the room."""
    folder = path.rpartition("/")[0]
    while folder and folder not in ALLOWED:
        folder = folder.rpartition("/")[0]
        if folder in FOLDERS:
            return None
    return folder or None


def faults_of(path: pathlib.Path, base: pathlib.Path) -> list[str]:
    inside = path.relative_to(base).as_posix()
    layer, public = layer_of(inside), base.name == "coilwright"
    if layer is None:
        return [f"{path.relative_to(ROOT)}: its folder is in no order"]
    found = []
    for target in INCLUDE.findall(path.read_text(encoding="utf-8")):
        where = f"{path.relative_to(ROOT)}: includes {target}"
        private = (ROOT / "src" / target).is_file()
        if target.startswith("coilwright/") or private:
            other = layer_of(target.removeprefix("coilwright/"))
            if other != layer and other not in ALLOWED[layer]:
                found.append(f"{where}: {other} does not stand below {layer}")
            if private and (public or target.split("/")[0] != inside.split("/")[0]):
                found.append(f"{where}: is private to its room")
        for prefix, users in HIDDEN.items():
            if target.startswith(prefix) and (public or not {layer, layer.split("/")[0]} & set(users.split())):
                found.append(f"{where}: only the sources of {', '.join(users.split())} may")
    return found


def main() -> int:
    faults, files = [], 0
    for base in (ROOT / "include/coilwright", ROOT / "src"):
        for path in sorted(base.rglob("*.?pp")):
            files += 1
            faults += faults_of(path, base)
    # What makes test data must not share a line with what they test; only its tests may see both.
    for path in sorted((ROOT / "tests/truth").glob("*.?pp")):
        files += 1
        if not path.name.endswith("_test.cpp") and "coilwright/" in path.read_text(encoding="utf-8"):
            faults.append(f"{path.relative_to(ROOT)}: the source of truth knows of the code under test")
    print("\n".join(faults) if faults else f"{files} files include only what stands below them")
    return 1 if faults or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
