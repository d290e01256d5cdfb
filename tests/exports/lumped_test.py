"""`coilwright export --as lumped`: the lumped model does what the design does, and says what it has not."""

import csv
import json
import unittest

from exported import FINGER, PAPER_FINGER, changed_finger, evaluated, export
from program import DATA, ProgramTest, run

# Tables are read to 1e-4 of the largest torque. At the steady angle a finger has 0.6 of that torque and 18 deg/A: at
# 1.4 A the angle is within 18 * 1.4 * 1e-4 / 0.6 deg = 0.0042, the speed of a step within a few 1e-4.
ANGLE = 0.0042  # deg
SPEED = 3e-4


def motion(actuator, folder, name):
    result = run("simulate", actuator, "--step-A", "1.4", "--out", folder / name)
    assert result.returncode == 0, result.stderr
    with open(folder / name, newline="") as file:
        return [(float(row["time_s"]), float(row["bending_angle_deg"])) for row in csv.DictReader(file)]


def torque_at(lumped, angle):
    """Of the first joint, by straight lines between the rows."""
    table = json.loads(lumped.read_text())["magnetics"][0]
    rows = list(zip(table["angle_deg"], table["torque_Nmm_A"]))
    (a, before), (b, after) = next((one, two) for one, two in zip(rows, rows[1:]) if two[0] >= angle)
    return before + (after - before) * (angle - a) / (b - a)


class Lumped(ProgramTest):
    def lumped(self, actuator, *more):
        folder, said = export(actuator, "lumped", self.folder / "lumped", *more)
        return folder / "lumped_model.json", said

    def assert_same_performance(self, design, lumped, cold="_cold"):
        one, other = evaluated(design, 1.4), evaluated(lumped, 1.4)
        self.assertAlmostEqual(other["rest_angle_deg"], one["rest_angle_deg"], delta=1e-6)
        self.assertAlmostEqual(other["steady_angle_deg"], one[f"steady_angle{cold}_deg"], delta=ANGLE)
        speed = one[f"peak_bending_speed{cold}_deg_s"]
        self.assertAlmostEqual(other["peak_bending_speed_deg_s"], speed, delta=SPEED * speed)
        force = one[f"grasp_force{cold}_N"]
        self.assertAlmostEqual(other["grasp_force_N"], force, delta=SPEED * force)

    def test_it_evaluates_to_what_the_design_evaluates_to(self):
        for design in (FINGER, PAPER_FINGER):
            with self.subTest(design.name):
                self.assert_same_performance(design, self.lumped(design)[0])

    def test_it_moves_as_the_design_moves(self):
        lumped, _ = self.lumped(FINGER)
        one, other = motion(FINGER, self.folder, "design.csv"), motion(lumped, self.folder, "lumped.csv")
        self.assertEqual(len(one), len(other))
        self.assertGreater(max(angle for _, angle in one), 90)
        # Swinging at 6.6 Hz over 35 deg, frequencies apart by half of the torque's 1e-4 are apart in phase at the end.
        largest = max(abs(a - b) for (_, a), (_, b) in zip(one, other))
        self.assertLess(largest, 0.02)

    def test_effects_tilt_and_differences_as_built_come_along(self):
        design = changed_finger(
            self.folder, surroundings={"base_tilt_deg": 20},
            effects=[{"id": "quadratic_drag", "parameters": {"drag_Nmms2_rad2": 0.002}},
                     {"id": "base_tilt", "parameters": {"angle_deg": 5}},
                     {"id": "rest_angle", "parameters": {"angle_deg": 3}}],
            as_built={"force_curve": {"from_deg": 0, "to_deg": 60, "coefficients": [0, 0.05, -0.02, 0.01]},
                      "joint_stiffness_ratio": 0.1, "joint_damping_ratio": -0.07, "face_closing_shift_deg": -0.6})
        lumped, said = self.lumped(design)
        self.assert_same_performance(design, lumped)
        written = json.loads(lumped.read_text())
        self.assertEqual({effect["id"]: effect["parameters"] for effect in written["effects"]},
                         {"quadratic_drag": {"drag_Nmms2_rad2": 0.002}, "base_tilt": {"angle_deg": 25},
                          "rest_angle": {"angle_deg": 3}})
        self.assertNotIn("as_built", written)  # it is in the numbers
        self.assertNotIn("effect", said)

    def test_a_torque_correction_comes_along(self):
        correction = {"angle_deg": [-5, 10, 25, 40, 60], "torque_Nmm": [0.1, 0.2, 0.4, 0.5, 0.3]}
        design = changed_finger(self.folder, torque_correction=correction)
        lumped, _ = self.lumped(design)
        self.assert_same_performance(design, lumped)
        written = json.loads(lumped.read_text())["torque_correction"]
        self.assertEqual({key: value for key, value in written.items() if key != "note"}, correction)

    def test_an_effect_on_the_curves_alone_is_built_into_the_tables(self):
        paper = json.loads(PAPER_FINGER.read_text()) | {"effects": [{"id": "off_axis_force", "parameters": {}}]}
        self.write("paper.json", json.dumps(paper))
        lumped, said = self.lumped(self.folder / "paper.json")
        self.assert_same_performance(self.folder / "paper.json", lumped)
        self.assertNotIn("off_axis_force", said)
        exact = torque_at(lumped, 60)
        approximate = torque_at(self.lumped(PAPER_FINGER)[0], 60)
        # The line of centres is 9.2 % short of the whole wrench of this pair at 60 deg (docs/theory/systems.md).
        self.assertAlmostEqual(approximate / exact, 0.908, delta=0.001)

    def test_what_it_cannot_say_is_named_in_the_file_and_printed(self):
        design = changed_finger(self.folder, effects=[{"id": "coil_coil_force", "parameters": {}}])
        lumped, said = self.lumped(design)
        for words in ("effect coil_coil_force", "the coils' resistance of 3.763 Ohm", "heat: everything is at 20 degC"):
            self.assertIn(f"lumped_model.json leaves out {words}", said)
            self.assertIn(words, json.loads(lumped.read_text())["description"])

    def test_magnets_that_pull_at_each_other_are_told_with_what_that_means(self):
        self.assert_refused(["export", str(FINGER), "--set", "configuration=C", "--as", "lumped", "--out", "out"],
                            f"{FINGER}: links with a torque curve for each joint cannot have forces between parts that are "
                            "not neighbours, which make up to 85.9 Nmm on a joint of this actuator (neighbours 16.8 Nmm at "
                            "1 A); --incomplete writes what would move otherwise all the same")
        lumped, said = self.lumped(FINGER, "--set", "configuration=C", "--incomplete")
        self.assertRegex(said, r"the pull between magnets: up to -8\d\.\d Nmm on a joint")
        self.assertIn("so much that its motion is not the actuator's", said)
        self.assertIn("that the currents of joints 2 and 3 are of one coil", said)
        self.assertIn("not the actuator's", json.loads(lumped.read_text())["description"])

    def test_a_joint_between_two_coils_has_no_table(self):
        lumped, _ = self.lumped(FINGER, "--set", "configuration=D", "--incomplete")
        self.assertEqual([pair is None for pair in json.loads(lumped.read_text())["magnetics"]],
                         [False, False, True, False, False])

    def test_a_lumped_model_may_be_exported_again(self):
        first = DATA / "formats" / "lumped_model.json"
        again, _ = self.lumped(first)
        self.assert_same_performance(first, again, cold="")

    def test_a_tilt_beyond_the_effect_s_bounds_is_refused(self):
        design = changed_finger(self.folder, surroundings={"base_tilt_deg": 60})
        self.assert_refused(["export", str(design), "--as", "lumped", "--out", "out"],
                            f"{design}: a lumped model is tilted by the effect base_tilt, which must be from -45 to 45 deg; "
                            "got 60")


if __name__ == "__main__":
    unittest.main()
