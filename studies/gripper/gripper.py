#!/usr/bin/env python3
"""Which friction do the objects that the paper's gripper lifted imply?

Usage: gripper.py [PROGRAM [FOLDER]]: the built program (default build/release/bin/coilwright); with FOLDER the table is
also written there as gripper.csv. The paper gives neither the size of its objects nor how far apart its fingers are, so
all places of a grid are tried and the one that needs the least friction is shown.
"""

import concurrent.futures
import csv
import json
import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FINGER = ROOT / "configs/actuators/paper_finger.json"

# Name, mass in g, current in A (the paper's; section V.A), shape, widths in mm that such an object may have.
OBJECTS = (
    ("onion", 93, 1.4, "sphere", (55, 65, 75)),
    ("lemon", 115, 0.55, "sphere", (50, 55, 60)),
    ("glass", 203, 1.4, "cylinder", (60, 70, 80)),
)
OPEN_CURRENT = -1.4  # A, before the grasp: the fingers open by negative current (Fig. 8b)
SPACING_MINUS_WIDTH = range(-25, 16, 5)  # mm
BELOW_PALM = range(6, 31, 4)  # mm
MOST_FRICTION = 3.0
COLUMNS = ("object", "mass_g", "current_A", "width_mm", "least_friction", "spacing_mm", "centre_below_palm_mm",
           "normal_N", "bending_deg")


def least_friction(program, mass, current, shape, width, spacing, below):
    """The least coefficient that holds the object there, and the grasp at twice that; None where nothing does."""
    call = [program, "grip", FINGER, "--shape", shape, "--width-mm", width, "--mass-g", mass, "--current-A", current,
            "--open-current-A", OPEN_CURRENT, "--spacing-mm", spacing, "--centre-below-palm-mm", below, "--json"]
    first = subprocess.run([*map(str, call), "--friction", str(MOST_FRICTION), "--least-friction-up-to",
                            str(MOST_FRICTION)], capture_output=True, text=True, check=False)
    if first.returncode == 2:  # the open fingers touch it there
        return None
    first.check_returncode()
    least = json.loads(first.stdout)["least_friction"]
    if least is None:
        return None
    there = subprocess.run([*map(str, call), "--friction", f"{1.02 * least:.6g}"], capture_output=True, text=True, check=True)
    grasp = json.loads(there.stdout)
    normal = sum(each["normal_N"] for each in grasp["contacts"] if each["finger"] == "left")
    return least, spacing, below, normal, grasp["bending_left_deg"]


def best_place(program, mass, current, shape, width):
    places = [(spacing, below) for spacing in (width + more for more in SPACING_MINUS_WIDTH) for below in BELOW_PALM]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = list(pool.map(lambda at: least_friction(program, mass, current, shape, width, *at), places))
    held = [each for each in found if each is not None]
    return min(held) if held else None


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/coilwright"
    rows = []
    for name, mass, current, shape, widths in OBJECTS:
        for width in widths:
            best = best_place(program, mass, current, shape, width)
            numbers = ("", "", "", "", "") if best is None else (
                f"{best[0]:.2f}", best[1], best[2], f"{best[3]:.2f}", f"{best[4]:.1f}")
            rows.append((name, mass, current, width, *numbers))
    print(("{:<8}" + "{:>22}" * (len(COLUMNS) - 1)).format(*COLUMNS))
    for row in rows:
        print(("{:<8}" + "{:>22}" * (len(COLUMNS) - 1)).format(*row))
    if len(sys.argv) > 2:
        folder = pathlib.Path(sys.argv[2])
        folder.mkdir(parents=True, exist_ok=True)
        with open(folder / "gripper.csv", "w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])


if __name__ == "__main__":
    main()
