"""`coilwright init` and `coilwright schema`: what they write runs as it is, and follows the schemas."""

import json
import math
import random
import unittest

from program import CONFIGS, DATA, ProgramTest, run


class Init(ProgramTest):
    def init(self, *arguments):
        result = run("init", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def run_well(self, *arguments):
        result = run(*arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def test_a_study_finds_a_feasible_design(self):
        self.assertEqual(self.init("study"),
                         "study.json\nactuator.json\nNext: coilwright size study.json --out results\n")
        self.run_well("size", "study.json", "--out", "results", "--quiet")
        answer = self.result("results/result.json")
        self.assertTrue(answer["feasible"])
        study = json.loads((self.folder / "study.json").read_text())
        self.assertLess(len(answer["at_range_end"]), len(study["variables"]))

    def test_an_actuator_is_evaluated(self):
        self.assertEqual(self.init("actuator", "--out", "mine"),
                         "mine/actuator.json\nNext in mine: coilwright evaluate actuator.json --current-A 1\n")
        figures = json.loads(self.run_well("evaluate", "mine/actuator.json", "--current-A", "1", "--json"))
        self.assertTrue(40 < figures["steady_angle_deg"] < 70)
        self.assertTrue(60 < figures["mass_g"] < 75)

    def test_a_data_set_is_diagnosed_and_shows_its_friction(self):
        text = self.init("dataset")
        self.assertIn("Next: coilwright diagnose . --out results\n", text)
        self.run_well("diagnose", ".", "--out", "results", "--quiet")
        answer = self.result("results/diagnosis.json")
        self.assertEqual((answer["verdict"], [effect["id"] for effect in answer["effects"]]),
                         ("explained", ["dry_friction"]))
        # As configs/starts/README.md says that it was made: constant, without numbers that the records do not tell.
        self.assertEqual(list(answer["effects"][0]["parameters"]), ["torque_Nmm"])
        low, high = answer["effects"][0]["parameters"]["torque_Nmm"]["ci95"]
        self.assertTrue(low < 0.6 < high, (low, high))

    def test_a_data_set_about_records_that_are_there_is_read(self):
        records = DATA / "formats" / "records"
        text = self.init("dataset", "--from", str(records / "labview.lvm"), str(records / "excel_german.csv"))
        self.assertIn("labview.lvm: the rows are 500 a second", text)
        self.assertIn("  the actuator: actuator.json is an example, change it to yours\n", text)
        document = json.loads((self.folder / "dataset.json").read_text())
        self.assertEqual(document["runs"][0]["columns"],
                         {"Strom (mA)": "current_mA", "Winkel (deg)": "bending_angle_deg"})
        self.assertEqual(document["runs"][1]["columns"],
                         {"Zeit (s)": "time_s", "Strom (A)": "current_A", "Winkel (°)": "bending_angle_deg"})
        # As far as the declared model, which is not there.
        self.assert_refused(["diagnose", ".", "--out", "out", "--actuator", "none.json"],
                            "none.json: cannot be opened: No such file or directory")
        self.assert_refused(["init", "dataset", "--from", "none.csv"], "none.csv: cannot be opened: No such file or directory")
        self.assert_refused(["init", "study", "--from", str(records / "plain.csv")],
                            "init: --from: is for init dataset only (see coilwright init --help)")

    def test_a_data_set_about_records_follows_the_advice_to_record_twice_and_at_rest(self):
        """Records of a person: pairs that begin at other moments, a still file with and without an input, a single motion."""
        self.init("actuator")
        noise = random.Random(3)

        def record(name, of, columns="time_s,current_A,bending_angle_deg"):
            rows = []
            for i in range(400):
                t = 0.005 * i
                current, angle = of(t)
                cells = [f"{t:.3f}", f"{current:.4f}", f"{angle + noise.gauss(0, 0.3):.3f}"]
                rows.append(",".join(cells if "current" in columns else [cells[0], cells[2]]))
            self.write(name, columns + "\n" + "\n".join(rows) + "\n")

        step = lambda size, begin: lambda t: (size if t >= begin else 0.0, 20 + (30 * size * (1 - math.exp(-(t - begin) / 0.05)) if t >= begin else 0.0))
        sine = lambda rate, begin: lambda t: (0.7 + 0.5 * math.sin(2 * math.pi * rate * (t - begin)), 45 + 20 * math.sin(2 * math.pi * rate * (t - begin) - 0.4))
        still = lambda t: (0.0, 20.0)
        for name, of in (("step_0.7A.csv", step(0.7, 0.3)), ("step_0.7A_again.csv", step(0.7, 0.42)), ("step_1.4A.csv", step(1.4, 0.3)),
                         ("sine_1Hz.csv", sine(1, 0)), ("sine_1Hz_b.csv", sine(1, 0.1)), ("sine_3Hz.csv", sine(3, 0)), ("rest.csv", still)):
            record(name, of)
        record("quiet.csv", still, "time_s,bending_angle_deg")
        files = sorted(path.name for path in self.folder.glob("*.csv"))
        text = self.init("dataset", "--from", *files)
        document = self.result("dataset.json")
        self.assertEqual(document["name"], self.folder.name)
        self.assertEqual({run["file"]: (run["kind"], run.get("role")) for run in document["runs"]},
                         {"step_0.7A.csv": ("transient", "fit"), "step_0.7A_again.csv": ("transient", "validate"),
                          "step_1.4A.csv": ("transient", "fit"), "sine_1Hz.csv": ("transient", "fit"),
                          "sine_1Hz_b.csv": ("transient", "validate"), "sine_3Hz.csv": ("transient", "fit"),
                          "rest.csv": ("still", None), "quiet.csv": ("still", None)})
        self.assertIn('  sine_1Hz_b.csv repeats sine_1Hz.csv, and is kept from the fit ("validate")\n', text)
        self.assertIn('nothing moves in it: it shows the noise ("kind": "still")', text)
        self.assertNotIn("To be said by you", text)
        self.assertEqual(run("diagnose", ".", "--out", "out", "--minutes", "0.001", cwd=self.folder).returncode, 130)
        # Without a repeat the choice is told.
        (self.folder / "dataset.json").unlink()
        self.assertIn("no motion is there twice: ", self.init("dataset", "--from", "step_1.4A.csv", "sine_3Hz.csv"))

    def test_a_still_run_is_named_where_an_input_is_missed(self):
        rows = "".join(f"{0.01 * i:.2f},{20 + i}\n" for i in range(40))
        self.write("moves.csv", "time_s,bending_angle_deg\n" + rows)
        self.assertIn('or "kind": "still" if nothing moves in it', self.init("dataset", "--from", "moves.csv"))

    def test_every_object_says_what_it_is_for(self):
        self.init("study")
        self.init("dataset")
        for name in ("study.json", "actuator.json", "dataset.json"):
            document = json.loads((self.folder / name).read_text())
            self.assertIn("comment", document, name)
            self.assertGreater(json.dumps(document).count('"comment"'), 2, name)

    def test_no_file_is_replaced(self):
        self.write("study.json", "precious")
        self.assert_refused(["init", "study"],
                            "study.json: cannot be written: it exists, and init replaces no file")
        self.init("actuator", "--out", "mine")
        self.assert_refused(["init", "actuator", "--out", "mine"],
                            "mine/actuator.json: cannot be written: it exists, and init replaces no file")

    def test_a_study_is_about_the_actuator_that_is_there(self):
        self.init("actuator")
        own = (self.folder / "actuator.json").read_text().replace('"my_finger"', '"another"')
        self.write("actuator.json", own)
        self.assertIn("actuator.json was there already, and stays as it is\n", self.init("study"))
        self.assertEqual((self.folder / "actuator.json").read_text(), own)

    def test_json_lists_what_was_written(self):
        told = json.loads(self.init("study", "--json"))
        self.assertEqual(told, {"written": ["study.json", "actuator.json"],
                                "next": "coilwright size study.json --out results"})


class Schema(ProgramTest):
    def test_prints_the_schemas_as_they_ship(self):
        for path in sorted((CONFIGS / "schemas").glob("*.schema.json")):
            name = path.name.removesuffix(".schema.json")
            result = run("schema", name)
            self.assertEqual((result.returncode, result.stderr, result.stdout), (0, "", path.read_text()), name)

    def test_writes_all_of_them_into_a_folder(self):
        result = run("schema", "study", "--out", "schemas", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        written = {path.name: path.read_text() for path in (self.folder / "schemas").iterdir()}
        self.assertEqual(written, {path.name: path.read_text() for path in (CONFIGS / "schemas").iterdir()})

    def test_a_schema_that_was_changed_is_kept(self):
        self.write("study.schema.json", "{}")
        command = ["schema", "study", "--out", "."]
        self.assert_refused(command, "./study.schema.json: cannot be written: it holds something else; --force replaces it, "
                                     "another --out keeps it")
        for arguments in (["--force"], []):  # the same again loses nothing
            self.assertEqual(run(*command, *arguments, cwd=self.folder).returncode, 0)
        self.assertEqual((self.folder / "study.schema.json").read_text(), run("schema", "study").stdout)

    def test_another_name_is_refused(self):
        message = run("schema", "stud").stderr
        self.assertTrue(message.startswith('coilwright: schema: NAME: must be one of "actuator", "as-built", '), message)
        self.assertIn('; did you mean "study"?; got "stud"', message)


if __name__ == "__main__":
    unittest.main()
