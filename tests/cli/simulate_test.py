"""`coilwright simulate`: responses that agree with `evaluate`, and inputs that do not fit."""

import json
import math
import unittest

from program import PAPER_FINGER, ProgramTest, run


# Of an input with few samples; nothing else may be said.
FEW_SAMPLES = r"\A(The samples of \S+ are up to \S+ s apart, and the motion between them is not shown: --interval-s \S+ shows it\.\n)?\Z"


class Simulate(ProgramTest):
    def simulate(self, *arguments):
        result = run("simulate", PAPER_FINGER, *arguments, "--out", "out.csv", "--force", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (0, ""))
        self.assertRegex(result.stderr, FEW_SAMPLES)
        return [{key: float(value) for key, value in row.items()} for row in self.table("out.csv")]

    def setUp(self):
        super().setUp()
        self.performance = json.loads(run("evaluate", PAPER_FINGER, "--current-A", "1.4", "--json").stdout)

    def test_a_step_starts_at_rest_and_ends_at_the_steady_angle(self):
        rows = self.simulate("--step-A", "1.4", "--duration-s", "3", "--interval-s", "0.001")
        self.assertEqual(list(rows[0]), ["time_s", "current_A", "theta1_deg", "theta2_deg", "bending_angle_deg",
                                         "bending_speed_deg_s"])
        self.assertAlmostEqual(rows[0]["bending_angle_deg"], self.performance["rest_angle_deg"], places=6)
        # Damping ratio 0.083 at 7.3 Hz: after 3 s the ringing is exp(-11) of 42 degrees.
        self.assertAlmostEqual(rows[-1]["bending_angle_deg"], self.performance["steady_angle_deg"], delta=42.6 * 2e-5)
        self.assertAlmostEqual(rows[-1]["theta1_deg"], self.performance["joint_angles_deg"][0], delta=42.6 * 2e-5)
        # Between samples 1 ms apart the speed's peak is missed by at most half its curvature times (0.5 ms)^2.
        fastest = max(row["bending_speed_deg_s"] for row in rows)
        self.assertAlmostEqual(fastest, self.performance["peak_bending_speed_deg_s"], delta=2.0)
        self.assertLessEqual(fastest, self.performance["peak_bending_speed_deg_s"] * (1 + 1e-6))

    def test_an_input_is_never_overwritten(self):
        with open(self.folder / "in.csv", "w", encoding="utf-8") as table:
            table.write("time_s,current_A\n0,1\n0.1,1\n")
        self.assert_refused(["simulate", PAPER_FINGER, "--input", "in.csv", "--out", "in.csv"],
                            "in.csv: cannot be written: it is an input of this command")

    def test_a_record_is_not_overwritten_by_a_simulation_of_its_name(self):
        self.write("step.csv", "time_s,current_A,bending_angle_deg\n0,0,21\n0.1,1,40\n")
        command = ["simulate", PAPER_FINGER, "--step-A", "1", "--out", "step.csv"]
        self.assert_refused(command, "step.csv: cannot be written: it holds something else; --force replaces it, another "
                                     "--out keeps it")
        self.assertEqual(len(self.table("step.csv")), 2)
        self.assertEqual(run(*command, "--force", cwd=self.folder).returncode, 0)
        # What it wrote itself it writes anew: another step, the same table.
        self.assertEqual(run("simulate", PAPER_FINGER, "--step-A", "0.5", "--out", "step.csv", cwd=self.folder).returncode, 0)
        self.assertEqual(self.table("step.csv")[-1]["current_A"], "0.5")

    def test_a_rig_without_an_equilibrium_starts_straight(self):
        # A point mass of 2 kg on 1 m without gravity or spring, pushed by 3 N m: x = 3 / (2 * 2) t^2 rad.
        rig = {"format": "lumped-model/1", "gravity_m_s2": 0, "magnetics": None,
               "links": [{"length_m": 1, "com_along_m": 1, "com_offset_m": 0, "mass_kg": 2, "inertia_kgm2": 0}],
               "joints": [{"stiffness_Nm_rad": 0, "damping_Nms_rad": 0}]}
        with open(self.folder / "rig.json", "w", encoding="utf-8") as file:
            json.dump(rig, file)
        with open(self.folder / "push.csv", "w", encoding="utf-8") as table:
            table.write("time_s,torque1_Nm\n0,3\n1,3\n3,3\n")
        result = run("simulate", "rig.json", "--input", "push.csv", "--out", "out.csv", cwd=self.folder)
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, FEW_SAMPLES)
        angles = [float(row["theta1_deg"]) for row in self.table("out.csv")]
        for angle, time in zip(angles, (0, 1, 3)):
            self.assertAlmostEqual(angle, math.degrees(0.75 * time * time), places=6)

    def test_a_run_starts_as_warm_as_the_actuator_says(self):
        # The same start as that of a recorded run at rest (twin, diagnose). Cold, the coils carry the whole ampere;
        # warm, 1/1.171 of it: x (1 + x) = 0.2.
        self.write("hold.csv", "time_s,current_A\n" + "".join(f"{0.1 * i:.1f},1\n" for i in range(11)))
        plan = {"format": "experiment/1", "name": "hold", "sampling_rate_Hz": 10,
                "runs": [{"file": "hold.csv", "role": "fit", "duration_s": 1, "input": {"file": "hold.csv"}}]}
        self.write("plan.json", json.dumps(plan))
        self.write("plain.json", json.dumps({"format": "actuator/1", "configuration": "B"}))
        for warm, current in ((0, 1.0), (1, 2 / (1 + math.sqrt(1.8)))):
            held = run("evaluate", "plain.json", "--current-A", repr(current), "--json", cwd=self.folder)
            start = json.loads(held.stdout)["steady_angle_deg"]
            heating = {"id": "coil_heating", "parameters": {"fade_1_A2": 0.2, "time_constant_s": 4, "warm_start": warm}}
            self.write("warming.json", json.dumps({"format": "actuator/1", "configuration": "B", "effects": [heating]}))
            result = run("simulate", "warming.json", "--input", "hold.csv", "--out", "out.csv", cwd=self.folder)
            self.assertEqual(result.returncode, 0)
            self.assertRegex(result.stderr, FEW_SAMPLES)
            angles = [float(row["bending_angle_deg"]) for row in self.table("out.csv")]
            self.assertAlmostEqual(angles[0], start, places=2)
            result = run("twin", "warming.json", "--experiment", "plan.json", "--out", f"set{warm}", cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            twin = [float(row["bending_angle_deg"]) for row in self.table(f"set{warm}/hold.csv")]
            for ours, theirs in zip(angles, twin):
                self.assertAlmostEqual(ours, theirs, delta=1e-6 * start)

    def test_a_sine_is_what_it_says(self):
        rows = self.simulate("--sine", "0.6", "0.7", "2", "--duration-s", "1.5", "--interval-s", "0.01")
        self.assertEqual(len(rows), 151)
        for row in rows:
            self.assertAlmostEqual(row["current_A"], 0.7 + 0.6 * math.sin(4 * math.pi * row["time_s"]), places=12)
        self.assertGreater(max(row["theta1_deg"] for row in rows) - min(row["theta1_deg"] for row in rows), 5)

    def test_a_response_is_given_at_every_sample_of_an_input(self):
        self.write("input.csv", "time_s,current_A\n0,0.3\n0.013,1.1\n0.02,1.1\n0.5,0.2\n")
        rows = self.simulate("--input", "input.csv")
        self.assertEqual([(row["time_s"], row["current_A"]) for row in rows],
                         [(0, 0.3), (0.013, 1.1), (0.02, 1.1), (0.5, 0.2)])
        self.assertAlmostEqual(rows[0]["bending_speed_deg_s"], 0, places=9)
        self.write("input.csv", "time_s,torque1_Nm,torque2_Nm\n0,0.001,0\n0.1,0.002,0.003\n")
        self.assertEqual(list(self.simulate("--input", "input.csv")[0])[:3], ["time_s", "torque1_Nm", "torque2_Nm"])
        # 4 ohm and 4.2 V: about an ampere
        self.write("input.csv", "time_s,voltage_V\n0,4.2\n0.1,4.2\n")
        self.assertGreater(self.simulate("--input", "input.csv")[-1]["bending_angle_deg"], 50)

    def test_the_motion_between_the_samples_of_an_input_is_shown_where_it_is_asked_for(self):
        self.write("input.csv", "time_s,current_A\n-0.01,0\n0,1.4\n1,1.4\n")
        coarse = run("simulate", PAPER_FINGER, "--input", "input.csv", "--out", "coarse.csv", cwd=self.folder)
        self.assertEqual(coarse.stderr, "The samples of input.csv are up to 1 s apart, and the motion between them is not "
                                        "shown: --interval-s 0.002 shows it.\n")
        self.assertEqual(len(self.table("coarse.csv")), 3)
        rows = self.simulate("--input", "input.csv", "--interval-s", "0.002")
        self.assertEqual(len(rows), 1 + 5 + 500)
        # Another route: the same step by itself.
        step = self.simulate("--step-A", "1.4", "--duration-s", "1", "--interval-s", "0.002")
        for ours, theirs in zip(rows[5:], step):
            self.assertAlmostEqual(ours["time_s"], theirs["time_s"], places=9)
            self.assertAlmostEqual(ours["bending_angle_deg"], theirs["bending_angle_deg"], delta=1e-3)
        self.assert_refused(["simulate", PAPER_FINGER, "--input", "input.csv", "--duration-s", "2", "--out", "x.csv"],
                            "simulate: --duration-s: is of --step-A and --sine: an input lasts as long as its file says "
                            "(see coilwright simulate --help)")
        self.assert_refused(["simulate", PAPER_FINGER, "--step-A", "1", "--duration-s", "20000", "--out", "x.csv"],
                            "--duration-s, --interval-s: duration / interval must be at most 1000000 samples; got "
                            "10000000: a longer interval, or a shorter duration")
        self.assert_refused(["simulate", PAPER_FINGER, "--input", "input.csv", "--interval-s", "1e-7", "--out", "x.csv"],
                            "--interval-s: the input at this interval must be at most 1000000 samples; got "
                            "10100000: a longer interval, or a shorter input")

    def test_a_sine_that_its_samples_cannot_show_is_refused(self):
        # Sampled at its own frequency it would be a finger at rest.
        for frequency in ("1000", "250", "-2"):
            with self.subTest(frequency):
                self.assert_refused(["simulate", PAPER_FINGER, "--sine", "0.7", "0.7", frequency, "--out", "x.csv"],
                                    "--sine, --interval-s: frequency must be at least 0 and below 250 Hz, half of the samples a "
                                    f"second; got {frequency}")

    def test_inputs_that_do_not_fit_are_refused_and_keep_the_old_result(self):
        self.write("out.csv", "precious")
        for text, message in (
            ("time_s,current1_A,current2_A,current3_A\n0,1,1,1\n",
             "input.csv: line 1: needs a current for each of the 2 coils; got 3"),
            ("time_s,torque1_Nm\n0,1\n", "input.csv: line 1: needs a torque for each of the 2 joints; got 1"),
            ("time_s,current_A\n0,1\n0,2\n", None),
            ("time_s,current_A\n0,nan\n", None),
            ("time_s\n0\n", None),
            ("", None),
        ):
            self.write("input.csv", text)
            arguments = ["simulate", PAPER_FINGER, "--input", "input.csv", "--out", "out.csv"]
            with self.subTest(text):
                if message:
                    self.assert_refused(arguments, message)
                result = run(*arguments, cwd=self.folder)
                self.assertEqual(result.returncode, 2)
                self.assertRegex(result.stderr, r"^coilwright: input\.csv: .+\n$")
                self.assertEqual(self.files()["out.csv"], b"precious")

    def test_milliamperes_for_amperes_are_refused_unless_they_are_asked_for(self):
        self.write("in.csv", "time_s,current_A\n" + "".join(f"{0.01 * i},{1400 if i > 5 else 0}\n" for i in range(50)))
        result = run("simulate", PAPER_FINGER, "--input", "in.csv", "--out", "out.csv", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout, result.stderr),
                         (2, "", "coilwright: in.csv: column current_A: reaches 1400 A, by which a coil's copper melts "
                                 "within a second: looks like milliamperes (name the column current_mA); --as-written "
                                 "takes it as it is\n"))
        self.assertFalse((self.folder / "out.csv").exists())
        self.write("in.csv", (self.folder / "in.csv").read_text().replace("current_A", "current_mA", 1))
        self.assertEqual(run("simulate", PAPER_FINGER, "--input", "in.csv", "--out", "out.csv", cwd=self.folder).returncode, 0)

    def test_exactly_one_input_is_asked_for(self):
        for arguments in ([], ["--step-A", "1", "--input", "x.csv"]):
            result = run("simulate", PAPER_FINGER, *arguments, "--out", "out.csv", cwd=self.folder)
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr.count("\n"), 1)
            self.assertEqual(self.files(), {})

    def test_a_result_that_cannot_be_written_is_refused(self):
        self.write("file", "")
        self.assert_refused(["simulate", PAPER_FINGER, "--step-A", "1", "--out", "file/out.csv"],
                            "file/out.csv: cannot be written: Not a directory")


if __name__ == "__main__":
    unittest.main()
