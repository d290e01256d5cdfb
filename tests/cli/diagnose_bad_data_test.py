"""`coilwright diagnose` on data that are wrong: one line with place, rule and value, status 2, and nothing written; or,
where a person must judge, a warning in the report."""

import csv
import io
import json
import math
import unittest

from program import ProgramTest, run

ROD = {"format": "lumped-model/1", "name": "rod", "gravity_m_s2": 9.81, "magnetics": None,
       "links": [{"length_m": 0.2, "com_along_m": 0.2, "com_offset_m": 0, "mass_kg": 0.5, "inertia_kgm2": 0}],
       "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 0.005}]}
# A finger of one joint: a quarter of a newton-millimetre per ampere at every angle that the table has.
FINGER = {**ROD, "links": [{"length_m": 0.02, "com_along_m": 0.01, "com_offset_m": 0, "mass_kg": 0.01,
                            "inertia_kgm2": 1e-6}],
          "joints": [{"stiffness_Nm_rad": 0.01, "damping_Nms_rad": 1e-4}],
          "magnetics": [{"angle_deg": [-30, 0, 30, 60, 90], "torque_Nmm_A": [0.25] * 5}]}

# Of a set: nothing is open but what is lacking, so that it is diagnosed in a second.
KNOWN = {"calibrate": [], "tolerances": "exact"}

HEADER = ["time_s", "torque1_Nm", "theta1_deg"]
COILS = ["time_s", "current_A", "bending_angle_deg"]


def rows(count=60, angle=lambda t: 10 * math.sin(t), command=lambda t: 0.2 * math.sin(t), draw=0):
    """A plausible record at 50 Hz, with noise that is the same every time."""
    return [[round(i / 50, 4), round(command(i / 50), 6), round(angle(i / 50) + 0.05 * (((i + draw) * 7919) % 13 - 6), 3)]
            for i in range(count)]


def table(header, lines):
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([header, *lines])
    return out.getvalue()


class BadData(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "set").mkdir()
        self.set = {"format": "measured-data/1", "name": "bad", "actuator": "rod.json",
                    "runs": [{"file": name, "kind": "transient", "role": role, "drive": "torque", "start": "at_rest"}
                             for name, role in (("a.csv", "fit"), ("b.csv", "validate"))]}
        self.write("set/rod.json", json.dumps(ROD))
        for draw, name in enumerate(("a.csv", "b.csv")):
            self.write(f"set/{name}", table(HEADER, rows(draw=draw)))

    def refuse(self, message, *arguments):
        self.write("set/dataset.json", json.dumps(self.set))
        self.assert_refused(["diagnose", "set", "--out", "out", "--quiet", *arguments], message)

    def test_a_file_outside_of_the_folder_is_not_shown_unless_it_is_a_table_of_numbers(self):
        hidden = ("must be a table of numbers with a line of names; what stands in it is not shown, as it lies outside of the "
                  "folder of set/dataset.json")
        self.write("secret.txt", "time_s,password=hunter2\nroot,x\n")
        self.write("set/seen.csv", table(["time_s", "theta1_deg"], [row[::2] for row in rows()]))
        (self.folder / "set/link.csv").symlink_to(self.folder / "secret.txt")
        for name in ("../secret.txt", "link.csv", str(self.folder / "secret.txt")):
            for files in ({"file": name}, {"file": "seen.csv", "input_file": name}):
                self.set["runs"][0].update(files)
                self.refuse(f"{name if name.startswith('/') else 'set/' + name}: {hidden}")
                self.set["runs"][0].pop("input_file", None)
        self.write("raw.csv", table(["time_s", "torque1_Nm", "speed"], rows()))
        self.set["runs"][0]["file"] = "../raw.csv"
        self.write("set/dataset.json", json.dumps(self.set))
        self.assertIn("set/../raw.csv: line 1: column speed: unknown column",
                      run("diagnose", "set", "--out", "out", "--quiet", cwd=self.folder).stderr)

    def refuse_csv(self, content, message):
        """In a fit run and in a validate run alike."""
        for name in ("a.csv", "b.csv"):
            good = (self.folder / "set" / name).read_bytes()
            self.write(f"set/{name}", content)
            with self.subTest(message=message, file=name):
                self.refuse(f"set/{name}: {message}")
            self.write(f"set/{name}", good)

    def warnings(self, *arguments):
        self.write("set/dataset.json", json.dumps(self.set))
        result = run("diagnose", "set", "--out", "out", "--quiet", *arguments, cwd=self.folder)
        self.assertEqual(result.returncode, 0)
        every = [f"warning: {each['run']}: {each['text']}" for each in self.result("out/diagnosis.json")["warnings"]]
        for line in result.stderr.splitlines():  # what is wrong with the records is said also where progress is not
            self.assertIn(line, every)
        # About runs; one about the errors on the validate run, which these rigs do not care for, names none.
        return [(each["run"], each["text"]) for each in self.result("out/diagnosis.json")["warnings"] if each["run"]]

    def test_a_file_that_is_no_table_of_numbers(self):
        head = ",".join(HEADER)
        self.refuse_csv("", "is empty: it must have a header")
        self.refuse_csv(head + "\n", "must have a row below its header")
        self.refuse_csv(f"{head}\n0,0,0\n", "line 2: column time_s: must be followed by a second sample; got 0")
        for text in ("inf", "abc"):
            self.refuse_csv(f"{head}\n0,0,0\n0.01,0,{text}\n",
                            f'line 3: column theta1_deg: must be a finite number (delete the line if it is damaged); got "{text}"')
        for text in ("", "nan"):
            self.refuse_csv(f"{head}\n0,0,0\n0.01,0,{text}\n",
                            "line 2: column theta1_deg: must have at least two values in the file; got 0")
            self.refuse_csv(f"{head}\n0,0,0\n{text},0,1\n", "line 3: column time_s: must be a finite number (delete "
                                                             f'the rows that have none); got "{text}"')
        self.refuse_csv(f"{head}\n0,0,0\n0.01,0\n", "line 3: must have 3 fields, as the header has (delete the line if it is damaged); got 2")
        self.refuse_csv(f"{head}\n0,0,0\n0.01,0,1,2\n", "line 3: must have 3 fields, as the header has (are its decimals written with commas?); got 4")

    def test_a_clock_that_goes_back_or_stands(self):
        head = ",".join(HEADER)
        for time, cure in (("0.01", "the clock starts again here, so the file holds 2 records: make a file of each, with the "
                                    "line of names, and a run of each in dataset.json"),
                           ("0.02", "delete line 4, which repeats the time of the row above")):
            self.refuse_csv(f"{head}\n0,0,0\n0.02,0,1\n{time},0,1\n",
                            f"line 4: column time_s: must exceed the value before it (0.02); {cure}; got {time}")

    def test_columns_that_are_missing_unknown_or_there_twice(self):
        for header, message in (
                ("torque1_Nm,theta1_deg", 'column time_s: is missing; the columns are "torque1_Nm", "theta1_deg", and '
                 'dataset.json must say the time: how many rows were taken a second, as "sampling_rate_Hz"'),
                ("time_s,theta1_deg", "must have an input column: current_A, current1_A.., voltage_V or torque1_Nm..; the "
                 'columns are "time_s", "theta1_deg", and dataset.json must say the input: a column of current or voltage '
                 'in this file, or another file with one, named by "input_file"; or "kind": "still" if nothing moves in it'),
                ("time_s,torque1_Nm",
                 "must have a measured column: bending_angle_deg, theta1_deg.. or omega1_rad_s..; the columns are "
                 '"time_s", "torque1_Nm", and dataset.json must say which column is the angle, in "columns"'),
                ("time_s,torque1_Nm,theta1_deg,mood", "column mood: unknown column; there may be time_s, bending_angle_deg, theta1_deg.., omega1_rad_s.., "
                 "current_A, current1_A.., voltage_V, torque1_Nm..; what is to be left alone is named in "
                 "\"ignore\" in dataset.json, by name or position (\"#1\"); in dataset.json, beside \"runs\" for all runs, "
                 "write: \"ignore\": [\"mood\"]"),
                ("time_s,torque1_Nm,theta1_deg,theta1_deg", "column theta1_deg: must not be there twice"),
                ("time_s,torque1_A,theta1_deg", 'column torque1_A: unknown unit; may be "torque1_Nm" or "torque1_Nmm" or "torque1_mNm" '
                 'or "torque1_Ncm" or .., with the numbers in that unit; in dataset.json, beside "runs" for all runs, '
                 'write: "columns": {"torque1_A": "current_A"}')):
            values = ",".join("0" for _ in header.split(","))
            self.refuse_csv(f"{header}\n{values}\n1{values[1:]}\n", f"line 1: {message}")

    def test_a_file_that_is_not_there(self):
        self.set["runs"][0]["file"] = "nowhere.csv"
        self.refuse("set/nowhere.csv: cannot be opened: No such file or directory")

    def test_words_that_do_not_exist(self):
        for key, wrong, choices in (
                ("kind", "motion",
                 '"transient", "static_torque", "joint_stiffness", "blocked_force", "temperature", "still"'),
                ("role", "train", '"fit", "validate"'), ("drive", "force", '"current", "voltage", "torque"'),
                ("start", "resting", '"at_rest", "measured", "free"')):
            good = self.set["runs"][0][key]
            self.set["runs"][0][key] = wrong
            self.refuse(f'set/dataset.json: /runs/0/{key}: must be one of {choices}; got text "{wrong}"')
            self.set["runs"][0][key] = good

    def test_a_drive_that_the_columns_contradict(self):
        self.set["runs"][0]["drive"] = "current"
        self.refuse('set/dataset.json: /runs/0/drive: must be "torque", as the input column of the file says; '
                    'got text "current"')

    def test_a_set_without_anything_to_fit(self):
        for entry in self.set["runs"]:
            entry["role"] = "validate"
        self.refuse("set/dataset.json: /runs: needs at least one fit run")
        self.set["runs"] = []
        self.refuse("set/dataset.json: /runs: must have 1 to 10000 elements; got an array of 0")

    def test_records_too_short_to_tell_anything(self):
        self.write("set/a.csv", table(HEADER, rows(4)))
        self.refuse("set/dataset.json: a.csv: needs at least 5 samples in a window; got 4")
        self.write("set/a.csv", table(HEADER, rows()))
        self.set["runs"][0]["window_s"] = 0.06
        self.refuse("set/dataset.json: a.csv: needs at least 5 samples in a window; got 3")
        self.set["runs"][0]["window_s"] = 0.01
        self.refuse("set/dataset.json: /runs/0/window_s: must exceed the mean interval between samples; got 0.01")
        self.set["runs"][0]["window_s"] = -1
        self.refuse("set/dataset.json: /runs/0/window_s: must be > 0; got -1")

    def test_a_window_longer_than_the_record_is_the_whole_record(self):
        self.set.update(KNOWN)
        self.warnings()
        whole = self.result("out/diagnosis.json")
        self.set["runs"][0]["window_s"] = 100
        self.warnings()
        self.assertEqual(self.result("out/diagnosis.json"), whole)

    def test_actuators_that_are_not_there_or_no_models(self):
        self.set["actuator"] = "nowhere.json"
        self.refuse("set/dataset.json: /actuator: must name a file, from the folder of the data set on, or be given by --actuator; "
                    "got set/nowhere.json, which is not there")
        del self.set["actuator"]
        self.refuse('set/dataset.json: names no "actuator"; one must be given with --actuator')
        self.refuse("other.json: cannot be opened: No such file or directory", "--actuator", "other.json")
        self.write("other.json", json.dumps({**ROD, "joints": [{"stiffness_Nm_rad": -1, "damping_Nms_rad": 0}]}))
        self.refuse("other.json: /joints/0/stiffness_Nm_rad: must be >= 0; got -1", "--actuator", "other.json")
        self.write("other.json", json.dumps({**ROD, "joints": []}))
        self.refuse("other.json: /joints: must have 1 element; got an array of 0", "--actuator", "other.json")

    def test_the_actuator_of_the_command_line_comes_before_that_of_the_set(self):
        self.write("other.json", json.dumps({**ROD, "name": "the other rod"}))
        self.set.update(KNOWN, actuator="nowhere.json")
        self.warnings("--actuator", "other.json")
        self.assertEqual(self.result("out/actuator.json")["name"], "the other rod")

    def test_a_model_that_cannot_be_simulated_is_one_line(self):
        self.write("set/rod.json", json.dumps({**ROD, "links": [{**ROD["links"][0], "mass_kg": 1e-12}]}))
        self.refuse("set/rod.json: the declared model cannot be simulated under the inputs of a.csv")

    def test_a_chain_that_is_folded_by_its_input_is_one_line(self):
        chain = {**FINGER, **{key: FINGER[key] * 2 for key in ("links", "joints", "magnetics")}}
        self.write("set/finger.json", json.dumps(chain))
        self.set["actuator"] = "finger.json"
        for draw, entry in enumerate(self.set["runs"]):
            self.write(f"set/{entry['file']}", table(COILS, rows(command=lambda t: 5000 if t > 0.2 else 0, draw=draw)))
            entry["drive"] = "current"
        self.write("set/dataset.json", json.dumps(self.set))
        result = run("diagnose", "set", "--out", "out", "--quiet", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        warning, error = result.stderr.splitlines()
        self.assertEqual(warning, "warning: a.csv: a current of 5000 A is commanded: is the unit right?")
        self.assertEqual(error, "coilwright: set/finger.json: the declared model cannot be simulated under the inputs of a.csv")

    def test_records_that_do_not_fit_their_model(self):
        self.write("set/finger.json", json.dumps(FINGER))
        self.set["actuator"] = "finger.json"
        for entry in self.set["runs"]:
            self.write(f"set/{entry['file']}", table(["time_s", "voltage_V", "bending_angle_deg"], rows()))
            entry["drive"] = "voltage"
        self.refuse("set/dataset.json: a.csv: has a voltage, and a lumped model has no coil resistance")
        for entry in self.set["runs"]:
            self.write(f"set/{entry['file']}", table(["time_s", "current1_A", "current2_A", "bending_angle_deg"],
                                                     [[t, u, u, y] for t, u, y in rows()]))
            entry["drive"] = "current"
        self.refuse("set/dataset.json: a.csv: needs a current for each of the 1 coils; got 2")
        self.set["actuator"] = "rod.json"
        self.refuse("set/dataset.json: a.csv: drives coils, and the model has none")
        self.write("set/a.csv", table(["time_s", "torque1_Nm", "theta1_deg", "theta2_deg"],
                                      [[t, u, y, y] for t, u, y in rows()]))
        self.set["runs"][0]["drive"] = "torque"
        self.refuse("set/dataset.json: a.csv: theta2_deg is of joint 2, and the model has 1")
        # Also where it never moves, which by itself is only a warning.
        self.write("set/a.csv", table(["time_s", "torque1_Nm", "theta1_deg", "theta2_deg"],
                                      [[t, u, y, 0] for t, u, y in rows()]))
        self.refuse("set/dataset.json: a.csv: theta2_deg is of joint 2, and the model has 1")
        self.write("set/a.csv", table(["time_s", "torque1_Nm", "torque2_Nm", "theta1_deg"],
                                      [[t, u, u, y] for t, u, y in rows()]))
        self.refuse("set/dataset.json: a.csv: needs a torque for each of the 1 joints; got 2")

    def test_a_validate_run_that_does_not_fit_the_model(self):
        self.write("set/b.csv", table(COILS, rows()))
        self.set["runs"][1]["drive"] = "current"
        self.refuse("set/dataset.json: b.csv: drives coils, and the model has none")

    def test_an_angle_that_no_finger_reaches(self):
        self.write("set/finger.json", json.dumps(FINGER))
        self.set["actuator"] = "finger.json"
        for entry in self.set["runs"]:
            self.write(f"set/{entry['file']}", table(COILS, rows()))
            entry["drive"] = "current"
        self.write("set/a.csv", table(COILS, [[t, u, 3000] for t, u, _ in rows()]))
        self.refuse("set/a.csv: line 2: column bending_angle_deg: must be within two turns, as no finger bends further "
                    "(is the unit right?); got 3000")

    def test_numbers_to_calibrate_that_are_none(self):
        for name, message in (
                ("joint_stifness", 'must be "joint_stiffness", "joint_damping" or a JSON pointer into the actuator '
                                   'file; got text "joint_stifness"'),
                ("/links/3/mass_kg", 'must lead to a number of set/rod.json, and leads nowhere; '
                                     'got text "/links/3/mass_kg"')):
            self.set["calibrate"] = [name]
            self.refuse(f"set/dataset.json: /calibrate/0: {message}")

    def test_a_noise_that_no_instrument_has(self):
        for sigma, shown in ((0, "0"), (-1, "-1"), (1e-300, "1e-300"), (1e300, "1e+300")):
            self.set["runs"][0]["sigma"] = sigma
            self.refuse(f"set/dataset.json: /runs/0/sigma: must be from 1e-12 to 1000000000000; got {shown}")

    def test_runs_measured_in_different_columns(self):
        """Each joint in one, their sum in the other."""
        self.write("rod.json", json.dumps({**ROD, "links": ROD["links"] * 2, "joints": ROD["joints"] * 2}))
        runs = [{"file": f"{name}.csv", "role": role, "drive": "torque", "duration_s": 0.5,
                 "input": {"sine": {"amplitude_Nmm": 200, "frequency_Hz": frequency}}}
                for name, role, frequency in (("a", "fit", 1), ("b", "validate", 1.5), ("c", "fit", 2))]
        self.write("plan.json", json.dumps({"format": "experiment/1", "name": "two joints", "sampling_rate_Hz": 50,
                                            "noise": {"angle_deg": 0.2}, "measure": ["theta1_deg", "theta2_deg"], "runs": runs}))
        made = run("twin", "rod.json", "--experiment", "plan.json", "--out", "set", "--force", cwd=self.folder)
        self.assertEqual((made.returncode, made.stderr), (0, ""))
        each = self.table("set/c.csv")
        inputs = [name for name in each[0] if not name.startswith("theta")]
        self.write("set/c.csv", table([*inputs, "bending_angle_deg"],
                                      [[*(row[name] for name in inputs), float(row["theta1_deg"]) + float(row["theta2_deg"])]
                                       for row in each]))
        self.set = {**self.result("set/dataset.json"), **KNOWN}
        self.warnings()
        self.assertEqual(self.result("out/diagnosis.json")["verdict"], "no_missing_effect")

    def test_an_output_that_is_a_file(self):
        self.write("out", "mine")
        self.refuse("out: cannot be written: Not a directory")

    def test_a_set_that_is_none(self):
        self.assert_refused(["diagnose", "nowhere", "--out", "out"],
                            "nowhere: cannot be opened: No such file or directory")
        (self.folder / "empty").mkdir()
        self.assert_refused(["diagnose", "empty", "--out", "out"],
                            "empty: has no dataset.json: coilwright init dataset --from RECORDS makes one of your records")
        self.write("set/dataset.json", '{"format": "measured-data/1", "runs": [')
        self.assert_refused(["diagnose", "set", "--out", "out"],
                            "set/dataset.json: line 1, column 40: ends before its JSON value is complete")

    def test_what_a_person_must_judge_is_a_warning(self):
        self.write("set/a.csv", table(HEADER, [[t, 0, 0.05 * ((i * 7919) % 13 - 6)]
                                               for i, (t, _, _) in enumerate(rows())]))
        self.assertEqual(self.warnings(), [("a.csv", "the input never moves, and the run starts at rest under it: only "
                                                     "slow effects and noise can show; where nothing moves in it, \"kind\": "
                                                     "\"still\" makes it tell the noise of all runs")])
        self.assertEqual(self.result("out/diagnosis.json")["verdict"], "no_missing_effect")
        late = [[round(t + (5 if i > 30 else 0), 4), 0.2 if i == 0 else 0.21, y] for i, (t, _, y) in enumerate(rows(40))]
        self.write("set/a.csv", table(HEADER, late))
        clock, pose = self.warnings()
        self.assertEqual((clock[0], pose[0]), ("a.csv", "a.csv"))
        self.assertIn("the clock jumps by 5.02 s after 0.6 s", clock[1])
        self.assertRegex(pose[1], "^theta1_deg begins at .* deg, where the declared model rests at .* deg. If the angle is counted ")


if __name__ == "__main__":
    unittest.main()
