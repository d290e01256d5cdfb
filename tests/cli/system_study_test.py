"""Studies of a gripper and of a crawling robot: what they find is what `grip` and `crawl` say of it."""

import json
import unittest

from program import ProgramTest, run
from study import write_study

GRIPPER = {"shape": "cylinder", "width_mm": 62, "mass_g": 90, "friction": 0.7, "centre_below_palm_mm": 15,
           "mounting_angle_deg": 28, "open_current_A": -0.8, "acceleration_m_s2": 1.5}
CRAWLER = {"friction_forwards": 0.25, "friction_backwards": 0.5, "cell_voltage_V": 4, "cell_capacity_mAh": 180,
           "cell_limit_A": 4, "lead_resistance_Ohm": 0.2, "payload_mass_g": 25, "payload_length_mm": 28, "step_ms": 0.2,
           "settling_periods": 2, "periods": 3}
# A block's millimetres are divided by 1000, an option's multiplied by 0.001: the last bit differs, and friction that
# turns multiplies it by some ten thousands.
SAME = 1e-9


def options(block, names):
    return [word for key in names for word in (f"--{key.replace('m_s2', 'm/s2').replace('_', '-').replace('m/s2', 'm_s2')}",
                                               str(block[key]))]


class SystemStudy(ProgramTest):
    def study(self, **changes):
        write_study(self, **{"constraints": None, **changes})
        result = run("size", "study.json", "--out", "out", "--force", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return self.result("out/result.json")

    def assert_same(self, found, keys, answer):
        for quantity, key, factor in keys:
            with self.subTest(quantity):
                self.assertAlmostEqual(found[quantity], answer[key] * factor, delta=SAME * abs(found[quantity]))

    def test_grip_says_the_same_of_the_gripper_found(self):
        answer = self.study(
            gripper={**GRIPPER, "spacing_mm": 70}, operating_point={"duty": 1},
            variables={"current_A": {"values": [1, 1.4]}, "turns_radial": {"lower": 14, "upper": 15},
                       "gripper_spacing_mm": {"values": [60, 65, 70]}},
            objectives=[{"minimise": "gripper_mass_g"}],
            constraints=[{"quantity": "grip_margin", "at_least": 0.1}],
            columns=[{"quantity": name} for name in (
                "grip_load_N", "grip_capacity_N", "grip_closing_time_ms", "grip_magnet_force_N", "grip_thermal_load",
                "grip_continuous_current_A", "grip_normal_force_N")])
        self.assertTrue(answer["feasible"])
        found, variables = answer["performance"], answer["best"]["variables"]
        block = {**GRIPPER, "spacing_mm": variables["gripper_spacing_mm"], "current_A": variables["current_A"]}
        arguments = options(block, block)
        said = json.loads(run("grip", "out/actuator.json", *arguments, "--json", cwd=self.folder).stdout)
        self.assertTrue(said["holds"])
        self.assert_same(found, (
            ("grip_load_N", "load_N", 1), ("grip_capacity_N", "capacity_N", 1),
            ("grip_closing_time_ms", "closing_time_ms", 1), ("grip_magnet_force_N", "magnet_force_N", 1),
            ("grip_continuous_current_A", "continuous_current_A", 1)), said)
        self.assertAlmostEqual(found["grip_margin"], said["capacity_N"] / said["load_N"] - 1, delta=1e-8)
        self.assertAlmostEqual(found["grip_thermal_load"], variables["current_A"] / said["continuous_current_A"],
                               delta=1e-9)
        pressed = [sum(each["normal_N"] for each in said["contacts"] if each["finger"] == side)
                   for side in ("left", "right")]
        self.assertAlmostEqual(found["grip_normal_force_N"], min(pressed), delta=1e-8)

    def test_grip_finds_the_same_least_current(self):
        block = {**GRIPPER, "mass_g": 40, "least_current_up_to_A": 1.3}
        write_study(self, gripper=block, operating_point={"current_A": 1}, variables={"turns_axial": {"values": [30]}},
                    objectives=[{"minimise": "grip_least_current_A"}], constraints=None)
        said = json.loads(run("grip", "finger.json", *options(block, block), "--json", cwd=self.folder).stdout)
        answer = json.loads(run("sweep", "study.json", "--out", "out", "--force", "--json", cwd=self.folder).stdout)
        found = answer["best"][0]["objectives"]["grip_least_current_A"]
        self.assertAlmostEqual(found, said["least_current_A"], delta=SAME)
        self.assertTrue(0.1 < found < 1.3)

    def test_crawl_says_the_same_of_the_robot_found(self):
        answer = self.study(
            crawler=CRAWLER, operating_point={"current_of": "crawler"},
            variables={"gap_mm": {"values": [0.8, 0.9]}, "crawler_frequency_Hz": {"lower": 8, "upper": 9.5, "step": 0.5},
                       "crawler_duty": {"values": [0.4, 0.5]}},
            objectives=[{"maximise": "crawl_speed_mm_s"}],
            columns=[{"quantity": name} for name in (
                "crawler_mass_g", "crawl_speed_scatter_mm_s", "crawl_coil_current_A", "crawl_mean_current_A",
                "crawl_power_W", "crawl_run_time_s", "crawl_distance_per_charge_m", "crawl_largest_bending_deg",
                "crawl_smallest_bending_deg")])
        found, variables = answer["performance"], answer["best"]["variables"]
        block = {**CRAWLER, "frequency_Hz": variables["crawler_frequency_Hz"], "duty": variables["crawler_duty"]}
        said = json.loads(run("crawl", "out/actuator.json", *options(block, block), "--json", cwd=self.folder).stdout)
        self.assert_same(found, tuple((quantity, key, 1) for quantity, key in (
            ("crawler_mass_g", "crawler_mass_g"), ("crawl_speed_mm_s", "speed_mm_s"),
            ("crawl_coil_current_A", "coil_current_A"),
            ("crawl_mean_current_A", "mean_cell_current_A"), ("crawl_power_W", "power_W"),
            ("crawl_run_time_s", "run_time_s"), ("crawl_distance_per_charge_m", "distance_per_charge_m"),
            ("crawl_largest_bending_deg", "largest_bending_deg"),
            ("crawl_smallest_bending_deg", "smallest_bending_deg"))), said)
        # The finger's own figures are those of the crawler's drive.
        self.assertEqual(found["current_A"], found["crawl_coil_current_A"])
        self.assertEqual(answer["operating_point"]["duty"], variables["crawler_duty"])

    def test_the_blocks_have_the_defaults_of_the_commands(self):
        grip, crawl = {"width_mm": 60, "mass_g": 40, "friction": 0.8}, {"friction_forwards": 0.3, "friction_backwards": 0.6}
        answer = self.study(gripper=grip, crawler=crawl, operating_point={"current_A": 1.4},
                            variables={"turns_axial": {"values": [30]}}, objectives=[{"maximise": "grip_margin"}],
                            columns=[{"quantity": name} for name in (
                                "grip_capacity_N", "grip_closing_time_ms", "crawl_speed_mm_s", "crawl_run_time_s")])
        for command, block, keys in (
            ("grip", grip, (("grip_capacity_N", "capacity_N", 1), ("grip_closing_time_ms", "closing_time_ms", 1))),
            ("crawl", crawl, (("crawl_speed_mm_s", "speed_mm_s", 1), ("crawl_run_time_s", "run_time_s", 1))),
        ):
            said = json.loads(run(command, "out/actuator.json", *options(block, block), "--json", cwd=self.folder).stdout)
            self.assert_same(answer["performance"], keys, said)

    def test_one_thread_and_two_find_the_same(self):
        write_study(self, gripper=GRIPPER, constraints=[{"quantity": "grip_margin", "at_least": 0}],
                    objectives=[{"minimise": "gripper_mass_g"}, {"minimise": "grip_thermal_load"}],
                    search={"max_evaluations": 40, "seed": 2})
        tables = []
        for threads in ("1", "2"):
            result = run("pareto", "study.json", "--out", threads, "--force", "--threads", threads, cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            tables.append((self.folder / threads / "evaluations.csv").read_text())
        self.assertEqual(*tables)

    def test_a_sweep_names_what_becomes_of_each_design(self):
        write_study(self, gripper={**GRIPPER, "mass_g": 60}, operating_point={"current_A": 1.4},
                    variables={"gripper_width_mm": {"values": [5, 62, 120]}, "gripper_friction": {"values": [0.1, 0.9]}},
                    objectives=[{"maximise": "grip_margin"}],
                    constraints=[{"quantity": "grip_margin", "at_least": 0}])
        result = run("sweep", "study.json", "--out", "out", "--force", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        rows = [line.split(",") for line in (self.folder / "out/designs.csv").read_text().splitlines()]
        status, margin = rows[0].index("status"), rows[0].index("grip_margin")
        self.assertEqual([row[status] for row in rows[1:]],
                         ["infeasible", "infeasible", "infeasible", "ok", "failed", "failed"])
        self.assertLess(float(rows[1][margin]), -1)
        self.assertTrue(-1 < float(rows[3][margin]) < 0)
        self.assertIn("object must leave the open fingers free", rows[5][-1])

    def test_a_cell_that_cannot_supply_the_pulse_is_a_failure_with_a_name(self):
        write_study(self, crawler={**CRAWLER, "cell_limit_A": 1.2}, operating_point={"current_of": "crawler"},
                    variables={"turns_axial": {"values": [29, 30]}}, objectives=[{"maximise": "crawl_speed_mm_s"}],
                    constraints=None)
        result = run("size", "study.json", "--out", "out", "--force", cwd=self.folder)
        self.assertEqual(result.returncode, 3)
        self.assertIn("crawl_speed_mm_s has no value: cell: the current of a pulse,", result.stdout)

    def test_size_says_what_pulses_add_to_a_limit_that_knows_nothing_of_them(self):
        driver = {"kind": "h_bridge", "voltage_V": 24, "frequency_Hz": 490}
        answer = self.study(driver=driver, operating_point={"current_A": 0.8}, variables={"gap_mm": {"values": [0.9, 1]}},
                            constraints=[{"quantity": "thermal_load", "at_most": 1}])
        self.assertTrue(answer["feasible"])
        limit = {row["quantity"]: row for row in answer["part_limits"]}["driver_thermal_load"]
        self.assertGreater(limit["value"], 1)
        text = run("size", "study.json", "--out", "out", "--force", cwd=self.folder).stdout
        self.assertRegex(text, r"by its driver, on for 0\.\d+ of a period: the ripple makes \d+ % more heat")
        self.assertIn('{"quantity": "driver_thermal_load", "at_most": 1}', text)
        write_study(self, driver={**driver, "voltage_V": 2}, operating_point={"current_A": 0.8}, variables={"gap_mm": {"values": [0.9, 1]}},
                    constraints=None)
        result = run("size", "study.json", "--out", "weak", cwd=self.folder)
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertIn("the driver cannot give the current: raise driver.voltage_V or lower current_A; got 0.", result.stdout)


if __name__ == "__main__":
    unittest.main()
