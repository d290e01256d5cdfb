"""`coilwright twin`: the same data for the same seed, the answer kept apart, and plans that do not fit."""

import csv
import json
import unittest

from program import CONFIGS, PAPER_FINGER, ProgramTest, run

EXPERIMENT = {
    "format": "experiment/1", "name": "short", "sampling_rate_Hz": 200, "noise": {"angle_deg": 0.3},
    "resolution": {"angle_deg": 0.02},
    "runs": [{"file": "step.csv", "role": "fit", "duration_s": 0.5, "input": {"step": {"after_A": 1.4, "at_s": 0.1}}},
             {"file": "sine.csv", "role": "validate", "duration_s": 0.5,
              "input": {"sine": {"amplitude_A": 0.7, "offset_A": 0.7, "frequency_Hz": 2}}}]}


class Twin(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("plan.json", json.dumps(EXPERIMENT))

    def twin(self, out, *arguments):
        result = run("twin", PAPER_FINGER, "--experiment", "plan.json", "--out", out, *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def folder_of(self, name):
        return {path.name: path.read_bytes() for path in (self.folder / name).iterdir()}

    def test_the_set_is_a_folder_and_the_answer_is_beside_it(self):
        printed = self.twin("set", "--effect", "dry_friction:torque_Nmm=0.6", "--effect",
                            "viscoelastic_creep:stiffness_ratio=0.2,time_constant_s=0.5", "--seed", "7")
        self.assertEqual(printed, "2 runs, 202 samples in set; the answer is in set.answer.json\n")
        self.assertEqual(set(self.folder_of("set")), {"dataset.json", "actuator.json", "step.csv", "sine.csv", "provenance.json"})
        answer = self.result("set.answer.json")
        self.assertEqual(answer["effects"], [
            {"id": "dry_friction", "parameters": {"torque_Nmm": 0.6}},
            {"id": "viscoelastic_creep", "parameters": {"stiffness_ratio": 0.2, "time_constant_s": 0.5}}])
        self.assertEqual((answer["seed"], answer["noise"]["angle_deg"]), (7, 0.3))
        # Nothing in the folder says what is hidden; the actuator is the one that was given.
        content = self.folder_of("set")
        self.assertEqual(content["actuator.json"], PAPER_FINGER.read_bytes())
        self.assertNotIn(b"friction", b"".join(content.values()))
        data = self.result("set/dataset.json")
        self.assertEqual([(each["file"], each["role"], each["kind"], each["drive"], each["start"])
                          for each in data["runs"]],
                         [("step.csv", "fit", "transient", "current", "at_rest"),
                          ("sine.csv", "validate", "transient", "current", "at_rest")])
        self.assertEqual(data["actuator"], "actuator.json")

    def test_the_same_seed_gives_the_same_bytes_and_another_other_noise(self):
        self.twin("a", "--seed", "7")
        self.twin("b", "--seed", "7")
        self.twin("c", "--seed", "8")
        self.assertEqual(self.folder_of("a"), self.folder_of("b"))
        for name in ("step.csv", "sine.csv"):
            self.assertNotEqual(self.folder_of("a")[name], self.folder_of("c")[name])

    def test_records_of_the_same_names_are_kept(self):
        self.twin("lab")
        self.twin("lab")  # the same again loses nothing
        self.write("lab/step.csv", "time_s,angle_deg,current_A\n0,1,0\n")
        before = self.folder_of("lab")
        for command in (["twin", PAPER_FINGER, "--experiment", "plan.json", "--out", "lab"],
                        ["rig", "torque-bench", PAPER_FINGER, "--out", "lab"]):
            result = run(*command, cwd=self.folder)
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertRegex(result.stderr, r"^coilwright: lab/(step\.csv|dataset\.json): cannot be written: it holds something "
                                            r"else; --force replaces it, another --out keeps it\n$")
            self.assertEqual(self.folder_of("lab"), before)
        self.twin("lab", "--force")
        self.assertNotEqual(self.folder_of("lab"), before)

    def test_so_are_an_answer_and_a_provenance_of_somebody(self):
        twin = ["twin", PAPER_FINGER, "--experiment", "plan.json", "--out", "set"]
        rig = ["rig", "torque-bench", PAPER_FINGER, "--out", "set"]
        (self.folder / "set").mkdir()
        for name, commands in (("set.answer.json", [twin]), ("set/provenance.json", [twin, rig])):
            self.write(name, "mine")
            for command in commands:
                self.assert_refused(command, f"{name}: cannot be written: it holds something else; --force replaces it, "
                                             "another --out keeps it")
            (self.folder / name).unlink()
        (self.folder / "set/provenance.json").symlink_to("../plan.json")
        self.assert_refused([*twin, "--force"], "set/provenance.json: cannot be written: it is an input of this command")
        (self.folder / "set/provenance.json").unlink()
        (self.folder / "set/step.csv").mkdir()
        self.assert_refused([*twin, "--force"], "set/step.csv: cannot be written: Is a directory")

    def test_without_effect_and_noise_it_is_what_simulate_gives(self):
        plan = {**EXPERIMENT, "resolution": {}}
        self.write("plan.json", json.dumps(plan))
        self.twin("set", "--noise", "angle_deg=0")
        for name in ("step.csv", "sine.csv"):
            rows = self.table(f"set/{name}")
            with open(self.folder / "in.csv", "w", newline="", encoding="utf-8") as file:
                table = csv.writer(file)
                table.writerow(["time_s", "current_A"])
                table.writerows([row["time_s"], row["current_A"]] for row in rows)
            result = run("simulate", PAPER_FINGER, "--input", "in.csv", "--out", "out.csv", cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            for row, simulated in zip(rows, self.table("out.csv"), strict=True):
                # The twin integrates to 1e-6 a step, simulate to 1e-7, over 42 degrees.
                self.assertAlmostEqual(float(row["bending_angle_deg"]), float(simulated["bending_angle_deg"]),
                                       delta=1e-3)

    def test_readings_are_multiples_of_the_resolution(self):
        self.twin("set")
        for row in self.table("set/step.csv"):
            steps = float(row["bending_angle_deg"]) / 0.02
            self.assertAlmostEqual(steps, round(steps), places=6)
            self.assertLessEqual(len(row["bending_angle_deg"]), len("-30.02"))

    def test_the_shipped_experiment_runs(self):
        result = run("twin", PAPER_FINGER, "--experiment", CONFIGS / "experiments" / "paper.json", "--out", "set",
                     cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout, "14 runs, 18514 samples in set; the answer is in set.answer.json\n")

    def test_a_laboratory_is_written_as_a_careful_user_would(self):
        for out, seed in (("set", "3"), ("same", "3"), ("other", "4")):
            result = run("twin", PAPER_FINGER, "--experiment", CONFIGS / "experiments" / "laboratory.json", "--out", out,
                         "--seed", seed, cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(self.folder_of("set"), self.folder_of("same"))
        runs = {each["file"]: each for each in self.result("set/dataset.json")["runs"]}
        self.assertEqual(runs["still.csv"], {"file": "still.csv", "kind": "still", "role": "fit"})
        self.assertEqual(runs["hung_weight.csv"],
                         {"file": "hung_weight.csv", "kind": "transient", "role": "fit", "drive": "current",
                          "start": "at_rest", "input_file": "hung_weight_input.csv", "clock_offset_s": 0.01,
                          "clock_rate": 0.001, "exposure_s": 0.008, "rig": {"tip_mass_g": 5}})
        self.assertEqual(runs["turned_base.csv"]["rig"], {"base_turn_deg": 30})
        self.assertEqual(list(self.table("set/hung_weight.csv")[0]), ["time_s", "bending_angle_deg"])
        self.assertEqual(list(self.table("set/hung_weight_input.csv")[0]), ["time_s", "current_A"])
        clocks = {each["file"]: each for each in self.result("set.answer.json")["clocks"]}
        self.assertNotIn("still.csv", clocks)
        self.assertEqual(len(clocks), 8)
        self.assertEqual(len({each["shift_s"] for each in clocks.values()}), 8)
        self.assertTrue(all(abs(each["shift_s"]) <= 0.04 for each in clocks.values()))
        other = {each["file"]: each for each in self.result("other.answer.json")["clocks"]}
        self.assertNotEqual(clocks["step_0.70A.csv"], other["step_0.70A.csv"])

    def assert_twin_refused(self, message, *arguments, actuator=PAPER_FINGER):
        self.assert_refused(["twin", actuator, "--experiment", "plan.json", "--out", "set", *arguments], message)

    def test_what_does_not_fit_is_refused_and_leaves_nothing(self):
        self.assert_twin_refused('dry_fricton: "dry_fricton" is not an effect; did you mean "dry_friction"?',
                                 "--effect", "dry_fricton")
        self.assert_twin_refused("dry_friction:torque_Nmm=0.5: must not be there twice", "--effect",
                                 "dry_friction:torque_Nmm=0.6", "--effect", "dry_friction:torque_Nmm=0.5")
        self.assert_twin_refused("angle_deg=-1: must be from 0 to 1000000", "--noise", "angle_deg=-1")
        self.write("rod.json", json.dumps({
            "format": "lumped-model/1", "magnetics": None,
            "links": [{"length_m": 1, "com_along_m": 1, "com_offset_m": 0, "mass_kg": 2, "inertia_kgm2": 0}],
            "joints": [{"stiffness_Nm_rad": 0, "damping_Nms_rad": 0}]}))
        self.assert_twin_refused("plan.json: step.csv: drives coils, and the model has none", actuator="rod.json")
        plan = json.loads(json.dumps(EXPERIMENT))
        plan["runs"][1]["input"]["sine"]["frequency_hz"] = plan["runs"][1]["input"]["sine"].pop("frequency_Hz")
        self.write("plan.json", json.dumps(plan))
        self.assert_twin_refused(
            'plan.json: /runs/1/input/sine/frequency_Hz: is missing; is "frequency_hz" meant to be it?')
        plan["runs"][1]["coil"] = 3
        plan["runs"][1]["input"] = {"hold": {"level_A": 1, "from_s": 0, "until_s": 1}}
        self.write("plan.json", json.dumps(plan))
        self.assert_twin_refused("plan.json: sine.csv: drives coil 3, and the model has 2")

    def test_the_actuator_is_never_overwritten(self):
        (self.folder / "set").mkdir()
        self.write("set/actuator.json", PAPER_FINGER.read_bytes())
        self.assert_refused(["twin", "set/actuator.json", "--experiment", "plan.json", "--out", "set"],
                            "set/actuator.json: cannot be written: it is an input of this command")


if __name__ == "__main__":
    unittest.main()
