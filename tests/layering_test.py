#!/usr/bin/env python3
"""Checks that every room includes only what stands above it, that the folders of a room do, and that third-party
libraries stay in their places."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What each room may include, besides itself. The same as the CMake link lists, written out so that neither can drift.
PHYSICS = {"magnetics", "winding", "mechanics", "thermal"}
ALLOWED = {
    "units": set(),
    "text": {"units"},
    "magnetics": set(),
    "winding": set(),
    "mechanics": set(),
    "thermal": set(),
    "actuator": PHYSICS,
    "simulation": PHYSICS | {"actuator"},
    "systems": PHYSICS | {"actuator", "simulation"},
    "sizing": PHYSICS | {"actuator", "simulation"},
    "measurement": PHYSICS | {"actuator", "simulation"},
    "formats": PHYSICS | {"units", "text", "actuator", "simulation", "sizing", "measurement"},
    "report": PHYSICS | {"units", "text", "actuator", "simulation", "sizing", "measurement", "formats"},
    "cli": PHYSICS | {"units", "text", "actuator", "simulation", "systems", "sizing", "measurement", "formats", "report"},
}

# Folders inside a room, in the order of its method: each includes only those before it, and what lies in the room itself
# stands on top of all of them. A folder's public headers and its sources are one.
FOLDERS = {
    "measurement": ["data", "noise", "whiteness", "replay", "fit", "compare", "localise", "experiment"],
}

# Libraries that only the .cpp files of the named rooms may see (a private header of such a room counts as its source).
HIDDEN = {
    "nlopt": {"sizing"},
    "tbb/": {"sizing", "measurement"},
    "oneapi/": {"sizing", "measurement"},
    "ceres/": {"measurement"},
    "nlohmann/": {"text"},
    "csv.h": {"text"},
    "CLI/": {"cli"},
    "glog/": {"cli"},
    "hwy/": {"magnetics"},
    "boost/": {"magnetics", "winding", "thermal", "actuator", "simulation", "sizing", "measurement", "formats"},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def upward_includes(path: pathlib.Path, room: str, base: pathlib.Path) -> list[str]:
    """The includes of a file of a room with folders that reach a folder after its own."""
    folders = FOLDERS[room]

    def place(inside_room: str) -> int:
        """How far up a file stands; past the last folder where it lies in the room itself."""
        folder = pathlib.PurePosixPath(inside_room).parent.as_posix()
        return len(folders) if folder == "." else folders.index(folder)

    own = path.relative_to(base).as_posix()
    if "/" in own and own.rpartition("/")[0] not in folders:
        return [f"{path.relative_to(ROOT)}: its folder is not in the order of {room}"]
    found = []
    for target in INCLUDE.findall(path.read_text(encoding="utf-8")):
        if match := re.match(rf"(?:coilwright/)?{room}/(.+)", target):
            if place(match.group(1)) > place(own):
                found.append(f"{path.relative_to(ROOT)}: includes {target}, which stands further up")
    return found


def faults_of(path: pathlib.Path, room: str, public: bool) -> list[str]:
    found = []
    for target in INCLUDE.findall(path.read_text(encoding="utf-8")):
        where = f"{path.relative_to(ROOT)}: includes {target}"
        if match := re.match(r"coilwright/([a-z]+)/", target):
            other = match.group(1)
            if other != room and other not in ALLOWED[room]:
                found.append(f"{where}: {room} stands above {other}")
        for prefix, rooms in HIDDEN.items():
            if target.startswith(prefix) and (public or room not in rooms):
                found.append(f"{where}: only the sources of {', '.join(sorted(rooms))} may")
    return found


def main() -> int:
    faults, files = [], 0
    for room in ALLOWED:
        for base, public in ((ROOT / "include/coilwright" / room, True), (ROOT / "src" / room, False)):
            for path in sorted(base.rglob("*.?pp")):
                files += 1
                faults += faults_of(path, room, public)
                if room in FOLDERS:
                    faults += upward_includes(path, room, base)
    # What makes test data must not share a line with what they test; only its tests may see both.
    for path in sorted((ROOT / "tests/truth").glob("*.?pp")):
        files += 1
        if not path.name.endswith("_test.cpp") and "coilwright/" in path.read_text(encoding="utf-8"):
            faults.append(f"{path.relative_to(ROOT)}: the source of truth knows of the code under test")
    known = {path.name for path in (ROOT / "src").iterdir() if path.is_dir()}
    faults += [f"src/{room}: is not in the order of the house" for room in sorted(known - set(ALLOWED))]
    print("\n".join(faults) if faults else f"{files} files keep to the order of the house")
    return 1 if faults or files == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
