#!/usr/bin/env python3
"""Sweeps a million designs and prints the time and the peak memory. usage: sweep_memory.py PATH/TO/coilwright"""

import pathlib
import resource
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
STUDY = ROOT / "configs/studies/million.json"


def main() -> int:
    with tempfile.TemporaryDirectory() as folder:
        start = time.monotonic()
        subprocess.run([sys.argv[1], "sweep", STUDY, "--out", folder, "--quiet"], check=True, stdout=subprocess.DEVNULL)
        seconds = time.monotonic() - start
        with open(pathlib.Path(folder, "designs.csv"), encoding="utf-8") as table:
            rows = sum(1 for _ in table) - 1
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(f"{rows} designs in {seconds:.0f} s, {rows / seconds:.0f} a second, peak memory {peak:.0f} MB (asked for: 200)")
    return 0 if rows >= 1_000_000 and peak < 200 else 1


if __name__ == "__main__":
    sys.exit(main())
