"""`coilwright linearise`: the linear model about a pose, and every way to get the input wrong."""

import json
import math
import unittest

from program import DATA, PAPER_FINGER, ProgramTest, run


class Linearise(ProgramTest):
    def linear(self, actuator=PAPER_FINGER, current="1.4"):
        result = run("linearise", actuator, "--current-A", current, "--json")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def with_effect(self, name, numbers):
        finger = json.loads(PAPER_FINGER.read_text())
        finger["effects"] = [{"id": name, "parameters": numbers}]
        return self.write("finger.json", json.dumps(finger))

    def test_the_matrices_have_a_row_for_each_name(self):
        model = self.linear()
        self.assertEqual(model["format"], "linear-model/1")
        self.assertEqual(model["states"], ["theta1_rad", "theta2_rad", "rate1_rad_s", "rate2_rad_s"])
        self.assertEqual((model["inputs"], model["outputs"]),
                         (["current_A"], ["bending_angle_rad", "theta1_rad", "theta2_rad"]))
        self.assertEqual([len(row) for row in model["A"]], [4] * 4)
        self.assertEqual([len(row) for row in model["C"]], [4] * 3)
        self.assertEqual(([len(row) for row in model["B"]], model["D"]), ([1] * 4, [[0]] * 3))
        self.assertTrue(model["stable"])
        self.assertFalse(model["sticks"])

    def test_the_pose_is_that_of_evaluate_and_the_gain_its_slope(self):
        """Another route: the steady angles of two steps, 20 mA apart."""
        model = self.linear()

        def steady(current):
            out = run("evaluate", PAPER_FINGER, "--current-A", current, "--json")
            return json.loads(out.stdout)["steady_angle_cold_deg"]

        self.assertAlmostEqual(model["bending_angle_deg"], steady("1.4"), delta=1e-3)
        slope = (steady("1.41") - steady("1.39")) / 0.02
        self.assertAlmostEqual(model["dc_gain_deg_A"], slope, delta=2e-3 * slope)

    def test_each_coil_may_have_its_own_current(self):
        result = run("linearise", PAPER_FINGER, "--current-A", "1.4", "-0.3", "--json")
        self.assertEqual((result.returncode, result.stderr), (0, "The faces of joint 2 are pressed: the linear model "
                                                                 "holds while they stay so.\n"))
        model = json.loads(result.stdout)
        self.assertEqual((model["coil_currents_A"], model["inputs"]), ([1.4, -0.3], ["current1_A", "current2_A"]))
        self.assertEqual(([len(row) for row in model["B"]], len(model["dc_gains_deg_A"])), ([2] * 4, 2))
        self.assertNotIn("current_A", model)
        table = run("linearise", PAPER_FINGER, "--current-A", "1.4", "-0.3").stdout
        self.assertEqual([line.split()[0] for line in table.partition("\n\n")[0].splitlines()],
                         ["current1_A", "current2_A", "bending_angle_deg", "theta1_deg", "theta2_deg", "dc_gain1_deg_A",
                          "dc_gain2_deg_A", "natural_frequency1_Hz", "damping_ratio1", "natural_frequency2_Hz", "damping_ratio2"])
        self.assert_refused(["linearise", PAPER_FINGER, "--current-A", "1", "2", "3"],
                            f"{PAPER_FINGER}: has 2 coils; a current for each is needed, got 3")

    def test_the_modes_are_those_of_the_matrix(self):
        """The product of the eigenvalues is the determinant, their sum the trace."""
        model = self.linear()
        squares = math.prod((2 * math.pi * mode["natural_frequency_Hz"]) ** 2 for mode in model["modes"])
        size = math.prod(math.hypot(value["real_1_s"], value["imaginary_1_s"]) for value in model["eigenvalues"])
        self.assertAlmostEqual(squares, size, delta=1e-9 * size)
        trace = sum(model["A"][i][i] for i in range(4))
        self.assertAlmostEqual(sum(value["real_1_s"] for value in model["eigenvalues"]), trace, delta=1e-9 * abs(trace))

    def test_the_table_and_the_file_have_the_numbers_of_the_json(self):
        result = run("linearise", PAPER_FINGER, "--current-A", "1.4", "--out", "linear.json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        model = self.linear()
        self.assertEqual(self.result("linear.json"), model)
        table, _, rests_on = result.stdout.partition("\n\n")
        self.assertIn("coils and magnets are taken at 20 degC", rests_on)
        lines = [line.split() for line in table.splitlines()]
        self.assertEqual([key for key, _ in lines],
                         ["current_A", "bending_angle_deg", "theta1_deg", "theta2_deg", "dc_gain_deg_A",
                          "natural_frequency1_Hz", "damping_ratio1", "natural_frequency2_Hz", "damping_ratio2"])
        printed = {key: float(value) for key, value in lines}
        for key in ("current_A", "bending_angle_deg", "dc_gain_deg_A"):
            self.assertAlmostEqual(printed[key], model[key], delta=1e-4 * model[key])  # five digits

    def test_friction_and_pressed_faces_are_told(self):
        self.with_effect("dry_friction", {"torque_Nmm": 0.2})
        result = run("linearise", "finger.json", "--current-A", "1", cwd=self.folder)
        self.assertEqual(result.returncode, 0)
        self.assertEqual(result.stderr, "Something sticks (dry friction, hysteresis): the linear model is one of motions "
                                        "beyond what it holds, and has no friction.\n")
        result = run("linearise", PAPER_FINGER, "--current-A", "-1.4")
        self.assertEqual(result.stderr, "".join(
            f"The faces of joint {joint} are pressed: the linear model holds while they stay so.\n" for joint in (1, 2)))

    def test_another_file_is_kept_and_its_own_kind_replaced(self):
        self.write("out.json", PAPER_FINGER.read_text())
        command = ["linearise", str(PAPER_FINGER), "--current-A", "1", "--out", "out.json"]
        self.assert_refused(command, "out.json: cannot be written: it holds something else; --force replaces it, another "
                                     "--out keeps it")
        self.assertEqual(run(*command, "--force", cwd=self.folder).returncode, 0)
        self.assertEqual(run(*command[:3], "0.5", *command[4:], cwd=self.folder).returncode, 0)

    def test_what_has_no_linear_model_is_refused(self):
        self.assert_refused(["linearise", "nothing.json", "--current-A", "1"],
                            "nothing.json: cannot be opened: No such file or directory")
        self.assert_refused(["linearise", str(PAPER_FINGER), "--current-A", "nan"],
                            'linearise: --current-A: must be a finite number; got "nan" (see coilwright linearise --help)')
        self.assert_refused(["linearise", str(PAPER_FINGER)],
                            "linearise: --current-A is required (see coilwright linearise --help)")
        result = run("linearise", PAPER_FINGER, "--current-A", "100000")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertRegex(result.stderr, r"^coilwright: .*paper_finger\.json: rests with joint 1 at 13\d\.\d deg under "
                                        r"100000 A, and its torque is known up to 120 deg\n$")
        self.write("own.json", json.dumps({}))
        self.assert_refused(["linearise", "own.json", "--current-A", "1", "--out", "own.json"],
                            "own.json: cannot be written: it is an input of this command")


if __name__ == "__main__":
    unittest.main()
