"""`coilwright diagnose`: records in another unit or with another sign than their columns say are refused before any fit."""

import csv
import io
import json
import math
import shutil
import unittest

from program import ProgramTest, run

COLUMN = "bending_angle_deg"
# What the records have, and nobody declared (configs/starts/README.md).
FRICTION = {"id": "dry_friction", "parameters": {"torque_Nmm": 0.6}}


class Slips(ProgramTest):
    def setUp(self):
        super().setUp()
        # Records with a dry friction that nobody declared: what they miss of the declared model is no slip.
        self.assertEqual(run("init", "dataset", cwd=self.folder).returncode, 0)
        self.records = {path.name: path.read_text() for path in self.folder.glob("*.csv")}

    def write_as(self, change):
        """Each record, its rows (time_s, current_A, angle) changed; `change` is given the row's number, too."""
        for name, text in self.records.items():
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            out = io.StringIO()
            writer = csv.writer(out, lineterminator="\n")
            writer.writerow(lines[0].split(","))
            for i, line in enumerate(lines[1:]):
                writer.writerow([repr(value) for value in change(i, *map(float, line.split(",")))])
            self.write(name, out.getvalue())

    def refusal(self):
        result = run("diagnose", ".", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertFalse((self.folder / "out").exists())
        return result.stderr

    def assert_slip(self, change, column, words, remedy):
        self.write_as(change)
        self.assertRegex(self.refusal(), rf"^coilwright: \./dataset\.json: step_1\.4A\.csv: {column}: looks like {words}: read so, the declared "
                                         rf"model misses the angles by [\d.]+ deg \(rms\), as written by .*; {remedy}; "
                                         r"--as-written takes it as it is\n$")

    def test_radians(self):
        self.assert_slip(lambda i, t, c, a: (t, c, math.radians(a)), COLUMN, "radians", "name the column bending_angle_rad")

    def test_an_angle_counted_the_other_way(self):
        self.assert_slip(lambda i, t, c, a: (t, c, -a), COLUMN, "an angle that is counted the other way",
                         "turn its sign: bending that opens the slits is positive")

    def test_exchanged_leads(self):
        self.assert_slip(lambda i, t, c, a: (t, -c, a), "current_A", "one of the other sign",
                         "turn its sign: a positive current makes coil and magnet repel, or the leads are exchanged")

    def test_milliamperes(self):
        self.assert_slip(lambda i, t, c, a: (t, 1000 * c, a), "current_A", "milliamperes", "name the column current_mA")

    def test_one_record_of_several(self):
        self.write_as(lambda i, t, c, a: (t, c, -a))
        for name, whole in self.records.items():
            if name != "sine_2Hz.csv":
                self.write(name, whole)
        self.assertRegex(self.refusal(), r"sine_2Hz\.csv: bending_angle_deg: looks like an angle that is counted the other way: ")

    def test_a_record_that_is_only_judged_by(self):
        set_file = json.loads((self.folder / "dataset.json").read_text())
        self.assertIn("sine_2Hz.csv", [each["file"] for each in set_file["runs"]])
        for each in set_file["runs"]:
            each["role"] = "validate" if each["file"] == "sine_2Hz.csv" else "fit"
        self.write("dataset.json", json.dumps(set_file))
        self.write_as(lambda i, t, c, a: (t, c, -a))
        for name, whole in self.records.items():
            if name != "sine_2Hz.csv":
                self.write(name, whole)
        self.assertRegex(self.refusal(), r"sine_2Hz\.csv: bending_angle_deg: looks like an angle that is counted the other way: ")

    def test_milliseconds(self):
        self.write_as(lambda i, t, c, a: (1000 * t, c, a))
        self.assertRegex(self.refusal(), r"step_1\.4A\.csv: time_s: looks like milliseconds: read so, the declared model misses the "
                                         r"angles by [\d.]+ deg \(rms\), as written there is a sample every 5 s; "
                                         r"name the column time_ms; --as-written takes it as it is\n$")

    def test_seconds_under_milliseconds(self):
        for name, text in self.records.items():
            self.write(name, text.replace("time_s", "time_ms", 1))
        self.assertRegex(self.refusal(), r"step_1\.4A\.csv: time_ms: looks like seconds: read so, the declared model "
                                         r"misses the angles by [\d.]+ deg \(rms\), as written there is a sample every 5e-06 s; "
                                         r"name the column time_s; --as-written takes it as it is\n$")

    def test_seconds_beside_an_input_whose_own_file_is_right(self):
        set_file = json.loads((self.folder / "dataset.json").read_text())
        for each in set_file["runs"]:
            lines = [line for line in self.records[each["file"]].splitlines() if not line.startswith("#")]
            cells = [line.split(",") for line in lines]
            each["input_file"] = each["file"].replace(".csv", "_input.csv")
            self.write(each["input_file"], "".join(f"{t},{c}\n" for t, c, _ in cells))
            self.write(each["file"], "".join(f"{t},{a}\n" for t, _, a in cells).replace("time_s", "time_ms", 1))
        self.write("dataset.json", json.dumps(set_file))
        self.assertRegex(self.refusal(), r"step_1\.4A\.csv: time_ms: looks like seconds: ")

    def assert_cured(self, cure):
        """With the cure of a refusal the set is read as it was meant: a model with its friction lacks nothing in the record
        that is fitted, nor in the others."""
        cure()
        self.write("rough.json", json.dumps({**self.result("actuator.json"), "effects": [FRICTION]}))
        cured = self.result("dataset.json")
        first, *others = cured["runs"]
        self.write("dataset.json", json.dumps({**cured, "runs": [first, *({**each, "role": "validate"} for each in others)]}))
        result = run("diagnose", ".", "--actuator", "rough.json", "--out", "out", "--quiet", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        found = self.result("out/diagnosis.json")
        self.assertEqual(found["verdict"], "no_missing_effect")
        self.assertLess(found["error"]["validate"]["after"]["rmse_deg"], 0.4)  # of a noise of 0.3
        shutil.rmtree(self.folder / "out")
        self.write("dataset.json", json.dumps(cured))

    def rename(self, old, new):
        for path in self.folder.glob("*.csv"):
            path.write_text(path.read_text().replace(old, new, 1))

    def test_frame_numbers(self):
        remedy = (r'tell the time from one to the next in dataset\.json, "columns": {"time_s": {"as": "time_s", '
                  r'"factor": 0\.005}}')
        self.assert_slip(lambda i, t, c, a: (i + 17, c, a), "time_s", "frame numbers, at 200 frames a second", remedy)

        def cure():
            told = json.loads("{" + self.refusal().split("dataset.json, ")[1].split("; --as-written")[0] + "}")
            self.write("dataset.json", json.dumps({**self.result("dataset.json"), **told}))

        self.assert_cured(cure)

    def test_any_unit_of_time(self):
        """From a first reading of 0 and of a clock that has run for long, in one record of several, too."""
        units = {"min": ("minutes", 60, 0), "h": ("hours", 3600, 0), "day": ("days", 86400, 44216.42377), "us": ("microseconds", 1e-6, 0)}
        for unit, (word, size, zero) in units.items():
            with self.subTest(unit):
                self.write_as(lambda i, t, c, a: (zero + t / size, c, a))
                refusal = self.refusal()
                self.assertIn(f"time_s: looks like {word}: ", refusal)
                self.assertIn(f"; name the column time_{unit}; --as-written", refusal)
        self.write_as(lambda i, t, c, a: (44216.42377 + t / 86400, c, a))
        self.assert_cured(lambda: self.rename("time_s", "time_day"))
        for name, whole in self.records.items():
            if name != "sine_2Hz.csv":
                self.write(name, whole)
        self.rename("time_day", "time_s")
        self.assertRegex(self.refusal(), r"sine_2Hz\.csv: time_s: looks like days: ")

    def test_times_that_are_none_by_their_spacing_alone(self):
        """Under a start that the declared model cannot be asked for, and of a still run."""
        self.write_as(lambda i, t, c, a: (t / 86400, c, a))
        document = self.result("dataset.json")
        for each in document["runs"]:
            each["start"] = "free"
        self.write("dataset.json", json.dumps(document))
        self.assertRegex(self.refusal(), r"step_1\.4A\.csv: time: has a sample every [\d.]+e-08 s, closer than any sensor of a motion: "
                                         r"name the column time_day if they are days \(a sample every 0\.005 s\)")
        self.write_as(lambda i, t, c, a: (i, c, a))
        self.assertRegex(self.refusal(), r"step_1\.4A\.csv: time_s: counts by ones, as pictures and rows are numbered: ")
        for name, whole in self.records.items():
            self.write(name, whole)
        self.write("still.csv", "time_s,bending_angle_deg\n" + "".join(f"{i},{20 + 0.1 * (i % 3)}\n" for i in range(100)))
        document["runs"].append({"file": "still.csv", "kind": "still"})
        self.write("dataset.json", json.dumps(document))
        self.assertRegex(self.refusal(), r"still\.csv: time_s: counts by ones, ")

    def test_seconds_and_nanoseconds_in_two_columns(self):
        for name, text in self.records.items():
            lines = [line for line in text.splitlines() if not line.startswith("#")]
            rows = ["sec,nanosec," + lines[0].split(",", 1)[1]]
            for line in lines[1:]:
                time, rest = line.split(",", 1)
                since = 1611137492_900000000 + round(float(time) * 1e9)
                rows.append(f"{since // 10**9},{since % 10**9},{rest}")
            self.write(name, "\n".join(rows) + "\n")
        refusal = self.refusal()
        told = refusal[refusal.index('"columns"'):].strip()
        self.assertEqual(told, '"columns": {"sec": "time_s", "nanosec": "time_ns"}')
        self.assert_cured(lambda: self.write("dataset.json", json.dumps({**self.result("dataset.json"), **json.loads("{" + told + "}")})))


if __name__ == "__main__":
    unittest.main()
