"""`coilwright crawl`: the paper's robot, and every way to get the input wrong."""

import json
import unittest

from program import DATA, PAPER_FINGER, ProgramTest, run

FEET = ["--friction-forwards", "0.3", "--friction-backwards", "0.6"]


class Crawl(ProgramTest):
    def crawl(self, *options):
        result = run("crawl", PAPER_FINGER, *FEET, "--settling-periods", "4", "--periods", "6", "--json", *options)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def test_the_paper_s_robot(self):
        answer = self.crawl()
        self.assertAlmostEqual(answer["crawler_mass_g"], 91, delta=1)
        self.assertAlmostEqual(answer["coil_current_A"], 1.05, delta=0.005)
        self.assertAlmostEqual(answer["power_W"], 4.41, delta=0.03 * 4.41)  # less what motion induces
        # The cell is empty after its capacity over the mean current.
        self.assertAlmostEqual(answer["run_time_s"] * answer["mean_cell_current_A"], 540, places=9)
        self.assertAlmostEqual(answer["distance_per_charge_m"], answer["speed_mm_s"] * answer["run_time_s"] / 1000)
        losses = sum(answer[key] for key in ("hinge_loss_mW", "friction_loss_mW", "impact_loss_mW", "stored_mW"))
        self.assertAlmostEqual(answer["mechanical_mW"], losses + answer["unbalanced_mW"], places=9)
        self.assertLess(abs(answer["unbalanced_mW"]), 1e-3 * answer["mechanical_mW"])
        for point in ("rear_end", "joint1", "joint2", "front_end"):
            self.assertGreaterEqual(answer[f"lift_{point}_mm"], 0)

    def test_the_table_has_the_numbers_of_the_json(self):
        answer = self.crawl()
        table = run("crawl", PAPER_FINGER, *FEET, "--settling-periods", "4", "--periods", "6").stdout.splitlines()
        self.assertEqual([line.split()[0] for line in table], list(answer))
        for line in table:
            key, printed = line.split()
            if answer[key] is None:
                self.assertEqual((printed, key.endswith("time_to_limit_s")), ("never", True))
                continue
            self.assertAlmostEqual(float(printed), answer[key], delta=1e-4 * abs(answer[key]))  # five digits

    def test_heat_of_the_coils(self):
        answer = self.crawl()
        # Power of two coils in parallel at 20 degC, by the resistance of evaluate.
        coil = json.loads(run("evaluate", PAPER_FINGER, "--current-A", "1", "--json").stdout)["coil_resistance_Ohm"]
        self.assertAlmostEqual(answer["coil_rms_current_A"], (answer["copper_heat_mW"] / 2000 / coil) ** 0.5, places=6)
        # Straight, as drive says it of the same finger.
        drive = json.loads(run("drive", PAPER_FINGER, "--duty", "0.1", "--json").stdout)
        self.assertAlmostEqual(answer["continuous_current_A"], drive["straight_continuous_current_A"], places=9)
        self.assertLess(answer["coil_rms_current_A"], answer["continuous_current_A"])
        self.assertIsNone(answer["time_to_limit_s"])

    def test_says_when_a_part_is_too_hot_before_the_cell_is_empty(self):
        hot = run("crawl", PAPER_FINGER, *FEET, "--cell-voltage-V", "8", "--cell-limit-A", "30", "--settling-periods", "2",
                  "--periods", "2")
        self.assertRegex(hot.stderr, r"\AMIND: coils of 1\.\d+ A rms bring a coil or a magnet to its limit \d+ s after a cold "
                                     r"start, before the cell is empty \(\d+ s\); for good they bear 0\.958 A\.\n\Z")
        fan = run("crawl", PAPER_FINGER, *FEET, "--cell-capacity-mAh", "1000", "--settling-periods", "2", "--periods", "2")
        self.assertTrue(fan.stderr.startswith("MIND: in air that stands still, coils of 0.7"), fan.stderr)

    def test_twice_the_capacity_is_twice_the_way(self):
        one, two = self.crawl("--cell-capacity-mAh", "75"), self.crawl()
        self.assertAlmostEqual(two["distance_per_charge_m"], 2 * one["distance_per_charge_m"], places=9)

    def test_bad_input_is_one_line(self):
        def usage(fault):
            return f"crawl: {fault} (see coilwright crawl --help)"

        for arguments, message in (
            (["--friction-forwards", "0", "--friction-backwards", "0.6"], usage('--friction-forwards: must be > 0 and <= 10; got "0"')),
            ([*FEET, "--frequency-Hz", "0"], usage('--frequency-Hz: must be from 0.1 to 1000; got "0"')),
            ([*FEET, "--duty", "1"], usage('--duty: must be > 0 and < 1; got "1"')),
            ([*FEET, "--periods", "0"], usage('--periods: must be from 1 to 10000; got "0"')),
            ([*FEET, "--cell-limit-A", "1.5"],
             f"{PAPER_FINGER}: cell: the current of a pulse, 2.099 A through 2 coils, must not exceed its limit of 1.5 A"),
        ):
            with self.subTest(message):
                self.assert_refused(["crawl", PAPER_FINGER, *arguments], message)

    def test_a_lumped_model_and_effects_at_work_are_refused(self):
        lumped = DATA / "formats" / "lumped_model.json"
        self.assert_refused(["crawl", lumped, *FEET], f"{lumped}: is a lumped model: a crawler needs a design (actuator/1)")
        self.assert_refused(["crawl", PAPER_FINGER, *FEET, "--set", "current_share_2=0.5"],
                            f"{PAPER_FINGER}: coil.current_share_2 must be 1: a cell through one switch drives all coils alike; got 0.5")
        design = json.loads(PAPER_FINGER.read_text())
        design["effects"] = [{"id": "coil_lag", "parameters": {"time_constant_ms": 10}}]
        self.write("lag.json", json.dumps(design))
        self.assert_refused(["crawl", "lag.json", *FEET],
                            "lag.json: crawler: the actuator must have no effects that act while it runs; got 1")


if __name__ == "__main__":
    unittest.main()
