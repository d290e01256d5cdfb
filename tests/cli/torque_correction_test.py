"""What the commands say of an actuator with a nameless correction of the torque."""

import json
import unittest

from program import PAPER_FINGER, ProgramTest, run

CORRECTION = {"angle_deg": [-10, 5, 20, 40], "torque_Nmm": [0.1, -0.3, -0.2, 0.4]}


class TorqueCorrection(ProgramTest):
    def setUp(self):
        super().setUp()
        finger = json.loads(PAPER_FINGER.read_text())
        finger["torque_correction"] = CORRECTION
        self.write("corrected.json", json.dumps(finger))

    def evaluated(self, *arguments):
        result = run("evaluate", *arguments, "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def test_evaluate_honours_and_marks_it(self):
        plain = self.evaluated(PAPER_FINGER, "--current-A", "0.6")
        corrected = self.evaluated("corrected.json", "--current-A", "0.6")
        self.assertNotIn("torque_correction", plain)
        reach = corrected["torque_correction"]
        self.assertEqual([each["variable"] for each in reach], ["angle"])
        self.assertAlmostEqual(reach[0]["measured_from_deg"], -10, places=9)
        self.assertAlmostEqual(reach[0]["measured_to_deg"], 40, places=9)
        self.assertIs(reach[0]["beyond"], False)
        self.assertNotEqual(plain["motion"] if "motion" in plain else plain, corrected)
        text = run("evaluate", "corrected.json", "--current-A", "0.6", cwd=self.folder).stdout
        self.assertIn("With a nameless correction of the torque: what records showed and no known effect explains.\n"
                      "It was measured at joint angles of -10 to 40 deg.\n", text)
        self.assertNotIn("WARNING: used at", text)

    def test_evaluate_warns_where_it_is_used_beyond_its_range(self):
        finger = json.loads((self.folder / "corrected.json").read_text())
        finger["torque_correction"] = {"angle_deg": [0, 4, 8], "torque_Nmm": [0.1, -0.3, -0.2]}
        self.write("corrected.json", json.dumps(finger))
        text = run("evaluate", "corrected.json", "--current-A", "1.4", cwd=self.folder).stdout
        self.assertRegex(text, r"WARNING: used at joint angles of \S+ to \S+ deg: beyond what was measured it fades to "
                               r"nothing\.\n")
        self.assertIs(self.evaluated("corrected.json", "--current-A", "1.4")["torque_correction"][0]["beyond"], True)

    def test_simulate_honours_and_marks_it(self):
        for name, file in (("plain", PAPER_FINGER), ("corrected", "corrected.json")):
            result = run("simulate", file, "--step-A", "0.6", "--duration-s", "0.3", "--out", name + ".csv",
                         cwd=self.folder)
            self.assertEqual(result.returncode, 0)
            if name == "plain":
                self.assertEqual(result.stderr, "")
            else:
                self.assertIn("With a nameless correction of the torque", result.stderr)
        ends = [float(self.table(name + ".csv")[-1]["bending_angle_deg"]) for name in ("plain", "corrected")]
        # 0.2 to 0.3 mN m over a hinge of 12.7 mN m/rad in two joints: degrees.
        self.assertGreater(abs(ends[0] - ends[1]), 0.5)

    def study(self, variables, **changes):
        self.write("study.json", json.dumps({
            "format": "study/1", "name": "small", "actuator": "corrected.json", "variables": variables,
            "objectives": [{"maximise": "steady_angle_deg"}], "search": {"max_evaluations": 20}, **changes}))

    def test_size_takes_it_where_the_geometry_stays(self):
        self.study({"current_A": {"lower": 0.2, "upper": 0.6}})
        result = run("size", "study.json", "--out", "out", "--force", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("With a nameless correction of the torque", result.stdout)
        written = self.result("out/actuator.json")["torque_correction"]
        for key, values in CORRECTION.items():
            for seen, expected in zip(written[key], values):
                self.assertAlmostEqual(seen, expected, places=9)

    def test_a_study_of_its_geometry_is_refused(self):
        for variables, name in (({"gap_mm": {"lower": 0.7, "upper": 1.6, "step": 0.1}}, "gap_mm"),
                                ({"configuration": {"values": ["A", "B"]}}, "configuration")):
            self.study(variables, operating_point={"current_A": 0.5})
            for command in ("size", "sweep"):
                self.assert_refused(
                    [command, "study.json", "--out", "out"],
                    "study.json: /actuator: has a nameless torque correction, which holds for the finger that was "
                    f"measured alone: {name} must not vary")
        self.assert_refused(
            ["evaluate", "corrected.json", "--current-A", "1", "--set", "gap_mm=1.2"],
            "gap_mm=1.2: must not change: the actuator has a nameless torque correction, which holds for the finger "
            "that was measured alone")


if __name__ == "__main__":
    unittest.main()
