#!/usr/bin/env python3
"""`coilwright export --as mould`: OpenSCAD makes closed solids of all parts, with the volumes that the design has.

Ends with 77, which ctest shows as skipped, where openscad is not installed.
"""

import collections
import json
import math
import re
import shutil
import subprocess
import sys
import unittest

from program import CONFIGS, ProgramTest, run

FINGER = CONFIGS / "actuators" / "finger.json"
FACETS = 64  # of a circle: half of what mould.scad has, for speed

# What a circle loses that is drawn as a polygon of so many sides: 1 - sin(2 pi / n) / (2 pi / n).
POLYGON_LOSS = 1 - math.sin(2 * math.pi / FACETS) / (2 * math.pi / FACETS)

Vertex = tuple[float, float, float]


def triangles_of(stl: str) -> list[tuple[Vertex, Vertex, Vertex]]:
    points = [tuple(map(float, words)) for words in re.findall(r"vertex (\S+) (\S+) (\S+)", stl)]
    return [tuple(points[i:i + 3]) for i in range(0, len(points), 3)]


def volume_of(triangles) -> float:
    """By the divergence theorem: a sixth of the sum of the triple products."""
    return sum(a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])
               for a, b, c in triangles) / 6


def open_edges_of(triangles) -> list:
    """Edges that are not run through exactly once in each direction, by two triangles."""
    runs = collections.Counter((t[i], t[(i + 1) % 3]) for t in triangles for i in range(3))
    return [edge for edge, count in runs.items() if count != 1 or runs[edge[::-1]] != 1]


class Mould(ProgramTest):
    def export(self, kind, actuator, options):
        result = run("export", actuator, *options, "--as", kind, "--out", kind, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def render(self, part):
        stl = self.folder / f"{part}.stl"
        choices = ["-D", f'part="{part}"', "-D", f"$fn={FACETS}"]
        done = subprocess.run(["openscad", *choices, "-o", stl, self.folder / "mould" / "mould.scad"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("WARNING", done.stderr)
        triangles = triangles_of(stl.read_text())
        self.assertGreater(len(triangles), 11, part)
        self.assertEqual(open_edges_of(triangles), [], part)
        return volume_of(triangles)

    def silicone_by_segments(self):
        """mm3, of the masses by which the finger moves: another route than any box of the mould."""
        rows = [row for row in self.table("workshop/casting.csv") if row["what"].startswith("segment")]
        self.assertGreater(len(rows), 1)
        return 1e3 * sum(float(row["in_actuator_cm3"]) for row in rows)

    def assert_volumes(self, actuator=FINGER, options=()):
        self.export("mould", actuator, options)
        self.export("workshop", actuator, options)
        body, filling = self.render("body"), self.render("filling")
        coils, magnets = self.render("coils"), self.render("magnets")
        # The round of the pockets is lost between body and filling; of the parts, POLYGON_LOSS makes silicone of copper.
        silicone = self.silicone_by_segments()
        lost = POLYGON_LOSS / (1 - POLYGON_LOSS) * (coils + magnets)
        self.assertAlmostEqual(body + filling - lost, silicone, delta=1e-5 * silicone)
        main = 1e3 * float(self.table("workshop/casting.csv")[0]["in_actuator_cm3"])
        self.assertGreater(body, main)  # a polygon in the circle takes less away
        self.assertLess(body, main + POLYGON_LOSS * (coils + magnets + filling))
        # What the two halves leave free is the body, up to what the bars of the upper half do not reach into.
        self.assertAlmostEqual(self.render("cavity"), body, delta=1e-6 * body)
        return body, filling, coils, magnets

    def test_the_finger_s_parts_and_mould_are_closed_and_have_its_volumes(self):
        _, _, coils, magnets = self.assert_volumes()
        actuator = json.loads(FINGER.read_text())
        magnet, measured = actuator["magnet"], actuator["measured"]
        by_hand = math.pi * magnet["radius_mm"] ** 2 * magnet["length_mm"]
        self.assertAlmostEqual(magnets, by_hand * (1 - POLYGON_LOSS), delta=1e-5 * by_hand)
        by_hand = 2 * math.pi * measured["coil_length_mm"] * (measured["coil_outer_radius_mm"] ** 2 -
                                                               actuator["coil"]["inner_radius_mm"] ** 2)
        self.assertAlmostEqual(coils, by_hand * (1 - POLYGON_LOSS), delta=1e-5 * by_hand)
        body = actuator["body"]
        strip = self.render("bottom_layer")
        self.assertAlmostEqual(strip, 61.0 * 22.0 * body["bottom_layer_mm"], delta=1e-2)  # Table I and the errata

    def test_every_tool_is_closed(self):
        self.export("mould", FINGER, [])
        volumes = {part: self.render(part) for part in ("mould_lower", "mould_upper", "bobbin", "bobbin_flange",
                                                        "cutting_box")}
        self.assertGreater(min(volumes.values()), 0)
        # The box less its inside, with the walls of 3 mm that the file chooses.
        self.assertAlmostEqual(volumes["mould_lower"], 67 * 28 * 27 - 61 * 22 * 24, delta=0.5)
        self.assertLess(volumes["cutting_box"], volumes["mould_lower"])

    def test_another_actuator_s_parts_fit_as_well(self):
        self.assert_volumes(options=["--set", "configuration=D", "--set", "turns_radial=8", "--set", "bottom_wall_mm=1.1",
                                     "--set", "gap_mm=1.7", "--set", "coil_inner_radius_mm=2.2"])


if __name__ == "__main__":
    if shutil.which("openscad") is None:
        print("skipped: openscad is not installed")
        sys.exit(77)
    unittest.main()
