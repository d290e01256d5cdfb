#!/usr/bin/env python3
"""Reruns one study and compares it with its reference. usage: reference_test.py PATH/TO/coilwright STUDY"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]

# The same design must come out; its figures may differ by what another CPU's rounding does to a step's integration.
RELATIVE = 1e-6


def differences(a, b, where=""):
    if isinstance(a, dict) and isinstance(b, dict):
        for key in a.keys() | b.keys():
            yield from differences(a.get(key), b.get(key), f"{where}/{key}")
    elif isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        for i, (x, y) in enumerate(zip(a, b)):
            yield from differences(x, y, f"{where}/{i}")
    elif isinstance(a, float) or isinstance(b, float):
        if a is None or b is None or not math.isclose(a, b, rel_tol=RELATIVE, abs_tol=1e-9):
            yield f"{where}: {a} was {b}"
    elif a != b:
        yield f"{where}: {a} was {b}"


def main() -> int:
    program, study = sys.argv[1:]
    reference = json.loads((ROOT / "results/reference" / study / "actuator.json").read_text(encoding="utf-8"))
    with tempfile.TemporaryDirectory() as folder:
        config = ROOT / "configs/studies" / f"{study}.json"
        subprocess.run([program, "size", config, "--out", folder, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        found = json.loads(pathlib.Path(folder, "actuator.json").read_text(encoding="utf-8"))
    faults = list(differences(found, reference))
    print("\n".join(faults) if faults else f"{study}: the reference design again")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
