"""Joints that magnets hold shut: the force that does it, and that every cure that is printed works when it is followed."""

import json
import re
import unittest

from program import ProgramTest, run

ROWS = {"C": {"configuration": "C"}, "D": {"configuration": "D"},
        "small": {"layout": ["magnet", "coil", "magnet"], "coil": {"turns_radial": 9, "turns_axial": 18},
                  "magnet": {"radius_mm": 7, "length_mm": 9}}}
MIND = re.compile(r"MIND: joints? [\d, and]+ (?:is|are) pressed shut at this current")


class ShutJoints(ProgramTest):
    def evaluated(self, actuator, current):
        self.write("finger.json", json.dumps({"format": "actuator/1", **actuator}))
        result = run("evaluate", "finger.json", "--current-A", current, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def test_what_is_said_to_open_them_opens_them(self):
        for name, row in ROWS.items():
            with self.subTest(name):
                text = self.evaluated(row, 0.4)
                self.assertRegex(text, MIND)
                self.assertRegex(text, r"magnet 1 and magnet 2 attract each other through coil [^;]* with [\d.]+ N, and a "
                                 r"coil gives its magnet [\d.]+ N at 0\.4 A")
                cures = text.split("What opens every joint, with all else as it is\n")[1].split("In a study")[0]
                found = re.findall(r"^  (\S.*)\n    rest_angle_deg ([-\d.e+]+), stroke_deg ([-\d.e+]+)", cures, re.M)
                self.assertTrue(found)
                for cure, rest, stroke in found:
                    keys, current = row, 0.4
                    if '"layout"' in cure:
                        other = json.loads("{" + cure[cure.index('"layout"'):] + "}")
                        keys = {key: value for key, value in row.items() if key not in ("configuration", "layout")} | other
                    else:
                        current = float(cure.removesuffix(" A"))
                    followed = self.evaluated(keys, current)
                    self.assertNotRegex(followed, MIND)
                    for quantity, value in {"rest_angle_deg": rest, "stroke_deg": stroke}.items():
                        line = re.search(rf"^ *{quantity} +([-\d.e+]+)", followed, re.M)
                        self.assertAlmostEqual(float(line[1]), float(value), delta=0.006 * abs(float(value)))

    def test_a_study_can_ask_for_joints_that_open(self):
        rows = [["coil", "magnet", "coil", "magnet", "coil"], ["coil", "magnet", "coil"]]
        study = {"format": "study/1", "name": "open", "actuator": "finger.json", "operating_point": {"current_A": 0.5},
                 "variables": {"layout": {"values": rows}, "gap_mm": {"values": [0.8, 0.9, 1.0]}},
                 "objectives": [{"maximise": "mass_g"}]}
        self.write("finger.json", json.dumps({"format": "actuator/1", "configuration": "C"}))
        parts = {}
        for limits in ([], [{"quantity": "smallest_joint_stroke_deg", "at_least": 2}]):
            self.write("study.json", json.dumps({**study, "constraints": limits}))
            result = run("size", "study.json", "--out", "out", "--force", cwd=self.folder)
            self.assertEqual(result.returncode, 0, result.stderr)
            parts[bool(limits)] = len(self.result("out/actuator.json").get("layout", "configuration B"[-1:] * 3))
            self.assertEqual("What opens every joint" in result.stdout, not limits)
            self.assertEqual("attract each other through coil 2" in result.stdout, not limits)
        self.assertEqual(parts[True], 3)

if __name__ == "__main__":
    unittest.main()
