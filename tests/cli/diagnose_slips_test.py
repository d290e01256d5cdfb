"""`coilwright diagnose`: records in another unit or with another sign than their columns say are refused before any fit."""

import csv
import io
import json
import math
import unittest

from program import ProgramTest, run

COLUMN = "bending_angle_deg"


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

    def test_frame_numbers(self):
        self.assert_slip(lambda i, t, c, a: (i, c, a), "time_s", "frame numbers, at 200 frames a second",
                         "divide it by the frame rate")


if __name__ == "__main__":
    unittest.main()
