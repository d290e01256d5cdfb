"""One field by finite elements: pair.geo through gmsh, pair.pro through GetDP, and the forces that come out.

Lengths in mm, as in pair.geo; currents in A, forces in N, flux linkages in Wb. Forces on a body are positive along +z,
which runs from the first coil to the magnet and on to the second coil.
"""

import dataclasses
import pathlib
import re
import shutil
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
TOOLS = ("gmsh", "getdp")
INSTALL = "on Debian: apt-get install gmsh getdp"

# The order in which pair.pro prints them
NUMBERS = ("lorentz_coil", "lorentz_second", "stress_magnet", "stress_iron", "linkage_coil", "linkage_second")


def missing_tools() -> list[str]:
    return [tool for tool in TOOLS if shutil.which(tool) is None]


@dataclasses.dataclass(frozen=True)
class Iron:
    """A ring of soft iron about the axis, a plate where its inner radius is 0; mm."""

    inner: float
    outer: float
    low: float
    high: float
    permeability: float = 1000


@dataclasses.dataclass(frozen=True)
class Case:
    """The paper's coil and magnet, and what a row of a table changes of them."""

    gap: float = 0.9
    remanence: float = 1.44
    recoil: float = 1.0
    current: float = -1.4  # against the magnet: it repels, as in the paper
    second_current: float = 0.0
    second_coil: bool = True
    iron: Iron | None = None
    fineness: float = 1.0
    order: int = 2
    far: float = 90.0
    outside: float = 130.0
    to_infinity: bool = True

    def geometry(self) -> dict:
        """What the mesh depends on; mm."""
        numbers = {"gap": self.gap, "fineness": self.fineness, "far": self.far, "outside": self.outside,
                   "second_coil": int(self.second_coil)}
        if self.iron is not None:
            numbers |= {"iron_inner": self.iron.inner, "iron_outer": self.iron.outer, "iron_low": self.iron.low,
                        "iron_high": self.iron.high}
        return numbers

    def physics(self) -> dict:
        """What the field depends on besides; SI."""
        return {"remanence": self.remanence, "recoil": self.recoil, "current": self.current,
                "second_current": self.second_current, "order": self.order, "far": self.far / 1000,
                "outside": self.outside / 1000, "to_infinity": int(self.to_infinity),
                "has_second": int(self.second_coil), "has_iron": int(self.iron is not None),
                "iron_permeability": self.iron.permeability if self.iron else 1}


def call(tool: str, *arguments) -> str:
    done = subprocess.run([tool, *map(str, arguments)], capture_output=True, text=True)
    said = done.stdout + done.stderr
    # Neither tool may be trusted to end with a code other than 0 when it stops at an error.
    if done.returncode != 0 or re.search(r"^Error", said, re.MULTILINE):
        faults = re.findall(r"^Error.*", said, re.MULTILINE) or [said.strip()[-300:]]
        raise RuntimeError(f"{tool}: {faults[0]}")
    return said


def settings(numbers: dict) -> list:
    return [word for key, value in numbers.items() for word in ("-setnumber", key, repr(value))]


def solve(case: Case, folder: pathlib.Path) -> dict:
    """NUMBERS of one case on the mesh in `folder`, `unknowns`, and with iron the largest flux density in it, `iron_T`."""
    said = call("getdp", folder / "pair.pro", "-msh", folder / "pair.msh", "-solve", "Solve", "-v", 3,
                *settings(case.physics()), "-setstring", "folder", f"{folder}/")
    lines = (folder / "forces.txt").read_text(encoding="utf-8").splitlines()
    found = dict(zip(NUMBERS, (float(line.split()[1]) for line in lines), strict=True))
    found["unknowns"] = int(re.search(r"(\d+) Dofs", said).group(1))
    if case.iron is not None:
        rows = (folder / "iron.txt").read_text(encoding="utf-8").splitlines()
        found["iron_T"] = max(float(row.split()[-1]) for row in rows)
    return found


def fields_on_one_mesh(cases: list[Case]) -> list[dict]:
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        call("gmsh", "-2", "-v", 2, "-format", "msh22", *settings(cases[0].geometry()), "-o", folder / "pair.msh",
             HERE / "pair.geo")
        shutil.copy(HERE / "pair.pro", folder)  # GetDP writes its files beside it
        return [solve(case, folder) for case in cases]


def fields_of(cases: list[Case]) -> list[dict]:
    """The answers of several cases, in their order: each mesh made once, two meshes at a time."""
    groups: dict[str, list[int]] = {}
    for i, case in enumerate(cases):
        groups.setdefault(repr(case.geometry()), []).append(i)
    with ThreadPoolExecutor(2) as pool:
        found = pool.map(fields_on_one_mesh, ([cases[i] for i in group] for group in groups.values()))
        answers = {i: field for group, fields in zip(groups.values(), found) for i, field in zip(group, fields)}
    return [answers[i] for i in range(len(cases))]
