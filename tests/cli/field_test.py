"""`coilwright field`: flux densities that makers and textbooks print, maps, and every way to get the question wrong."""

import csv
import json
import math
import unittest
import xml.etree.ElementTree

from program import DATA, ProgramTest, run

MU0 = 1.25663706212e-6


class Field(ProgramTest):
    def file(self, content, name="pair.json"):
        self.write(name, json.dumps(content))
        return name

    def points(self, content, *arguments):
        result = run("field", self.file(content), *arguments, "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)["points"]

    def test_gives_the_surface_gauss_of_a_disc_and_a_block(self):
        # On the axis of a disc Br / 2 ((L + z) / sqrt(R^2 + (L + z)^2) - z / sqrt(R^2 + z^2)): here 2.7 kG.
        disc = {"bodies": [{"magnet": {"radius_mm": 6.35, "length_mm": 3.175, "remanence_T": 1.32}}]}
        for z in (0, 0.5, 10):
            (point,) = self.points(disc, "--at", "0", "0", str(3.175 / 2 + z))
            expected = 660 * ((3.175 + z) / math.hypot(6.35, 3.175 + z) - z / math.hypot(6.35, z))
            self.assertAlmostEqual(point["flux_density_mT"][2], expected, delta=1e-6 * expected)
            self.assertEqual(point["inside"], None)
        block = {"bodies": [{"magnet": {"size_mm": [10, 20, 5], "remanence_T": 1.3}, "position_mm": [1, 2, 3]}]}
        (point,) = self.points(block, "--at", "1", "2", "9.5")

        def angle(d):
            return math.atan(200 / (2 * d * math.sqrt(4 * d * d + 500)))

        self.assertAlmostEqual(point["flux_density_mT"][2], 1300 / math.pi * (angle(4) - angle(9)), delta=1e-6)

    def test_has_no_number_for_the_infinite_field_on_an_edge(self):
        bodies = {"bodies": [{"magnet": {"radius_mm": 4, "length_mm": 6, "remanence_T": 1.3}},
                             {"name": "block", "magnet": {"size_mm": [10, 10, 5], "remanence_T": 1.3}, "position_mm": [0, 0, 30]},
                             {"coil": {"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 10, "turns_radial": 8,
                                       "turns_axial": 20}, "current_A": 1, "position_mm": [40, 0, 0]}]}
        on = ((4, 0, 3), (0, -4, -3), (5, 1, 32.5), (5, 5, 27.5))
        beside = ((4, 0, 2.999), (5, 5, 30), (49, 0, 5))  # on a side, on an edge without a pole, on one of a coil
        asked = [str(number) for point in (*on, *beside) for number in ("--at", *point)]
        points = self.points(bodies, *asked)
        for point in points[:len(on)]:
            self.assertIsNone(point["flux_density_mT"])
            self.assertNotIn("magnitude_mT", point)
        self.assertEqual([point.get("on_edge_of") for point in points], ["magnet 1"] * 2 + ["block"] * 2 + [None] * len(beside))
        self.assertTrue(all(point["magnitude_mT"] < 2000 for point in points[len(on):]))
        text = run("field", "pair.json", *asked, cwd=self.folder).stdout.splitlines()
        self.assertRegex(text[3], r"\A +5 +1 +32\.5  infinite, on an edge of block\Z")
        self.write("points.csv", "x_mm,y_mm,z_mm\n4,0,3\n0,0,10\n")
        self.assertEqual(run("field", "pair.json", "--points", "points.csv", "--out", "b.csv", cwd=self.folder).returncode, 0)
        self.assertEqual([row["B_mT"] == "" for row in self.table("b.csv")], [True, False])

    def test_has_the_gradient_of_a_coil_whose_trace_is_none(self):
        pair = json.loads((DATA / "formats" / "pair.json").read_text())
        one, two = (self.points(pair, "--gradient", "--at", "2", "1", z)[0] for z in ("30", "30.01"))
        slopes = one["gradient_T_m"]
        self.assertAlmostEqual(sum(slopes[i][i] for i in range(3)), 0, delta=1e-9)
        for i in range(3):
            rise = (two["flux_density_mT"][i] - one["flux_density_mT"][i]) / 0.01  # mT/mm is T/m
            self.assertAlmostEqual(slopes[i][2], rise, delta=3e-3 * max(abs(each) for row in slopes for each in row))

    def test_says_that_bodies_are_in_the_same_place(self):
        magnet = {"magnet": {"size_mm": [10, 20, 5], "remanence_T": 1.3}}
        for z, told in ((2, True), (6, False)):
            result = run("field", self.file({"bodies": [magnet, {**magnet, "position_mm": [0, 0, z]}]}), "--at", "0", "0", "20",
                         cwd=self.folder)
            self.assertEqual((result.returncode, "in pose 1 the bodies are in the same place" in result.stderr), (0, told))

    def test_says_what_a_point_is_in(self):
        bodies = json.loads((DATA / "formats" / "bodies.json").read_text())
        rows = self.points(bodies, "--at", "1", "0", "4", "--at", "5", "0", "15", "--at", "0", "0", "-2", "--at", "40", "0", "9")
        self.assertEqual([row["inside"] for row in rows], ["pole", "coil 2", "plate", None])
        self.assertEqual(rows[2]["flux_density_mT"], None)
        # In front of the plate of a high permeability the field is nearly square to it.
        (point,) = self.points(bodies, "--at", "3", "1", "-1")
        self.assertLess(math.hypot(*point["flux_density_mT"][:2]), 5e-3 * abs(point["flux_density_mT"][2]))

    def test_reads_points_and_writes_them_as_a_table(self):
        bodies = json.loads((DATA / "formats" / "bodies.json").read_text())
        self.write("points.csv", "x_mm,y_mm,z_mm\n30,0,10\n0,0,-3\n")
        self.assertEqual(run("field", self.file(bodies), "--points", "points.csv", "--gradient", "--pose", "2", "--out", "b.csv",
                             cwd=self.folder).returncode, 0)
        with open(self.folder / "b.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        (point,) = self.points(bodies, "--at", "30", "0", "10", "--pose", "2")
        # The effort is chosen for eight points at once, and with it the last digits of the ten that are promised.
        for axis, expected in zip("xyz", point["flux_density_mT"]):
            self.assertAlmostEqual(float(rows[0][f"B{axis}_mT"]), expected, delta=1e-9 * point["magnitude_mT"])
        self.assertEqual(rows[1]["B_mT"], "")
        self.assertEqual(len(rows[0]), 3 + 4 + 9 + 1)
        self.assertNotEqual(self.points(bodies, "--at", "30", "0", "10")[0], point)  # another pose

    def test_draws_a_map_whose_numbers_are_in_the_table(self):
        bodies = json.loads((DATA / "formats" / "bodies.json").read_text())
        result = run("field", self.file(bodies), "--map", "xz", "--window", "-30", "30", "-10", "40", "--cells", "30", "--out", "map.csv",
                     "--svg", "map.svg", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        with open(self.folder / "map.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 30 * 25)
        self.assertEqual({row["y_mm"] for row in rows}, {"0"})
        self.assertEqual({row["body"] for row in rows}, {"0", "1", "2", "3"})
        root = xml.etree.ElementTree.parse(self.folder / "map.svg").getroot()
        texts = [element.text for element in root.iter() if element.tag.endswith("text")]
        self.assertIn("|B| (mT)", texts)
        self.assertIn("x (mm)", texts)
        largest = max(float(row["B_mT"]) for row in rows if row["B_mT"])
        self.assertIn(f"{largest:.4g}", texts)
        again = run("field", "pair.json", "--map", "xz", "--window", "-30", "30", "-10", "40", "--cells", "30", "--svg", "again.svg",
                    cwd=self.folder)
        self.assertEqual(again.returncode, 0)
        self.assertEqual((self.folder / "again.svg").read_bytes(), (self.folder / "map.svg").read_bytes())

    def test_the_table_has_the_numbers_of_the_json(self):
        pair = json.loads((DATA / "formats" / "pair.json").read_text())
        (point,) = self.points(pair, "--at", "1", "-2", "30")
        line = run("field", "pair.json", "--at", "1", "-2", "30", cwd=self.folder).stdout.splitlines()[1].split()
        for printed, exact in zip(line[3:6], point["flux_density_mT"]):
            self.assertAlmostEqual(float(printed), exact, delta=1e-8 * abs(exact))

    def test_refuses_questions_that_are_none(self):
        self.file(json.loads((DATA / "formats" / "pair.json").read_text()))
        for arguments, message in (
            ([], "one of --at, --points and --map says where the field is wanted"),
            (["--at", "0", "0", "1", "--map", "xz"], "one of --at, --points and --map says where the field is wanted"),
            (["--at", "0", "1"], "--at: must be three numbers each time: X Y Z in mm"),
            (["--map", "xz"], "--map: needs --out FILE.csv, --svg FILE.svg or both to write to"),
            (["--at", "0", "0", "1", "--svg", "a.svg"], "--svg: is of a map: it needs --map"),
            (["--at", "0", "0", "1", "--pose", "3"], "--pose: must be at most 2, which is how many poses pair.json has; got 3"),
            (["--map", "xz", "--svg", "a.svg", "--window", "1", "1", "0", "2"],
             "--window: must be LEFT RIGHT BOTTOM TOP with LEFT below RIGHT and BOTTOM below TOP"),
        ):
            with self.subTest(message):
                result = run("field", "pair.json", *arguments, cwd=self.folder)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn(message, result.stderr)
                self.assertEqual([path.name for path in self.folder.iterdir()], ["pair.json"])
        self.write("points.csv", "x_mm,y_mm\n1,2\n")
        result = run("field", "pair.json", "--points", "points.csv", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("points.csv: line 1: column z_mm", result.stderr)


if __name__ == "__main__":
    unittest.main()
