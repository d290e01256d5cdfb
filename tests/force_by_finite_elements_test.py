#!/usr/bin/env python3
"""The study of forces by finite elements finds its reference's answer again. usage: .._test.py PATH/TO/coilwright

Ends with 77, which ctest shows as skipped, where gmsh or getdp is not installed.
"""

import math
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
STUDY = "force_by_finite_elements"

# Another gmsh may mesh otherwise: what the mesh of the answer leaves is 0.01 % (stress: column `stress` of the ladder).
RELATIVE = 3e-4


def rows_of(text: str) -> dict[str, list[float]]:
    """The first columns of the answer, by the name of the row: paper, coilwright and the routes, N."""
    rows = {}
    for line in text.splitlines()[2:5]:
        name, numbers = line[:27].strip(), line[27:].split()
        rows[name] = [float(word) for word in numbers[:5] if re.fullmatch(r"[\d.]+", word)]
    return rows


def main() -> int:
    (program,) = sys.argv[1:]
    if missing := [tool for tool in ("gmsh", "getdp") if shutil.which(tool) is None]:
        print(f"skipped: {' and '.join(missing)} not installed")
        return 77
    script = ROOT / "studies" / STUDY / "force.py"
    done = subprocess.run([sys.executable, "-B", script, program, "--quick"], capture_output=True, text=True)
    found = rows_of(done.stdout)
    expected = rows_of((ROOT / "results/reference" / STUDY / "summary.txt").read_text(encoding="utf-8"))
    faults = [done.stderr.strip()] if done.returncode != 0 else []
    if found.keys() != expected.keys() or len(expected) != 3:
        faults.append(f"rows {list(found)} were {list(expected)}")
    else:
        faults += [f"{name}: {found[name]} was {numbers}" for name, numbers in expected.items()
                   if len(found[name]) != len(numbers)
                   or not all(math.isclose(a, b, rel_tol=RELATIVE) for a, b in zip(found[name], numbers))]
    print("\n".join(faults) if faults else f"{STUDY}: the reference answer again")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
