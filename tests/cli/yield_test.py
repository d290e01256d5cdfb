"""A study's spread, and `coilwright yield`: builds of a design by dice."""

import json
import os
import pathlib
import re
import signal
import subprocess
import time
import unittest

from program import HANGS, PAPER_FINGER, PROGRAM, ProgramTest, run
from study import write_study

SPREAD = {"spread": {"gap_mm": {"sd": 0.05}, "current_A": {"relative_sd": 0.02}}}
ROBUST = {**SPREAD, "objectives": [{"maximise": "p05_peak_bending_speed_deg_s"}],
          "constraints": [{"quantity": "p95_mass_g", "at_most": 66}]}


class Spread(ProgramTest):
    def refused(self, message, **changes):
        write_study(self, **changes)
        self.assert_refused(["size", "study.json", "--out", "out"], "study.json: " + message)

    def test_bad_spreads_are_named(self):
        for name, posterior in (("old", None), ("nothing", {"posterior": None}),
                                ("another", {"posterior": {"numbers": {"gap_mm": {"value": 0.7, "sd": 0.01}}, "correlations": [[1]]}})):
            (self.folder / f"{name}.json").write_text(json.dumps({"format": "diagnosis/1", **(posterior or {})}))
        for spread, message in (
            ({}, '/spread: needs "parts" or a number that scatters'),
            ({"parts": "all"}, '/spread/parts: must be "usual" or "by_hand" (coilwright list spreads); got text "all"'),
            ({"gap": {"sd": 0.1}}, '/spread/gap: is no number of an actuator or a block that may scatter; did you mean "gap_mm"?'),
            ({"turns_radial": {"sd": 1}}, "/spread/turns_radial: is a whole number, of which every build has the designed one: it cannot "
             "scatter"),
            ({"posterior": "none.json"}, '/spread/posterior: must name the diagnosis.json of a diagnosis, and there is no none.json; got '
             'text "none.json"'),
            ({"gap_mm": {}}, '/spread/gap_mm: needs one of "sd", "relative_sd", "uniform", "relative_uniform"'),
            ({"gap_mm": {"sd": 0}}, "/spread/gap_mm/sd: must be > 0 and <= 1000000; got 0"),
            ({"gap_mm": {"relative_sd": 1.6}}, "/spread/gap_mm/relative_sd: must be > 0 and <= 1.5; got 1.6"),
            ({"gap_mm": {"uniform": [0.1, -0.1]}}, "/spread/gap_mm/uniform/1: must be above the other end (0.1); got -0.1"),
            ({"gap_mm": {"relative_uniform": [-1, 1]}},
             "/spread/gap_mm/relative_uniform/0: must be above -1: a share of the designed value; got -1"),
            ({"gap_mm": {"sd": 0.3}}, "/spread/gap_mm: would make gap_mm -0.195 in one of 10,000 builds of the study's own "
             "actuator (0.9): give less, or a relative_sd"),
            ({"squareness": {"sd": 0.02}}, "/spread/squareness: would make squareness 1.023 in one of 10,000 builds of the study's own "
             "actuator (0.95), which has at most 0.99: give less"),
            ({"poisson_ratio": {"relative_sd": 0.01}}, "/spread/poisson_ratio: would make poisson_ratio 0.5182 in one of 10,000 builds of "
             "the study's own actuator (0.5), which has at most 0.5: give less"),
            ({"quadratic_drag.drag_Nmms2_rad2": {"sd": 1}},
             "/spread/quadratic_drag.drag_Nmms2_rad2: has quadratic_drag.drag_Nmms2_rad2, which is no number of an effect of the "
             "study's actuator"),
            ({"parts": "usual", "correlations": [{"of": ["gap_mm", "mass_g"], "value": 0.5}]},
             '/spread/correlations/0/of/1: must be a number that scatters in this spread; got text "mass_g"'),
            ({"parts": "usual", "correlations": [{"of": ["gap_mm", "gap_mm"], "value": 0.5}]},
             '/spread/correlations/0/of/1: must not be correlated twice; got text "gap_mm"'),
            ({"parts": "usual", "correlations": [{"of": ["gap_mm", "magnet_length_mm", "magnet_radius_mm"], "value": -0.8}]},
             "/spread/correlations/0/value: must be at least -0.5: 3 numbers cannot all go against each other; got -0.8"),
            ({"parts": "usual", "correlations": [{"of": ["gap_mm"], "value": 0.5}]}, "/spread/correlations/0/of: must have at least 2 elements; got an array of 1"),
            ({"each_joint_stiffness_factor": {"sd": 0.5}}, "/spread/each_joint_stiffness_factor: would make each_joint_stiffness_factor "
             "-0.824 in one of 10,000 builds of the study's own actuator (1): give less, or a relative_sd"),
            ({"parts": "usual", "correlations": [{"of": ["gap_mm", "each_remanence_factor"], "value": 0.5}]},
             '/spread/correlations/0/of/1: must be a number that scatters in this spread; got text "each_remanence_factor"'),
            ({"parts": "usual", "each_remanence_factor": {"relative_sd": 0.01}, "correlations": [{"of": ["gap_mm", "each_remanence_factor"], "value": 0.5}]},
             '/spread/correlations/0/of/1: must be one number: each part draws its own of this; got text "each_remanence_factor"'),
            *(({name: {"sd": 0.01}}, f"/spread/{name}: scatters {name}, which the study's actuator does not give, or gives as 0, so that "
               "half of all builds would have less than nothing: state it there")
              for name in ("shore_hardness_00", "youngs_modulus_MPa", "coercivity_kA_m")),
            ({"assumptions": {"as_designed": 1}}, "/spread/assumptions/as_designed: must be > 0 and < 1; got 1"),
            ({"posterior": "finger.json"}, '/spread/posterior: must name the diagnosis.json of a diagnosis; got text "finger.json"'),
            ({"posterior": "old.json"}, '/spread/posterior: must be of a diagnosis that states its numbers together: this one is of an '
             'earlier version, diagnose again; got text "old.json"'),
            ({"posterior": "nothing.json"}, '/spread/posterior: must be of a design that a diagnosis knows something of; got text "nothing.json"'),
            ({"posterior": "another.json"}, "/spread/posterior: is of another actuator, whose gap_mm is 0.7: the study's has 0.9; give the "
             "actuator.json that the diagnosis wrote beside it"),
            ({"parts": "usual", "draws": 4}, "/spread/draws: must be from 8 to 4096; got 4"),
        ):
            with self.subTest(message):
                self.refused(message, spread=spread)

    def test_a_posterior_is_read_with_its_own_rules(self):
        one = {"gap_mm": {"value": 0.9, "sd": 0.01}}
        three = {name: {"value": 1, "sd": 0.01} for name in ("joint_stiffness_factor", "joint_damping_factor", "tip_com_factor")}
        for posterior, message in (
            ({"numbers": one}, "/posterior/correlations: is missing"),
            ({"numbers": {"gap_mm": {"value": 0.9}}, "correlations": [[1]]}, "/posterior/numbers/gap_mm/sd: is missing"),
            ({"numbers": one, "correlations": [[1, 0]]}, "/posterior/correlations/0: must have 1 element"),
            ({"numbers": three, "correlations": [[1, 0.9, -0.9], [0.9, 1, 0.9], [-0.9, 0.9, 1]]},
             "/posterior/correlations: no numbers can be correlated so: what some of them imply contradicts others"),
        ):
            with self.subTest(message):
                (self.folder / "found.json").write_text(json.dumps({"format": "diagnosis/1", "posterior": posterior}))
                write_study(self, spread={"posterior": "found.json"})
                result = run("size", "study.json", "--out", "out", cwd=self.folder)
                self.assertEqual(result.returncode, 2)
                self.assertIn("found.json: " + message, result.stderr)

    def test_a_statistic_needs_a_spread_and_a_quantity(self):
        self.refused('/objectives/0/maximise: is a statistic of builds: needs the block "spread" in the study; '
                     'got text "p05_mass_g"', objectives=[{"maximise": "p05_mass_g"}])
        for changes in ({}, SPREAD):
            self.refused('/objectives/0/maximise: must be a quantity that evaluate prints; did you mean "p05_mass_g"? A percentile '
                         'has two digits; got text "p5_mass_g"', **changes, objectives=[{"maximise": "p5_mass_g"}])
        write_study(self, **SPREAD, objectives=[{"maximise": "p05_mas_g"}])
        result = run("size", "study.json", "--out", "out", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("/objectives/0/maximise: must be a quantity that evaluate prints", result.stderr)

    def test_size_seeks_what_builds_reach(self):
        write_study(self, **ROBUST, columns=[{"quantity": "p05_peak_bending_speed_deg_s / peak_bending_speed_deg_s",
                                              "name": "kept", "unit": "1"}])
        self.assertEqual(run("size", "study.json", "--out", "out", "--answer-only", cwd=self.folder).returncode, 0)
        rows = [row for row in self.table("out/evaluations.csv") if row["status"] == "ok"]
        self.assertGreater(len(rows), 10)
        for row in rows:
            self.assertLess(float(row["p05_peak_bending_speed_deg_s"]), float(row["peak_bending_speed_deg_s"]))
            self.assertLessEqual(float(row["p95_mass_g"]), 66)
            self.assertAlmostEqual(float(row["kept"]) * float(row["peak_bending_speed_deg_s"]),
                                   float(row["p05_peak_bending_speed_deg_s"]), delta=0.01)

    def test_size_says_which_limits_other_builds_break(self):
        # The worst of 8 builds stands for what 99 % stay below: a limit just above it.
        write_study(self, **{**ROBUST, "spread": {**SPREAD["spread"], "draws": 8},
                             "constraints": [{"quantity": "p99_current_A", "at_most": 0.8014}]})
        result = run("size", "study.json", "--out", "out", "--max-evaluations", "40", cwd=self.folder)
        self.assertRegex(result.stdout, r"\n[\d.]+ % \([\d.]+ to [\d.]+\) of 2000 builds by fresh dice keep every limit\n")
        self.assertRegex(result.stdout, r"\n  peak_bending_speed_deg_s( +[\d.]+){4}\n")
        self.assertRegex(result.stdout, r"\nMIND: current_A <= 0\.8014 is kept by [\d.]+ % \([\d.]+ to [\d.]+\), not by the 99 % "
                                        r"that the study asks for\.\nThe search judged every design by too few builds")
        built = json.loads((self.folder / "out/result.json").read_text())["as_built"]
        current = built["quantities"][1]
        self.assertEqual((built["builds"], current["quantity"], current["asked"]), (2000, "current_A", 0.99))
        self.assertLess(current["keeps"]["high"], 0.99)
        # Which scatter decides is told by the command that the answer names.
        self.assertIn("coilwright yield STUDY.json actuator.json --worth 300\n", result.stdout)
        told = run("yield", "study.json", "out/actuator.json", "--builds", "10", "--worth", "16", cwd=self.folder)
        self.assertEqual((told.returncode, "If one of them scattered half as far" in told.stdout), (0, True), told.stderr)
        text = run("size", "study.json", "--out", "short", "--max-evaluations", "40", "--answer-only", cwd=self.folder).stdout
        self.assertRegex(text, r"\nNot looked at, as only the answer was asked for \(--answer-only\): .*; what 2000 builds by fresh "
                               r"dice make of this design\.\n")
        self.assertIsNone(json.loads((self.folder / "short/result.json").read_text())["as_built"])

    def test_a_limit_that_size_offers_is_one_of_builds(self):
        write_study(self, **SPREAD, operating_point={"current_A": 1.4, "duty": 1}, constraints=[],
                    variables={"turns_radial": {"lower": 10, "upper": 12}})
        text = run("size", "study.json", "--out", "out", "--answer-only", cwd=self.folder).stdout
        self.assertIn('{"quantity": "p95_thermal_load", "at_most": 1}', text)

    def test_another_spread_is_another_question(self):
        write_study(self, **ROBUST)
        run("size", "study.json", "--out", "one", "--answer-only", cwd=self.folder)
        write_study(self, **{**ROBUST, "spread": {**SPREAD["spread"], "gap_mm": {"sd": 0.1}}})
        result = run("size", "study.json", "--out", "two", "--reuse", "one", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("another study of what is built from the actuator (gripper, crawler, driver, spread)", result.stderr)

    def test_the_same_bytes_on_any_number_of_threads(self):
        write_study(self, **ROBUST)
        for threads in "12":
            run("size", "study.json", "--out", "out" + threads, "--threads", threads, "--answer-only", cwd=self.folder)
        self.assertEqual((self.folder / "out1/evaluations.csv").read_bytes(),
                         (self.folder / "out2/evaluations.csv").read_bytes())


class Yield(ProgramTest):
    def answer(self, *arguments):
        result = run("yield", "study.json", "finger.json", "--json", "--quiet", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return json.loads(result.stdout)

    def test_builds_the_actuator_at_the_study_s_current(self):
        # A limit in the middle of what builds have: half of them keep it.
        evaluated = json.loads(run("evaluate", PAPER_FINGER, "--current-A", "1.2", "--json").stdout)
        write_study(self, **SPREAD, operating_point={"current_A": 1.2}, constraints=[
            {"quantity": "current_A", "at_most": 1.2}, {"quantity": "p95_mass_g", "at_most": evaluated["mass_g"] * 1.2}])
        answer = self.answer("--builds", "2000")
        self.assertEqual((answer["builds"], answer["not_built"]), (2000, 0))
        self.assertTrue(all(isinstance(answer[count], int) for count in ("builds", "not_built")), answer)
        of = {row["quantity"]: row for row in answer["quantities"]}
        self.assertEqual(set(of), {"peak_bending_speed_deg_s", "current_A", "mass_g"})
        self.assertAlmostEqual(of["mass_g"]["nominal"], evaluated["mass_g"], places=9)
        low, high = (of["current_A"]["keeps"][end] for end in ("low", "high"))
        self.assertTrue(low < 0.5 < high and high - low < 0.05, (low, high))
        self.assertEqual(of["mass_g"]["keeps"]["share"], 1)
        self.assertEqual(answer["keeps_all"], of["current_A"]["keeps"])
        self.assertEqual(self.answer("--builds", "2000", "--threads", "1"), answer)
        self.assertNotEqual(self.answer("--builds", "2000", "--seed", "2"), answer)

    def test_an_expression_of_statistics_is_one_of_numbers_in_a_build(self):
        write_study(self, **SPREAD, operating_point={"current_A": 1.2}, constraints=[
            {"quantity": "2 * p95_current_A", "name": "twice", "unit": "A", "at_most": 2.4}])
        twice = self.answer("--builds", "400")["quantities"][1]
        self.assertEqual((twice["quantity"], twice["nominal"]), ("twice_A", 2.4))
        self.assertAlmostEqual(twice["p50"], 2.4, delta=0.01)
        self.assertTrue(twice["keeps"]["low"] < 0.5 < twice["keeps"]["high"], twice)

    def test_a_number_of_a_block_that_varies_must_be_said(self):
        driven = {"driver": {"kind": "h_bridge", "voltage_V": 24, "frequency_Hz": 20000}, "operating_point": {"current_A": 1},
                  "variables": {"driver_voltage_V": {"values": [8, 24]}}, "objectives": [{"maximise": "driver_duty"}], "constraints": []}
        write_study(self, **driven, **SPREAD)
        self.assert_refused(["yield", "study.json", "finger.json"], "study.json: /variables/driver_voltage_V: needs --set driver_voltage_V=VALUE: "
                            "the study varies it, and no actuator's file says what it is")
        duty = {volts: self.answer("--builds", "20", "--set", f"driver_voltage_V={volts}")["quantities"][0]["nominal"] for volts in (8, 24)}
        self.assertAlmostEqual(duty[8] / duty[24], 3, delta=0.15)
        result = run("yield", "study.json", "finger.json", "--set", "driver_voltage_V=2", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertIn("finger.json: the driver cannot give the current: raise driver.voltage_V or lower current_A; got 0.", result.stderr)
        write_study(self, **{**driven, "spread": {"driver_voltage_V": {"sd": 20}}})
        self.assert_refused(["size", "study.json", "--out", "out"], "study.json: /spread/driver_voltage_V: would make driver_voltage_V -49 in one of "
                            "10,000 builds of the study's own actuator (24): give less, or a relative_sd")
        write_study(self, **{**driven, "spread": {"driver_resistance_Ohm": {"relative_sd": 0.1}}})
        self.assert_refused(["size", "study.json", "--out", "out"], "study.json: /spread/driver_resistance_Ohm: scatters nothing: driver_resistance_Ohm "
                            "is 0, and so is any share of it")

    def test_a_build_whose_driver_cannot_give_the_current_keeps_nothing(self):
        write_study(self, driver={"kind": "h_bridge", "voltage_V": 12, "frequency_Hz": 490}, operating_point={"current_A": 1},
                    spread={"driver_voltage_V": {"uniform": [-11.5, 1], "of": "part"}}, constraints=[])
        answer = self.answer("--builds", "200")
        self.assertGreater(answer["not_built"], 20)
        self.assertAlmostEqual(answer["keeps_all"]["share"], 1 - answer["not_built"] / 200, places=12)
        cause = {"reason": "the driver cannot give the current: raise driver.voltage_V or lower current_A", "builds": answer["not_built"]}
        self.assertEqual(answer["failures"], [cause])
        text = run("yield", "study.json", "finger.json", "--builds", "200", "--quiet", cwd=self.folder).stdout
        self.assertIn(f"\n{cause['builds']} of them lack a figure that is asked for, and keep nothing\n  {cause['builds']}  {cause['reason']}\n", text)
        self.assertEqual([row["quantity"] for row in answer["quantities"]], ["peak_bending_speed_deg_s", "driver_thermal_load"])
        # A voltage of uses all builds meet.
        write_study(self, driver={"kind": "h_bridge", "voltage_V": 12, "frequency_Hz": 490}, operating_point={"current_A": 1},
                    spread={"driver_voltage_V": {"uniform": [-11.5, 1]}}, constraints=[])
        self.assertEqual(self.answer("--builds", "200")["keeps_all"]["share"], 0)

    def test_builds_that_run_away_are_told_by_the_figure_that_they_lack(self):
        runaway = json.loads(run("evaluate", PAPER_FINGER, "--current-A", "1.2", "--json").stdout)["runaway_current_A"]
        write_study(self, operating_point={"current_A": runaway}, spread={"current_A": {"relative_uniform": [-0.2, 0.2]}},
                    objectives=[{"minimise": "coil_hot_spot_degC"}], constraints=[])
        (cause,) = self.answer("--builds", "100")["failures"]
        self.assertEqual(cause["reason"], "coil_hot_spot_degC has no value: the current is at or beyond that of a thermal runaway")
        self.assertTrue(20 < cause["builds"] < 80, cause)

    def test_ctrl_c_prints_what_the_builds_made_so_far_say(self):
        def seconds_of(process):
            times = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()[11:13]
            return sum(map(int, times)) / os.sysconf("SC_CLK_TCK")

        write_study(self, **SPREAD, operating_point={"current_A": 1.2}, constraints=[])
        process = subprocess.Popen([PROGRAM, "yield", "study.json", "finger.json", "--builds", "1000000", "--json", "--quiet"],
                                   cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        while seconds_of(process) < 5:
            self.assertIsNone(process.poll())
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=HANGS)
        answer = json.loads(output)
        self.assertTrue(10 < answer["builds"] < 1000000, answer["builds"])
        self.assertEqual(answer["keeps_all"]["share"], 1)
        self.assertEqual((process.returncode, errors),
                         (130, f"coilwright: interrupted: {answer['builds']} of 1000000 builds were made\n"))

    def test_a_limit_on_a_deviation_is_of_no_build(self):
        write_study(self, **SPREAD, operating_point={"current_A": 1.2}, constraints=[{"quantity": "sd_mass_g", "at_most": 0.5}])
        answer = self.answer("--builds", "20")
        self.assertEqual(answer["keeps_all"]["share"], 1)
        self.assertNotIn("limit", answer["quantities"][1])

    def test_says_which_scatter_matters(self):
        write_study(self, **SPREAD, operating_point={"current_A": 1.2}, constraints=[{"quantity": "current_A", "at_most": 1.22}])
        answer = self.answer("--builds", "50", "--worth", "64")
        gap, current = answer["scatters"]
        self.assertEqual((gap["scatter"], current["scatter"]), ("gap_mm", "current_A"))
        self.assertGreater(current["total"][1]["value"], 0.9)
        text = run("yield", "study.json", "finger.json", "--builds", "50", "--worth", "64", "--quiet", cwd=self.folder).stdout
        self.assertIn("builds by fresh dice keep every limit", text)
        self.assertIn("If one of them scattered half as far, every limit would be kept by", text)

    def test_a_share_is_one_and_said_once_of_a_quantity_with_two_limits(self):
        # So few builds that half of the estimates lie beyond what a share can be.
        write_study(self, spread={"parts": "usual"}, operating_point={"current_A": 1.2},
                    constraints=[{"quantity": "mass_g", "at_most": 80}, {"quantity": "mass_g", "at_least": 40},
                                 {"quantity": "peak_bending_speed_deg_s", "at_least": 1}])
        answer = self.answer("--builds", "30", "--worth", "16")
        shares = [each for row in answer["scatters"] for kind in ("first", "total") for each in row[kind] if each]
        self.assertGreater(len(shares), 20)
        for each in shares:
            self.assertTrue(0 <= each["low"] <= each["high"] <= 1 and 0 <= each["value"] <= 1, each)
        text = run("yield", "study.json", "finger.json", "--builds", "30", "--worth", "16", "--quiet", cwd=self.folder).stdout
        heads = [line for line in text.splitlines() if "share of its variance" in line]
        self.assertGreaterEqual(len(heads), 2)
        self.assertEqual(len(heads), len(set(heads)))

    def test_a_study_without_a_spread_is_told_of_one_that_works(self):
        write_study(self, operating_point={"current_A": 1.2})
        result = run("yield", "study.json", "finger.json", cwd=self.folder)
        (block,) = re.findall(r'needs the block "spread" \((\{.*?\})\)', result.stderr)
        write_study(self, operating_point={"current_A": 1.2}, spread=json.loads(block))
        self.assertEqual(len(self.answer("--builds", "20")["quantities"]), 3)

    def test_each_joint_draws_its_own(self):
        # Without a current one magnet has nothing to pull at: rest angles vary with the joints alone.
        write_study(self, spread={"each_joint_stiffness_factor": {"relative_sd": 0.1}, "each_remanence_factor": {"relative_sd": 0.01}},
                    operating_point={"current_A": 1.2}, constraints=[{"quantity": f"rest_joint{i}_angle_deg", "at_most": 90} for i in (1, 2)])
        answer = self.answer("--builds", "100", "--worth", "16")
        self.assertEqual([each["scatter"] for each in answer["scatters"]], ["each_joint_stiffness_factor", "each_remanence_factor"])
        for row in answer["quantities"]:
            self.assertGreater(row["p95"], row["p05"], row)

    def test_refuses_what_it_cannot_build(self):
        write_study(self)
        self.assert_refused(["yield", "study.json", "finger.json"],
                            'study.json: needs the block "spread" ({"parts": "usual"}): without one every build is the design')
        write_study(self, **SPREAD, operating_point={"current_A": 1.2})
        self.assert_refused(["yield", "study.json", "finger.json", "--current-A", "1"],
                            "--current-A: must not be given: the study itself says which current flows; "
                            "--set /operating_point/current_A=VALUE changes it")
        write_study(self, **SPREAD)
        self.assert_refused(["yield", "study.json", "finger.json", "--current-A", "1"],
                            "--current-A: must not be given: the study itself says which current flows; "
                            "--set /operating_point/share_of_current_limit=VALUE changes it")
        self.assert_refused(["yield", "study.json", "finger.json", "--set", "driver_voltage_V=8"],
                            '/driver/voltage_V=8: must be of a block that the study has: it has no "driver"; write that block into it '
                            "(coilwright schema study)")
        write_study(self, **SPREAD, operating_point=None, variables={"current_A": {"lower": 0.5, "upper": 1}})
        result = run("yield", "study.json", "finger.json", "--current-A", "0.7", "--builds", "10", "--set", "gap_mm=1", "--json",
                     cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assert_refused(["yield", "study.json", "finger.json"],
                            "finger.json: /operating_point: must be there, or --current-A: the study varies the current, and does not say "
                            "with which one")


if __name__ == "__main__":
    unittest.main()
