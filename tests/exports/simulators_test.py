"""`coilwright export --as mjcf` and `--as urdf`: in MuJoCo the files rest, swing and jump as the program says.

MuJoCo's equation of motion shares nothing with the program's. Skipped where libmujoco-dev or liburdfdom-tools is not
installed when the tests are configured or run. IN_MUJOCO is the program of in_mujoco.cpp.
"""

import json
import math
import os
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as xml

from exported import FINGER, PAPER_FINGER, changed_finger, evaluated, export, linear, skip_without
from program import ProgramTest

IN_MUJOCO = os.environ.get("IN_MUJOCO", "")

# Straight lines between the rows miss by at most 5e-4 of the largest torque; at the steady angle a finger has 0.6 of that
# torque, and 18 deg/A: at 1.4 A within 18 * 1.4 * 5e-4 / 0.6 deg. Speed: the same share of the torque, and a sample each
# 0.1 ms of a peak that is flat within 5 ms.
ANGLE = math.radians(0.021)
SPEED = 5e-4

# Of the largest entry: central differences of 1e-6, in a sum of roundings of 1e-16 times 1e4 / 1e-6 on both sides.
MATRIX = 1e-6


def in_mujoco(model, folder, current, joints=False):
    more = [folder / "joints.csv"] if joints else []
    done = subprocess.run([IN_MUJOCO, folder / model, folder / "torque.csv", str(current), *more], capture_output=True,
                          text=True, timeout=900, check=False)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class Simulators(ProgramTest):
    def assert_same(self, found, reference, current, speed_key):
        """Equilibria, the equation of motion about them, and the fastest bending after a step."""
        for pose, driven in ((linear(reference, 0), "rest"), (linear(reference, current), "driven")):
            angles = [math.radians(angle) for angle in pose["joint_angles_deg"]]
            for one, other in zip(found[f"{driven}_angles"], angles, strict=True):
                self.assertAlmostEqual(one, other, delta=1e-8 if driven == "rest" else ANGLE)
            if driven == "driven":
                continue  # straight lines have other slopes than the curve
            n = len(angles)
            for first, matrix in ((0, found["rest_by_angle"]), (n, found["rest_by_rate"])):
                expected = [pose["A"][n + i][first + j] for j in range(n) for i in range(n)]
                for one, other in zip(matrix, expected, strict=True):
                    self.assertAlmostEqual(one, other, delta=MATRIX * max(map(abs, expected)))
        speed = math.radians(evaluated(reference, current)[speed_key])
        self.assertAlmostEqual(found["fastest"][0], speed, delta=SPEED * speed)

    def assert_both_same(self, actuator, speed="peak_bending_speed_cold_deg_s"):
        mjcf, _ = export(actuator, "mjcf", self.folder / "mjcf")
        self.assert_same(in_mujoco("actuator.xml", mjcf, 1.4), actuator, 1.4, speed)
        urdf, _ = export(actuator, "urdf", self.folder / "urdf")
        self.assert_same(in_mujoco("actuator.urdf", urdf, 1.4, joints=True), actuator, 1.4, speed)

    def test_the_finger_rests_swings_and_jumps_as_the_program_says(self):
        self.assert_both_same(FINGER)

    def test_so_does_the_paper_s_finger_of_point_masses(self):
        self.assert_both_same(PAPER_FINGER)

    def test_so_do_a_tilted_base_and_joints_that_are_not_alike_and_rest_bent(self):
        self.assert_both_same(changed_finger(
            self.folder, surroundings={"base_tilt_deg": 25},
            effects=[{"id": "rest_angle", "parameters": {"angle_deg": 4}}],
            as_built={"joint_stiffness_ratio": 0.3, "joint_damping_ratio": -0.2}))

    def test_so_does_a_finger_in_another_gravity(self):
        """In MJCF: URDF has no gravity."""
        moon = changed_finger(self.folder, surroundings={"gravity_m_s2": 1.62})
        mjcf, _ = export(moon, "mjcf", self.folder / "mjcf")
        self.assert_same(in_mujoco("actuator.xml", mjcf, 1.4), moon, 1.4, "peak_bending_speed_cold_deg_s")

    def test_so_does_a_chain_of_five_joints_one_of_them_without_a_coil_and_none_with_a_stop(self):
        """As a lumped model, which leaves out the same forces; stops yield in another way while they are hit."""
        folder, _ = export(FINGER, "lumped", self.folder / "lumped", "--set", "configuration=D", "--incomplete")
        model = json.loads((folder / "lumped_model.json").read_text())
        for joint in model["joints"]:
            del joint["contact"]
        self.write("free.json", json.dumps(model))
        self.assert_both_same(self.folder / "free.json", speed="peak_bending_speed_deg_s")

    def test_faces_press_at_rest_with_their_stiffness(self):
        mjcf, _ = export(FINGER, "mjcf", self.folder / "mjcf")
        found = in_mujoco("actuator.xml", mjcf, -1.4)["end_angles"]
        expected = [math.radians(angle) for angle in linear(FINGER, -1.4)["joint_angles_deg"]]
        self.assertTrue(all(angle < 0 for angle in expected))
        for one, other in zip(found, expected, strict=True):  # straight lines: 5e-4 of the torque
            self.assertAlmostEqual(one, other, delta=1e-3 * abs(other))

    def test_the_model_s_own_data_are_those_of_the_table(self):
        mjcf, _ = export(FINGER, "mjcf", self.folder / "mjcf")
        data = {node.get("name"): [float(word) for word in node.get("data").split()]
                for node in xml.parse(mjcf / "actuator.xml").iter("numeric")}
        rows = [list(map(float, line.split(","))) for line in (mjcf / "torque.csv").read_text().splitlines()[1:]]
        for pair in (1, 2):
            own = [row for row in rows if row[:2] == [data[f"pair{pair}_joint"][0], data[f"pair{pair}_coil"][0]]]
            self.assertEqual([row[2] for row in own], data[f"pair{pair}_angle_rad"])
            self.assertEqual([row[3] for row in own], data[f"pair{pair}_torque_Nm_A"])
            self.assertGreater(len(own), 60)

    def test_urdf_is_taken_by_its_checker_and_has_the_springs_for_gazebo(self):
        urdf, _ = export(FINGER, "urdf", self.folder / "urdf")
        done = subprocess.run(["check_urdf", urdf / "actuator.urdf"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"(?s)root Link: world.*base.*link1.*link2")
        springs = {node.get("reference"): (float(node.findtext("springStiffness")), float(node.findtext("springReference")))
                   for node in xml.parse(urdf / "actuator.urdf").iter("gazebo")}
        self.assertEqual(springs, {"joint1": (0.0125, 0.0), "joint2": (0.0125, 0.0)})

    def test_what_they_leave_out_is_named_in_the_file_and_printed(self):
        design = changed_finger(self.folder, name="a -- b <&> \"c\"",
                                effects=[{"id": "quadratic_drag", "parameters": {"drag_Nmms2_rad2": 0.002}}])
        for kind, name in (("mjcf", "actuator.xml"), ("urdf", "actuator.urdf")):
            folder, said = export(design, kind, self.folder / kind)
            text = (folder / name).read_text()
            for words in ("effect quadratic_drag: drag that grows", "heat: everything is at 20 degC",
                          "inertia about the axes in the plane of bending"):
                self.assertIn(f"{name} leaves out {words}", said)
                self.assertIn(f"Left out: {words}", text)
            root = xml.fromstring(text)  # whatever the name
            self.assertEqual(root.get("model" if kind == "mjcf" else "name"), 'a -- b <&> "c"')


if __name__ == "__main__":
    skip_without([] if IN_MUJOCO else ["libmujoco-dev"])
    skip_without([] if shutil.which("check_urdf") else ["liburdfdom-tools"])
    unittest.main()
