"""What a build keeps in every use, and what it does in one: rooms, walls, objects and charges beside the parts."""

import json
import unittest

from program import CONFIGS, ProgramTest, run
from study import write_study

ROOM = {"ambient_degC": {"uniform": [-5, 5]}}
PARTS = {"heat_transfer_factor": {"relative_sd": 0.15}, "remanence_T": {"relative_sd": 0.015}}
HOT = {"operating_point": {"current_A": 1.0, "duty": 1}, "objectives": [{"maximise": "p05_peak_bending_speed_deg_s"}],
       "constraints": [{"quantity": "p95_thermal_load", "at_most": 0.92}, {"quantity": "p95_mass_g", "at_most": 90}],
       "variables": {"gap_mm": {"values": [0.9]}}}
DRIVER = {"driver": {"kind": "h_bridge", "voltage_V": 24, "frequency_Hz": 20000}}
OF_USE = {
    None: ("ambient_degC", "duty", "grasp_opening_deg", "supply_voltage_V"),
    "driver": ("driver_voltage_V",),
    "gripper": ("gripper_width_mm", "gripper_height_mm", "gripper_mass_g", "gripper_friction", "gripper_centre_x_mm",
                "gripper_centre_below_palm_mm", "gripper_acceleration_m_s2"),
    "crawler": ("crawler_friction_forwards", "crawler_friction_backwards", "crawler_cell_voltage_V", "crawler_payload_mass_g"),
}
BLOCKS = {
    "driver": DRIVER["driver"],
    "gripper": {"shape": "box", "width_mm": 60, "height_mm": 30, "mass_g": 60, "friction": 0.8, "acceleration_m_s2": 1},
    "crawler": {"friction_forwards": 0.3, "friction_backwards": 0.6, "payload_mass_g": 20},
}


class Uses(ProgramTest):
    def answer(self, *arguments, study="study.json", actuator="finger.json"):
        result = run("yield", study, actuator, "--json", "--quiet", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return {row["quantity"]: row for row in json.loads(result.stdout)["quantities"]}

    def test_a_shipped_answer_is_judged_on_every_day(self):
        # With the room at its hot end for all builds, the same dice give the same parts: a second way to the same share.
        study, reference = CONFIGS / "studies/robust_A.json", CONFIGS.parent / "results/reference"
        of = [self.answer("--builds", "300", *changes, study=study, actuator=reference / "best_A/actuator.json")
              for changes in ((), ("--set", "/spread/ambient_degC/uniform/0=4.999999"))]
        for name in ("thermal_load", "irreversible_loss_pct"):
            self.assertEqual(of[0][name]["of_uses"], 1)
            self.assertAlmostEqual(of[0][name]["keeps"]["share"], of[1][name]["keeps"]["share"], delta=0.004)
        self.assertLess(of[0]["irreversible_loss_pct"]["keeps"]["high"], 0.9)
        robust = self.answer("--builds", "300", study=study, actuator=reference / "robust_A/actuator.json")
        self.assertGreater(robust["irreversible_loss_pct"]["keeps"]["low"], 0.94)
        self.assertNotIn("of_uses", of[0]["stroke_deg"])

    def test_the_summaries_say_over_what_a_share_is(self):
        write_study(self, **HOT, spread={**PARTS, **ROOM})
        text = run("yield", "study.json", "finger.json", "--builds", "50", "--quiet", cwd=self.folder).stdout
        self.assertIn("builds by fresh dice keep every limit\n"
                      "  in every use, its worst: thermal_load; all else in one use of each build, by dice\n", text)
        self.assertRegex(text, r"\n  thermal_load .*\) in every use\n")
        self.assertRegex(text, r"^MIND: thermal_load <= 0\.92 is kept in every use by ")
        write_study(self, **{**HOT, "constraints": [{"quantity": "p95_thermal_load", "at_most": 9}]}, spread={**PARTS, **ROOM})
        text = run("size", "study.json", "--out", "out", "--report", cwd=self.folder).stdout
        self.assertIn("  95 % of fingers keep this in every use: p95_thermal_load\n", text)
        self.assertIn("in every use, its worst: thermal_load; all else", (self.folder / "out/report.html").read_text())
        endless = {**PARTS, "ambient_degC": {"sd": 3}}
        write_study(self, **HOT, spread=endless)
        self.assertEqual(self.answer("--builds", "20")["thermal_load"]["of_uses"], 0.99)
        write_study(self, **HOT, spread=PARTS)
        self.assertNotIn(" use", run("yield", "study.json", "finger.json", "--builds", "20", "--quiet", cwd=self.folder).stdout)

    def test_a_study_says_what_is_of_a_use_and_which_limit_holds_in_all(self):
        worst = {"quantity": "p05_worst_steady_angle_deg", "at_least": 1}
        write_study(self, **{**HOT, "constraints": [*HOT["constraints"], worst]}, spread={**PARTS, **ROOM})
        of = self.answer("--builds", "40")
        self.assertEqual(of["worst_steady_angle_deg"]["of_uses"], 1)
        write_study(self, **HOT, spread={**PARTS, "ambient_degC": {"uniform": [-5, 5], "of": "part"}})
        part = self.answer("--builds", "40")["thermal_load"]
        self.assertNotIn("of_uses", part)
        self.assertLess(part["p50"], of["thermal_load"]["p50"])
        write_study(self, **HOT, spread={**PARTS, "current_A": {"relative_uniform": [-0.03, 0.03], "of": "use"}})
        self.assertAlmostEqual(self.answer("--builds", "40")["thermal_load"]["p50"] / part["p50"], 1.03, delta=0.02)

    def test_the_load_with_a_driver_s_ripple_is_of_every_use(self):
        write_study(self, **HOT, **DRIVER, spread={**PARTS, **ROOM})
        self.assertEqual(self.answer("--builds", "20")["driver_thermal_load"]["of_uses"], 1)

    def test_knows_by_its_name_what_is_of_a_use(self):
        for block, names in OF_USE.items():
            for name in names:
                spread = {"gap_mm": {"sd": 0.01}, name: {"uniform": [-0.01, 0.02]},
                          "correlations": [{"of": ["gap_mm", name], "value": 0.5}]}
                write_study(self, **HOT, spread=spread, **({block: BLOCKS[block]} if block else {}))
                with self.subTest(name):
                    self.assert_refused(["size", "study.json", "--out", "out"], "study.json: /spread/correlations/0/of/1: must be of "
                                        'a part: every finger meets all that is of a use ("of": "part"); got text "' + name + '"')

    def test_bad_words_are_named(self):
        for spread, message in (
            ({"gap_mm": {"sd": 0.1, "of": "day"}}, '/spread/gap_mm/of: must be one of "part", "use"; got text "day"'),
            ({"each_remanence_factor": {"relative_sd": 0.01, "of": "use"}}, '/spread/each_remanence_factor/of: must be "part": what '
             'each joint or magnet has by itself it has for good; got text "use"'),
            ({**ROOM, "share_of_uses": 0.5}, "/spread/share_of_uses: must be > 0.5 and <= 1; got 0.5"),
        ):
            with self.subTest(message):
                write_study(self, spread=spread)
                self.assert_refused(["size", "study.json", "--out", "out"], "study.json: " + message)


if __name__ == "__main__":
    unittest.main()
