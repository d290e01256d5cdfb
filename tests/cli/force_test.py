"""`coilwright force`: the numbers against an independent program, and every way to get the input wrong."""

import json
import math
import time
import unittest

from program import DATA, ProgramTest, peak_memory_of_children, run

WINDINGS = {"edge": "paper_shells", "mid": "layer_centres", "uniform": "uniform"}


def mm(metres):
    return metres * 1000.0


class Force(ProgramTest):
    def wrench(self, pair):
        self.write("pair.json", json.dumps(pair))
        result = run("force", "pair.json", "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)["poses"]

    def test_agrees_with_the_independent_program_in_any_pose(self):
        cases = json.loads((DATA / "magnetics" / "noncoaxial.json").read_text())["cases"]
        compared = 0
        for case in cases:
            coil, magnet = case["coil"], case["magnet"]
            pair = {
                "coil": {"inner_radius_mm": mm(coil["ri"]), "outer_radius_mm": mm(coil["ro"]), "length_mm": mm(coil["l"]),
                         "turns_radial": coil["Nr"], "turns_axial": coil["Nz"]},
                "magnet": {"radius_mm": mm(magnet["R"]), "length_mm": mm(magnet["l"]), "remanence_T": magnet["J"]},
                "current_A": coil["I"], "winding": WINDINGS[case["coil_model"]],
                "poses": [{"position_mm": [mm(x) for x in case["pos"]], "axis": case["axis"]}],
            }
            (result,) = self.wrench(pair)
            force, torque = case["F_on_magnet"], [mm(t) for t in case["T_about_magnet_centre"]]
            # 1e-7 of the force is what is promised; the torque's scale is the force at the magnet's radius.
            scale = math.hypot(*force)
            for got, expected in zip(result["force_N"], force):
                self.assertAlmostEqual(got, expected, delta=1e-7 * scale, msg=case["id"])
            for got, expected in zip(result["torque_Nmm"], torque):
                self.assertAlmostEqual(got, expected, delta=1e-7 * scale * mm(magnet["R"]), msg=case["id"])
            compared += 1
        self.assertGreater(compared, 5)

    def test_a_pose_without_an_axis_is_coaxial(self):
        pair = json.loads((DATA / "formats" / "two_magnets.json").read_text())
        pair["poses"] = [{"position_mm": [0, 0, 30]}, {"position_mm": [0, 0, 30], "axis": [0, 0, 1]}]
        plain, stated = self.wrench(pair)
        self.assertEqual(plain["force_N"], stated["force_N"])

    def test_says_where_the_bodies_are_in_the_same_place(self):
        pair = json.loads((DATA / "formats" / "two_magnets.json").read_text())
        pair["poses"] = [{"position_mm": [0, 0, z], "axis": [0, 0, 1]} for z in (30, 1, 31, 2)]
        self.write("pair.json", json.dumps(pair))
        result = run("force", "pair.json", "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr),
                         (0, "MIND: pair.json: in poses 2, 4 the bodies are in the same place, as no two parts can be: what "
                             "is computed is that of both currents there, to about 0.5 %.\n"))
        self.assertEqual(len(json.loads(result.stdout)["poses"]), 4)

    def test_pulls_a_disc_onto_a_plate_and_says_what_the_plate_must_be(self):
        # 12.7 by 3.175 mm of 1.32 T: 34.08 N, by its image.
        disc = {"bodies": [{"name": "disc", "magnet": {"radius_mm": 6.35, "length_mm": 3.175, "remanence_T": 1.32},
                            "position_mm": [0, 0, 1.5875]}], "plate": {"thickness_mm": 3}}
        (pose,) = self.wrench(disc)
        self.assertAlmostEqual(pose["bodies"][0]["force_N"][2], -34.078, delta=0.001)
        self.assertAlmostEqual(pose["plate"]["force_N"][2], 34.078, delta=0.001)
        self.assertAlmostEqual(pose["plate"]["least_thickness_mm"], 1.21, delta=0.02)
        disc["plate"] = {"thickness_mm": 1, "radius_mm": 8}
        self.write("pair.json", json.dumps(disc))
        result = run("force", "pair.json", cwd=self.folder)
        self.assertEqual(result.returncode, 0)
        self.assertIn("MIND: pair.json: the plate of 1 mm would have to carry 2.4", result.stderr)
        self.assertIn("it pulls less than this. A mirror from 1.21 mm on.\n", result.stderr)
        self.assertIn("MIND: pair.json: the plate ends 8 mm from its position, and 99 % of an endless plate's pull takes 11.", result.stderr)
        self.assertIn("plate pulled with 34.0781 N; it carries up to 2.42 T", result.stdout)

    def test_gives_what_acts_on_each_of_many_bodies_and_by_whom(self):
        bodies = DATA / "formats" / "bodies.json"
        result = run("force", bodies, "--matrix", "--json")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        poses = json.loads(result.stdout)["poses"]
        self.assertEqual(len(poses), 2)
        for pose in poses:
            self.assertEqual([body["name"] for body in pose["bodies"]], ["pole", "coil 2", "magnet 3"])
            left = [0.0, 0.0, 0.0]
            for body in pose["bodies"]:
                self.assertEqual([part["name"] for part in body["from"]],
                                 [name for name in ("pole", "coil 2", "magnet 3", "plate") if name != body["name"]])
                for i in range(3):
                    self.assertAlmostEqual(sum(part["force_N"][i] for part in body["from"]), body["force_N"][i], delta=1e-12)
                    left[i] += body["force_N"][i]
            for i in range(3):
                self.assertAlmostEqual(left[i] + pose["plate"]["force_N"][i], 0, delta=1e-12)
        lines = run("force", bodies, "--matrix").stdout.splitlines()
        self.assertEqual(sum(" by plate " in line for line in lines), 6)
        # A pair as a list gives the same numbers.
        pair = json.loads((DATA / "formats" / "pair.json").read_text())
        (first, second) = self.wrench(pair)
        listed = {"bodies": [{"coil": pair["coil"], "winding": pair["winding"], "current_A": pair["current_A"]},
                             {"magnet": pair["magnet"]}], "poses": pair["poses"]}
        for row, expected in zip(self.wrench(listed), (first, second)):
            self.assertEqual(row["bodies"][1]["force_N"], expected["force_N"])
            self.assertEqual(row["bodies"][1]["torque_Nmm"], expected["torque_Nmm"])

    def test_refuses_magnets_in_one_place_whose_faces_would_mean_nothing(self):
        block = {"magnet": {"size_mm": [10, 10, 5], "remanence_T": 1.3}}
        self.write("pair.json", json.dumps({"bodies": [block, {**block, "position_mm": [1, 0, 4]}]}))
        self.assert_refused(["force", "pair.json"],
                            "pair.json: must have magnet 1 and magnet 2 apart: in pose 1 they are in the same place, where the "
                            "force on a magnet's faces means nothing")

    def test_poses_two_coils_and_two_magnets(self):
        for name in ("two_coils.json", "two_magnets.json"):
            result = run("force", DATA / "formats" / name, "--json")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            (row,) = json.loads(result.stdout)["poses"]
            self.assertEqual(row["position_mm"], [0.5, 0.0, 14.0])
            self.assertNotEqual(row["force_N"][2], 0.0)
        coils = json.loads((DATA / "formats" / "two_coils.json").read_text())
        (one,) = self.wrench(coils)
        coils["currents_A"] = [2.8, 0.7]  # twice the first and the second turned round: the force is -2 times
        (other,) = self.wrench(coils)
        for before, after in zip(one["force_N"] + one["torque_Nmm"], other["force_N"] + other["torque_Nmm"]):
            self.assertAlmostEqual(after, -2 * before, delta=1e-12 * abs(before))  # the currents only multiply

    def test_the_table_has_the_numbers_of_the_json(self):
        path = DATA / "formats" / "pair.json"
        rows = json.loads(run("force", path, "--json").stdout)["poses"]
        lines = run("force", path).stdout.splitlines()
        self.assertEqual(lines[0].split()[-6:], ["force_x_N", "force_y_N", "force_z_N", "torque_x_Nmm", "torque_y_Nmm",
                                                 "torque_z_Nmm"])
        self.assertEqual(len(lines), 1 + len(rows))
        for line, row in zip(lines[1:], rows):
            for printed, exact in zip(line.split()[-6:], row["force_N"] + row["torque_Nmm"]):
                self.assertAlmostEqual(float(printed), exact, delta=1e-9 * abs(exact))  # ten digits are printed

    def test_bad_input_is_one_line_and_writes_nothing(self):
        good = json.loads((DATA / "formats" / "pair.json").read_text())

        def changed(change):
            pair = json.loads(json.dumps(good))
            change(pair)
            return json.dumps(pair)

        with_nan = changed(lambda p: p["magnet"].update(remanence_T=float("nan")))
        truncated = changed(lambda p: None)[:-3]
        for text, message in (
            (changed(lambda p: p.update(currnt_A=2)), '/currnt_A: unknown key; the keys here are "bodies", "coil", "coils", '
             '"current_A", "magnet", "magnets", "plate", "poses", "winding"'),
            (changed(lambda p: p.pop("current_A")), "/current_A: is missing"),
            (changed(lambda p: p["coil"].update(length_m=p["coil"].pop("length_mm"))),
             '/coil/length_m: unknown key; did you mean "length_mm"?'),
            (changed(lambda p: p["coil"].update(turns_axial="20")),
             '/coil/turns_axial: must be a whole number; got text "20"'),
            (changed(lambda p: p["coil"].update(outer_radius_mm=4)),
             "/coil/outer_radius_mm: must exceed inner_radius_mm (5); got 4"),
            (with_nan, f"line 1, column {with_nan.index('NaN') + 1}: must be a finite number: JSON has no NaN and no Infinity"),
            (changed(lambda p: None).replace("1.3", "1e999"),
             "/magnet/remanence_T: must be a finite number (at most 1.8e308); got 1e999"),
            (changed(lambda p: None).replace('"winding"', '"current_A": 2, "winding"'), "/current_A: duplicate key"),
            (truncated, f"line 1, column {len(truncated) + 1}: ends before its JSON value is complete"),
            ("<xml>", "line 1, column 1: is not JSON: syntax error while parsing value - invalid literal"),
            ("", "line 1, column 1: is empty: it must hold a JSON value"),
        ):
            self.write("pair.json", text)
            with self.subTest(message):
                self.assert_refused(["force", "pair.json"], "pair.json: " + message)

    def test_files_that_cannot_be_read_are_refused(self):
        self.assert_refused(["force", "no.json"], "no.json: cannot be opened: No such file or directory")
        self.assert_refused(["force", "."], ".: must be a file, and is a folder")
        self.assert_refused(["force", "/dev/zero"], "/dev/zero: must be a regular file, and is a device or a pipe")

    def test_a_file_of_100_mb_is_refused_at_once(self):
        # Piece by piece: what this process holds counts for its children until they start the program.
        with open(self.folder / "large.json", "w") as file:
            file.write('{"poses": [')
            for _ in range(1750):
                file.write('{"position_mm": [1.5, 2.5, 3.5], "axis": [0.5, 0.5, 1.5]},' * 1000)
        self.assertGreater((self.folder / "large.json").stat().st_size, 100_000_000)
        start = time.monotonic()
        result = run("force", "large.json", cwd=self.folder)
        self.assertLess(time.monotonic() - start, 5)  # it takes milliseconds; sanitizers start slowly
        self.assertEqual(result.stderr, "coilwright: large.json: must not be larger than 16 MB\n")
        self.assertEqual(result.returncode, 2)
        # Far below the file, whatever else the children of this test and a sanitizer need.
        self.assertLess(peak_memory_of_children(), 90_000_000)


if __name__ == "__main__":
    unittest.main()
