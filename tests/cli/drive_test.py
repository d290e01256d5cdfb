"""Coils under pulses from a supply or a cell."""

import csv
import json
import pathlib
import tempfile
import unittest

from program import PAPER_FINGER as FINGER
from program import ProgramTest, run

CELL = ("--cell-voltage-V", "4.2", "--cell-capacity-mAh", "150")


def answer(*arguments):
    return json.loads(run("drive", FINGER, *arguments, "--json").stdout)


def leaves(node):
    for key, value in node.items() if isinstance(node, dict) else enumerate(node):
        if isinstance(value, (dict, list)):
            yield from leaves(value)
        elif isinstance(value, float) and isinstance(key, str):
            yield key, value


class Drive(ProgramTest):
    def test_a_name_that_is_of_the_finger_alone_has_one_meaning(self):
        # What no current and no duty changes is no figure of a pose, a drive or a use: whichever command says it, it is the same.
        cold, warm = (dict(leaves(json.loads(run("evaluate", FINGER, "--current-A", current, "--duty", duty, "--json").stdout)))
                      for current, duty in (("0.5", "0.3"), ("1.2", "0.7")))
        shared = set()
        for command in (("drive", FINGER, "--duty", "0.1"), ("grip", FINGER, "--width-mm", "60", "--mass-g", "40", "--friction", "0.8"),
                        ("crawl", FINGER, "--friction-forwards", "0.3", "--friction-backwards", "0.6", "--periods", "2"),
                        ("linearise", FINGER, "--current-A", "1")):
            for name, value in leaves(json.loads(run(*command, "--json").stdout)):
                if name not in cold:
                    continue
                shared.add(name)
                if cold[name] == warm[name]:
                    self.assertAlmostEqual(value / cold[name], 1, places=6, msg=f"{command[0]}: {name}")
        self.assertGreater(len(shared), 5)

    def test_says_which_duty_gives_a_mean_current(self):
        text = run("drive", FINGER, "--mean-A", "1.4", "--wiring", "series", "--actuators", "2").stdout
        self.assertIn("H-bridge of 24 V, 4 coils in series, 490 Hz, slow decay, coils at 20 degC\n", text)
        self.assertRegex(text, r"\nDuty 0\.9\d+ gives 1\.4 A of mean current in a coil\.\n")
        self.assertIn("The rms current of 1.4113 A is above the continuous current of 1.1 A: do not hold it for good.\n", text)
        found = answer("--mean-A", "1.4", "--wiring", "series", "--actuators", "2")
        self.assertAlmostEqual(found["coil"]["mean_A"], 1.4, places=8)
        self.assertEqual(found["coil"], found["driver"])

    def test_balances_its_power(self):
        power = answer("--duty", "0.3", "--decay", "fast")["power"]
        self.assertAlmostEqual(power["supply_W"],
                               power["coils_W"] + power["switches_W"] + power["diodes_W"] + power["inside_supply_W"],
                               places=9)
        self.assertGreater(power["coils_W"], power["coils_by_mean_current_W"])

    def test_drives_by_a_cell(self):
        text = run("drive", FINGER, "--duty", "0.5", "--frequency-Hz", "10", *CELL).stdout
        self.assertIn("Cell with a switch of 4.2 V", text)
        self.assertRegex(text, r"\nThe cell lasts [\d.]+ min\.\n")
        self.assertIn("The current is discontinuous: it is zero for ", text)

    def test_finds_the_voltage_at_a_duty(self):
        found = answer("--duty", "0.5", "--mean-A", "1")
        self.assertAlmostEqual(answer("--duty", "0.5", "--supply-voltage-V", found["supply_voltage_V"])["coil"]["mean_A"],
                               1.0, places=8)

    def test_says_that_a_current_is_out_of_reach(self):
        text = run("drive", FINGER, "--mean-A", "5", "--supply-voltage-V", "5").stdout
        self.assertRegex(text, r"5 A of mean current are out of reach: 5 V at duty 1 give [\d.]+ A\. "
                               r"Raise --supply-voltage-V\.\n")
        self.assertIn("out_of_reach", answer("--mean-A", "5", "--supply-voltage-V", "5")["warnings"])

    def test_a_warm_coil_carries_less(self):
        cold = answer("--duty", "0.4", "--supply-voltage-V", "9")
        warm = answer("--duty", "0.4", "--supply-voltage-V", "9", "--warm")
        self.assertLess(warm["coil"]["mean_A"], cold["coil"]["mean_A"])
        self.assertGreater(warm["coil_temperature_degC"], 20.0)

    def test_follows_the_motion(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "motion.csv"
            arguments = ("--mean-A", "1.0", "--supply-voltage-V", "9", "--frequency-Hz", "2000", "--motion-s", "0.1",
                         "--out", str(out))
            motion = answer(*arguments)["motion"]
            with out.open(encoding="utf-8") as table:
                rows = list(csv.DictReader(table))
            self.assertEqual(len(rows), 101)
            self.assertAlmostEqual(float(rows[-1]["time_s"]), 0.1, places=12)
            self.assertAlmostEqual(float(rows[0]["bending_angle_deg"]), motion["start_bending_deg"], places=9)
            self.assertAlmostEqual(float(rows[-1]["bending_angle_deg"]), motion["end_bending_deg"], places=9)
            self.assertEqual(rows[0]["driver_mean_A"], "")
            # Two coils in parallel; the motion's own voltage takes a little of the current while it opens.
            self.assertAlmostEqual(float(rows[40]["driver_mean_A"]), 2.0, delta=0.2)
            spent = sum(motion[key] for key in ("coils_J", "switches_J", "diodes_J", "inside_supply_J", "work_J",
                                                "field_J"))
            self.assertAlmostEqual(spent / motion["supply_J"], 1.0, places=5)
            self.assertIn("\nPulses from rest for 0.1 s: bending 21.07 deg before, ", run("drive", FINGER, *arguments).stdout)

    def test_follows_how_the_actuator_warms(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "warm_up.csv"
            arguments = ("--mean-A", "1.4", "--warm-up-s", "600", "--out", str(out))
            found = answer(*arguments)["warm_up"]
            with out.open(encoding="utf-8") as table:
                rows = list(csv.DictReader(table))
            self.assertEqual(len(rows), 601)
            self.assertEqual(float(rows[0]["coil1_degC"]), found["start"]["coil_temperature_degC"])
            self.assertEqual(float(rows[-1]["mean_current_A"]), found["end"]["mean_current_A"])
            means = [float(row["mean_current_A"]) for row in rows]
            self.assertEqual(means, sorted(means, reverse=True))
            limit = found["first_limit"]
            spots = {"coil": "coil_hot_spot_degC", "magnet": "magnet_temperature_degC"}
            before, after = (float(rows[int(limit["time_s"]) + i][spots[limit["part"]]]) for i in (0, 1))
            self.assertTrue(before <= limit["limit_degC"] <= after, (before, limit, after))
            text = run("drive", FINGER, *arguments).stdout
            self.assertRegex(text, r"\nHeld for 600 s with every joint at 30 deg, from 2\d degC: coils of [\d.]+ degC \([\d.]+ at their hottest place\), "
                                   r"magnets of [\d.]+ degC; the mean current in a coil goes from 1\.\d+ to 0\.\d+ A, and "
                                   r"the force with it\.\n(Coil|Magnet) \d is the first to pass its limit, \d+ degC, after "
                                   r"[\d.]+ s: do not hold it longer\.\n$")

    def test_says_where_copper_would_melt(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "warm_up.csv"
            text = run("drive", FINGER, "--mean-A", "8", "--supply-voltage-V", "200", "--warm-up-s", "3600", "--out", str(out)).stdout
            self.assertRegex(text, r"\nCopper would melt after [\d.]+ s, where this ends\.\n$")

    def test_follows_no_cell_that_is_empty(self):
        tiny = ("--mean-A", "0.5", "--cell-voltage-V", "4.2", "--cell-capacity-mAh", "0.1")
        lasts = answer(*tiny)["run_time_s"]
        self.assertLess(lasts, 1)
        for option in ("--motion-s", "--warm-up-s"):
            with tempfile.TemporaryDirectory() as folder:
                result = run("drive", FINGER, *tiny, option, "3", "--out", f"{folder}/out.csv")
                self.assertEqual((result.returncode, result.stdout, list(pathlib.Path(folder).iterdir())), (2, "", []))
                self.assertEqual(result.stderr, f"coilwright: drive: {option}: must be at most {lasts:.5g} s, which the cell "
                                                "lasts; got 3 (see coilwright drive --help)\n")
                self.assertEqual(run("drive", FINGER, *tiny, option, f"{0.9 * lasts}", "--out", f"{folder}/out.csv").returncode, 0)

    def test_another_file_is_kept_and_its_own_kind_replaced(self):
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out.csv"
            for option in ("--motion-s", "--warm-up-s"):
                out.write_text("my notes\n", encoding="utf-8")
                command = ("drive", FINGER, "--mean-A", "1", option, "0.1", "--out", str(out))
                result = run(*command)
                self.assertEqual((result.returncode, result.stderr),
                                 (2, f"coilwright: {out}: cannot be written: it holds something else; --force replaces it, "
                                     "another --out keeps it\n"))
                self.assertEqual(out.read_text(encoding="utf-8"), "my notes\n")
                self.assertEqual(run(*command, "--force").returncode, 0)
                self.assertEqual(run(*command, "--frequency-Hz", "1000").returncode, 0)

    def test_tells_that_a_straight_actuator_bears_less(self):
        found = answer("--mean-A", "1", "--frequency-Hz", "20000")
        self.assertLess(found["straight_continuous_current_A"], found["continuous_current_A"])
        between = 0.5 * (found["straight_continuous_current_A"] + found["continuous_current_A"])
        self.assertIn("above_straight", answer("--mean-A", f"{between}", "--frequency-Hz", "20000")["warnings"])
        below = 0.9 * found["straight_continuous_current_A"]
        self.assertNotIn("above_straight", answer("--mean-A", f"{below}", "--frequency-Hz", "20000")["warnings"])

    def test_says_what_bridge_and_cell_do_not_bear(self):
        # Two fingers in parallel at 1.4 A a coil: 5.6 A through a bridge of 3.6 A, which their four coils in series keep.
        many = ("--mean-A", "1.4", "--actuators", "2")
        self.assertIn("above_peak", answer(*many)["warnings"])
        self.assertNotIn("above_peak", answer(*many, "--wiring", "series")["warnings"])
        self.assertNotIn("above_peak", answer(*many, "--bridge-peak-A", "40")["warnings"])
        self.assertRegex(run("drive", FINGER, *many).stdout,
                         r"\nThe driver's peak of [\d.]+ A is above the 3\.6 A that the bridge bears \(--bridge-peak-A\): it "
                         r"switches itself off\. --wiring series carries the current of one coil, on more voltage\.\n")
        # At 490 Hz the two coils of one take 8.8 A in pulses of 2.8 A on average; at 20 kHz 3 A.
        one = run("drive", FINGER, "--mean-A", "1.4", "--bridge-peak-A", "5").stdout
        self.assertIn("A higher --frequency-Hz has less ripple, and --current-limit-A cuts the peaks.\n", one)
        self.assertNotIn("above_peak", answer("--mean-A", "1.4", "--bridge-peak-A", "5", "--frequency-Hz", "20000")["warnings"])
        for voltage, named, option, text in (
            ("5", "below_voltage", ("--bridge-lowest-V", "4.5"),
             "The supply of 5 V is below the 6.5 V from which the bridge works (--bridge-lowest-V): it switches nothing on.\n"),
            ("48", "above_voltage", ("--bridge-highest-V", "50"),
             "The supply of 48 V is above the 45 V that the bridge bears (--bridge-highest-V).\n"),
        ):
            command = ("--mean-A", "0.5", "--supply-voltage-V", voltage)
            self.assertIn(named, answer(*command)["warnings"])
            self.assertNotIn(named, answer(*command, *option)["warnings"])
            self.assertIn(text, run("drive", FINGER, *command).stdout)
        self.assertEqual(answer("--mean-A", "0.5", "--frequency-Hz", "20000")["warnings"], [])
        # 150 mAh deliver 3 A: two coils of 3.76 Ohm at 4.2 V ask for 2.2 A, those of two actuators for 4.4 A.
        pulses = ("--duty", "0.5", "--frequency-Hz", "10", *CELL)
        self.assertNotIn("above_cell", answer(*pulses)["warnings"])
        self.assertIn("above_cell", answer(*pulses, "--actuators", "2")["warnings"])
        self.assertNotIn("above_cell", answer(*pulses, "--actuators", "2", "--cell-limit-A", "5")["warnings"])
        self.assertRegex(run("drive", FINGER, *pulses, "--actuators", "2").stdout,
                         r"\nThe peak of 4\.\d+ A is above the 3 A that the cell delivers \(20 times its capacity an hour; ")

    def test_a_cell_whose_capacity_is_not_given_has_no_time_and_no_limit_but_all_else(self):
        pulses = ("--duty", "0.5", "--frequency-Hz", "10", "--actuators", "2")
        known = answer(*pulses, *CELL)
        unknown = answer(*pulses, *CELL[:2])
        self.assertEqual(set(known) - set(unknown), {"run_time_s"})
        self.assertEqual(set(known["warnings"]) - set(unknown["warnings"]), {"above_cell"})
        self.assertEqual(known["coil"], unknown["coil"])
        self.assertIn("above_cell", answer(*pulses, *CELL[:2], "--cell-limit-A", "3")["warnings"])
        self.assertNotIn("The cell lasts", run("drive", FINGER, *pulses, *CELL[:2]).stdout)

    def test_refuses_what_makes_no_sense(self):
        for arguments, message in (
            ((), "--duty: or --mean-A is needed: what is set, or what is wanted"),
            (("--duty", "1.2"), "--duty"),
            (("--mean-A", "0"), "--mean-A"),
            (("--mean-A", "1", "--duty", "0"), "--duty: must be > 0 with --mean-A; got 0"),
            (("--mean-A", "1", "--duty", "0.5", *CELL),
             "--cell-voltage-V: a cell has the voltage it has; give --duty or --mean-A, not both"),
            (("--mean-A", "1", "--duty", "0.5", "--supply-voltage-V", "12"),
             "--supply-voltage-V: with --duty and --mean-A the voltage is what is looked for"),
            (("--duty", "0.5", "--frequency-Hz", "0"), "--frequency-Hz"),
            (("--duty", "0.5", "--decay", "mixed"), '--decay: must be one of "slow", "fast"; got "mixed"'),
            (("--duty", "0.5", "--cell-capacity-mAh", "150"), "--cell-capacity-mAh requires --cell-voltage-V"),
            (("--duty", "0.5", "--decay", "fast", *CELL), "--decay excludes --cell-voltage-V"),
            (("--duty", "0.5", "--bridge-peak-A", "5", *CELL), "--bridge-peak-A excludes --cell-voltage-V"),
            (("--duty", "0.5", "--bridge-highest-V", "0"), "--bridge-highest-V"),
            (("--duty", "0.5", "--bridge-lowest-V", "30", "--bridge-highest-V", "20"),
             "ratings.lowest_voltage must be below the highest, 20 V; got 30 V"),
            (("--duty", "0.5", "--cell-limit-A", "5"), "--cell-limit-A requires --cell-voltage-V"),
            (("--duty", "0.5", "--warm", "--coil-temperature-degC", "60"), "excludes"),
            (("--mean-A", "5", "--supply-voltage-V", "200", "--warm"),
             "paper_finger.json: coil temperature must be given: held for good, this drive heats the coils beyond 1085 "
             "degC, where copper melts"),
            (("--duty", "0.5", "--motion-s", "0.1"), "--motion-s requires --out"),
            (("--duty", "0.5", "--out", "x.csv"), "--out: requires --motion-s or --warm-up-s"),
            (("--duty", "0.5", "--warm-up-s", "60"), "--warm-up-s requires --out"),
            (("--duty", "0.5", "--warm-up-s", "60", "--motion-s", "1", "--out", "x.csv"), "excludes"),
            (("--duty", "0.5", "--warm-up-s", "1e6", "--out", "x.csv"), "--warm-up-s"),
            (("--duty", "0.5", "--warm-up-s", "1e5", "--interval-ms", "10", "--out", "x.csv"),
             "interval must be at least 0.1 s, for 1000000 samples; got 0.01 s"),
            (("--duty", "0.5", "--motion-s", "0", "--out", "x.csv"), "--motion-s"),
            (("--duty", "0.5", "--motion-s", "0.1", "--out", FINGER), "paper_finger.json"),
            (("--duty", "0.5", "--motion-s", "300", "--out", "x.csv"),
             "duration must be at most 204.082 s, the time of 100000 pulses; got 300 s"),
            (("--duty", "0.5", "--set", "current_share_1=-1"),
             "paper_finger.json: coil.current_share_1 must be 1: one driver drives all coils alike; got -1"),
        ):
            result = run("drive", FINGER, *arguments)
            self.assertEqual(result.returncode, 2, arguments)
            self.assertIn(message, result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
            self.assertEqual(result.stdout, "")


if __name__ == "__main__":
    unittest.main()
