"""`coilwright plan`: what an experiment could show, as a table and as JSON, and plans that do not fit."""

import copy
import functools
import json
import pathlib
import tempfile
import unittest

from program import PAPER_FINGER, ProgramTest, run

EXPERIMENT = {
    "format": "experiment/1", "name": "short", "sampling_rate_Hz": 120, "noise": {"angle_deg": 0.3},
    "runs": [{"file": "step.csv", "role": "fit", "duration_s": 0.5, "input": {"step": {"after_A": 1.4, "at_s": 0.1}}},
             {"file": "sine.csv", "role": "validate", "duration_s": 0.5,
              "input": {"sine": {"amplitude_A": 0.7, "offset_A": 0.7, "frequency_Hz": 2}}}]}


@functools.cache
def planned(experiment, *arguments):
    """What is printed of an experiment, by two threads if it says nothing; several tests ask for the same."""
    with tempfile.TemporaryDirectory() as folder:
        (pathlib.Path(folder) / "plan.json").write_text(experiment)
        threads = () if "--threads" in arguments else ("--threads", "2")
        return run("plan", "plan.json", "--actuator", PAPER_FINGER, *arguments, *threads, cwd=folder)


class Plan(ProgramTest):
    def plan(self, *arguments, experiment=EXPERIMENT):
        result = planned(json.dumps(experiment), *arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def strength(self, effect, *arguments):
        plan = json.loads(self.plan("--json", *arguments))
        found = next(each for each in plan["effects"] if each["id"] == effect)
        self.assertTrue(found["visible"])
        return found["smallest"][found["strength"]]

    def test_the_table_names_every_effect_with_its_unit(self):
        plan = json.loads(self.plan("--json"))
        table = self.plan()
        for effect in plan["effects"]:
            self.assertRegex(table, rf"(?m)^  {effect['id']} +\S")
        self.assertRegex(table, r"dry_friction +torque [0-9.e-]+ Nmm")
        self.assertIn(f"Add this run: {plan['added_runs'][0]['kind']}, ", table)
        self.assertEqual(plan["samples"], 61)  # of the fit run alone

    def test_the_same_arguments_give_the_same_bytes_on_any_number_of_threads(self):
        self.assertEqual(self.plan("--json", "--threads", "1"), self.plan("--json"))

    def test_twice_the_noise_hides_twice_as_much_where_numbers_are_exact(self):
        once = self.strength("quadratic_drag", "--exact")
        twice = self.strength("quadratic_drag", "--exact", "--noise", "angle_deg=0.6")
        self.assertAlmostEqual(abs(twice / once), 2.0, delta=0.3)

    def test_tolerances_hide_what_exact_numbers_show(self):
        self.assertLess(abs(self.strength("base_tilt", "--exact")), 0.5 * abs(self.strength("base_tilt")))

    def test_the_proposed_runs_are_accepted_by_plan_and_twin_and_show_more(self):
        plan = json.loads(self.plan("--json"))
        best = plan["added_runs"][0]
        self.assertLess(best["smallest_strengths_ratio"], 1)
        longer = copy.deepcopy(EXPERIMENT)
        longer["runs"].append(best["run"])
        more = json.loads(self.plan("--json", experiment=longer))
        self.assertGreater(more["samples"], plan["samples"])
        self.assertLess(len(more["inseparable_pairs"]), len(plan["inseparable_pairs"]))
        longer["runs"] += [each["run"] for each in plan["added_runs"][1:]]
        self.write("longer.json", json.dumps(longer))
        result = run("twin", PAPER_FINGER, "--experiment", "longer.json", "--out", "set", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_what_cannot_be_planned_is_refused(self):
        command = ["plan", "plan.json", "--actuator", str(PAPER_FINGER)]
        for change, message in (
                ({"noise": {}}, "plan.json: step.csv: the instrument of bending_angle_deg must have a noise > 0, one "
                                "standard deviation of a reading; got 0"),
                ({"noise": {}, "resolution": {"angle_deg": 0.1}},
                 "plan.json: step.csv: the instrument of bending_angle_deg must have a noise > 0, one standard deviation "
                 "of a reading; got 0"),
                ({"runs": [{**EXPERIMENT["runs"][0], "role": "validate"}]},
                 "plan.json: must have a run of role fit that is not still; got none"),
                ({"runs": [{**EXPERIMENT["runs"][0], "input": {"step": {"after_A": 1400, "at_s": 0.1}}}]},
                 "plan.json: step.csv: the motion leaves the model under an input of up to 1400 A"),
                ({"runs": [{**EXPERIMENT["runs"][0], "coil": 9}]},
                 "plan.json: step.csv: drives coil 9, and the model has 2")):
            self.write("plan.json", json.dumps({**EXPERIMENT, **change}))
            self.assert_refused(command, message)
        self.assert_refused(["plan", "nothing.json", "--actuator", str(PAPER_FINGER)],
                            "nothing.json: cannot be opened: No such file or directory")
        self.assert_refused([*command, "--noise", "angle_deg=-1"], "angle_deg=-1: must be from 0 to 1000000")
        self.assert_refused([*command, "--noise", "angle_deg=1", "--noise", "angle_deg=2"],
                            "angle_deg=2: must not be there twice: angle_deg=1 sets it too")


if __name__ == "__main__":
    unittest.main()
