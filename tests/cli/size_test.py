"""`coilwright size`: the answer, its files, and that the answer can be trusted."""

import json
import os
import pty
import re
import subprocess
import unittest

from program import HANGS, PROGRAM, ProgramTest, run
from study import FRONT, write_study


class Size(ProgramTest):
    def size(self, *arguments, code=0):
        result = run("size", "study.json", "--out", "out", "--force", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (code, ""))
        return result.stdout

    def test_the_design_written_gives_the_numbers_promised(self):
        write_study(self)
        self.size()
        answer = self.result("out/result.json")
        self.assertTrue(answer["feasible"])
        point = answer["operating_point"]
        # actuator.json carries the operating point for which it was sized.
        result = run("evaluate", "out/actuator.json", "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        evaluated = json.loads(result.stdout)
        self.assertEqual(evaluated.pop("operating_point"), point)
        for key in ("part_limits", "assumptions"):
            evaluated.pop(key)
        self.assertEqual(evaluated, answer["performance"])
        (objective,) = answer["best"]["objectives"].items()
        self.assertEqual(answer["performance"][objective[0]], objective[1])
        for limit in answer["best"]["constraints"]:
            self.assertLessEqual(answer["performance"][limit["quantity"]], limit["at_most"])
            self.assertGreaterEqual(limit["margin"], 0)

    def test_the_answer_only_takes_the_search_alone(self):
        write_study(self, search={"max_evaluations": 20, "seed": 5})
        text = self.size("--answer-only")
        answer = self.result("out/result.json")
        self.assertEqual((answer["steps"], answer["binding"], answer["assumptions"]), ([], [], []))
        self.assertGreater(answer["assumptions_left"], 0)
        self.assertLessEqual(answer["evaluations"]["total"], 20)
        self.assertEqual((answer["evaluations"]["surroundings"], answer["evaluations"]["other_choices"]), (0, 0))
        self.assertIn("\nNot looked at, as only the answer was asked for (--answer-only): "
                      f'{answer["assumptions_left"]} other choices and numbers; what a step of a variable or a relaxed limit '
                      "would bring.\n", text)
        self.assertEqual(answer["search_stop_reason"], answer["stop_reason"])
        # Without the option the rest is made, from where the search ended.
        text = run("size", "study.json", "--out", "out", cwd=self.folder).stdout
        whole = self.result("out/result.json")
        self.assertEqual(whole["evaluations"]["search"], answer["evaluations"]["search"])
        self.assertLessEqual(whole["evaluations"]["other_choices"], 21 * len(whole["assumptions"]))
        self.assertIn(f'{whole["evaluations"]["other_choices"]} further ones under other modelling choices', text)

    def test_the_answer_is_the_best_of_all_evaluations_and_each_is_there_once(self):
        write_study(self)
        self.size()
        rows, answer = self.table("out/evaluations.csv"), self.result("out/result.json")
        columns = list(rows[0])
        self.assertEqual(columns[:5], ["turns_radial", "wire_gauge_AWG", "gap_mm", "evaluation", "proposed_by"])
        self.assertIn("peak_bending_speed_deg_s", columns)
        self.assertEqual(columns[-3:], ["mass_max_margin_g", "thermal_load_max_margin", "reason"])
        self.assertEqual(sorted(int(row["evaluation"]) for row in rows), list(range(1, len(rows) + 1)))
        steps = self.table("out/convergence.csv")
        self.assertEqual(list(steps[0]), ["evaluation", "best_peak_bending_speed_deg_s", "least_violation"])
        self.assertEqual(float(steps[-1]["best_peak_bending_speed_deg_s"]),
                         answer["best"]["objectives"]["peak_bending_speed_deg_s"])
        self.assertEqual(int(steps[-1]["evaluation"]), len(rows))
        points = [tuple(float(row[key]) for key in ("turns_radial", "wire_gauge_AWG", "gap_mm")) for row in rows]
        self.assertEqual(len(set(points)), len(points))
        self.assertEqual(points, sorted(points))
        self.assertEqual(len(rows), answer["evaluations"]["total"])
        self.assertLessEqual(answer["evaluations"]["search"], 60)
        self.assertEqual(answer["evaluations"]["search"] + answer["evaluations"]["surroundings"], len(rows))
        for status in ("ok", "infeasible", "failed"):
            self.assertEqual(sum(row["status"] == status for row in rows), answer["evaluations"][status])
        best = max(float(row["peak_bending_speed_deg_s"]) for row in rows if row["status"] == "ok")
        self.assertEqual(best, answer["best"]["objectives"]["peak_bending_speed_deg_s"])
        for row in rows:
            margins = [float(row["mass_max_margin_g"]), float(row["thermal_load_max_margin"])]
            self.assertEqual(row["status"] == "ok", min(margins) >= 0)

    def test_finds_how_the_coils_should_share_the_current(self):
        # Against the wall the base's faces carry what its coil does not: the coil at the tip alone presses hardest.
        shares = {"values": [0, 0.5, 1]}
        write_study(self, operating_point={"current_A": 1.2}, objectives=[{"maximise": "grasp_force_N"}],
                    constraints=[{"quantity": "power_cold_W", "at_most": 6}],
                    variables={"current_share_1": shares, "current_share_2": shares})
        text = self.size()
        self.assertRegex(text, r"\n  current_share_1 +0 .*\n  current_share_2 +1 .*\n")
        self.assertIn("with 0 and 1.2 A in the coils from base to tip, duty 1\n", text)
        # All nine designs: none of those that keep the power presses harder, the same currents in both among them.
        rows = self.table("out/evaluations.csv")
        self.assertEqual(len(rows), 9)
        kept = {(row["current_share_1"], row["current_share_2"]): float(row["grasp_force_N"]) for row in rows if row["status"] == "ok"}
        self.assertGreater(kept["0", "1"], 1.1 * kept["0.5", "0.5"])
        self.assertIn("0", {row["current_share_1"] for row in rows if "at least one coil must carry" in row["reason"]})
        coil = self.result("out/actuator.json")["coil"]
        self.assertEqual((coil["current_share_1"], coil.get("current_share_2", 1)), (0, 1))

    def test_says_what_stands_in_the_way_and_what_it_costs(self):
        # Down to 2.6 mm thinner hinges bend faster, until the steady angle is in the way: the limit must bind, and
        # relaxing it must help.
        write_study(self, variables={"bottom_layer_mm": {"lower": 1.5, "upper": 4, "step": 0.1}},
                    constraints=[{"quantity": "steady_angle_deg", "at_most": 50}, {"quantity": "mass_g", "at_most": 90}])
        text = self.size()
        answer = self.result("out/result.json")
        (binding,) = answer["binding"]
        self.assertEqual(binding["constraint"], "steady_angle_deg <= 50")
        self.assertTrue(binding["blocks_step"])
        self.assertAlmostEqual(binding["relaxed_to"], 52.5, places=12)
        self.assertGreater(binding["objective_change"], 0)
        self.assertLess(binding["relaxed_best"]["bottom_layer_mm"], answer["best"]["variables"]["bottom_layer_mm"])
        self.assertRegex(text, r"steady_angle_deg <= 50 relaxed to 52\.5: \+\d+(\.\d+)? deg/s\n")
        down, up = answer["steps"]
        self.assertEqual([down["violates"], up["violates"]], [["steady_angle_deg <= 50"], []])
        self.assertGreater(down["objective_change"], 0)
        self.assertLess(up["objective_change"], 0)
        self.assertEqual(answer["stop_reason"], "space_exhausted")
        self.assertEqual(answer["evaluations"]["search"], 26)

    def test_warns_of_limits_of_the_parts_that_the_study_does_not_set(self):
        hot = {"operating_point": {"current_A": 1.4, "duty": 1}, "variables": {"turns_radial": {"lower": 10, "upper": 12}},
               "constraints": [{"quantity": "mass_g", "at_most": 90}]}
        write_study(self, **hot)
        text = self.size("--report")
        limits = self.result("out/result.json")["part_limits"]
        broken = [each for each in limits if each["broken"] and not each["conditional"]]
        self.assertIn("coil_hot_spot_degC", [each["quantity"] for each in broken])
        evaluated = json.loads(run("evaluate", "out/actuator.json", "--json", cwd=self.folder).stdout)
        self.assertEqual(evaluated["part_limits"], self.result("out/result.json")["part_limits"])
        self.assertIn("\nBEWARE: this design breaks limits of its parts\n", text)
        self.assertIn("<p>BEWARE: this design breaks limits of its parts</p>", (self.folder / "out/report.html").read_text())
        # What it says to add is what a study takes, and leads to a design that keeps them, or to none.
        line = re.search(r'Add to the study\'s "constraints" and size anew: (.*)\n', text)[1]
        constraints = json.loads(f"[{line}]")
        # The temperatures are limits of one wire and one magnet: the load holds for whichever a design has.
        of_heat = {"coil_hot_spot_degC", "magnet_temperature_degC"}
        self.assertEqual({each["quantity"] for each in constraints},
                         {"thermal_load" if each["quantity"] in of_heat else each["quantity"] for each in broken})
        write_study(self, **{**hot, "operating_point": {"current_A": 0.5, "duty": 1},
                             "constraints": hot["constraints"] + constraints})
        self.assertNotIn("BEWARE", self.size())

    def test_gives_no_advice_that_is_followed(self):
        hot = {"operating_point": {"current_A": 1.4, "duty": 1}, "objectives": [{"maximise": "peak_bending_speed_deg_s"}],
               "variables": {"gap_mm": {"values": [0.9]}}}
        loose = {"quantity": "thermal_load", "at_most": 5}
        write_study(self, **hot, constraints=[loose])
        text = run("size", "study.json", "--out", "out", "--answer-only", cwd=self.folder).stdout
        self.assertIn('Tighten in the study\'s "constraints" and size anew: {"quantity": "thermal_load", "at_most": 1}\n', text)
        self.assertNotRegex(text, r"\n(Add|Where that will not do, add) .*\"thermal_load\"")
        # The builds have another current than the design itself.
        kept = {"quantity": "p95_thermal_load", "at_most": 1}
        write_study(self, **hot, constraints=[kept], spread={"current_A": {"uniform": [-1.2, -1.1]}})
        text = run("size", "study.json", "--out", "kept", "--answer-only", cwd=self.folder).stdout
        self.assertIn("BEWARE: this design breaks limits of its parts\n", text)
        self.assertIn("\nIn the study already, and kept by as many builds as it asks for: " + json.dumps(kept) +
                      "; the design itself, used as its file says, does not keep it\n", text)
        self.assertNotRegex(text, r"\n(Add|Where that will not do, add) .*\"p95_thermal_load\"")
        front = {**hot, "objectives": [{"maximise": "peak_bending_speed_deg_s"}, {"minimise": "mass_g"}],
                 "variables": {"gap_mm": {"values": [0.9, 1.0]}}}
        write_study(self, **front, constraints=[{"quantity": "coil_hot_spot_degC", "at_most": 900}])
        text = run("sweep", "study.json", "--out", "front", cwd=self.folder).stdout
        self.assertIn("coil_hot_spot_degC: ", text)
        self.assertFalse(re.search(r"\n(Limit|Where that will not do, limit) [^\n]*coil_hot_spot", text), text)

    def test_says_what_a_design_needs_and_how_to_do_without(self):
        cool = {"operating_point": {"current_A": 0.9, "duty": 1}, "variables": {"turns_radial": {"lower": 4, "upper": 12}}}
        write_study(self, **cool, constraints=[{"quantity": "coil_hot_spot_degC", "at_most": 155}])
        text = self.size("--report")
        self.assertNotIn("BEWARE", text)
        self.assertRegex(text, r"\nMIND what this design needs, or gives up\n(  .*\n)*  thermal_load_still_air 1\.\d+, at most 1: "
                               r"only moving air, or a mount that conducts, carries this heat away \(156 W/m2K are taken\); in")
        self.assertIn(">MIND what this design needs", (self.folder / "out/report.html").read_text())
        line = re.search(r'Where that will not do, add to the study\'s "constraints" and size anew: (.*)\n', text)[1]
        write_study(self, **cool, constraints=json.loads(f"[{line}]"))
        self.assertNotIn("MIND", self.size())

    def test_compares_with_the_actuator_as_given(self):
        write_study(self)
        text = self.size()
        base = self.result("out/result.json")["base"]
        given = run("evaluate", "finger.json", "--current-A", repr(0.9 * 1.4), "--duty", "0.5", "--json", cwd=self.folder)
        self.assertEqual(base["objectives"]["peak_bending_speed_deg_s"],
                         json.loads(given.stdout)["peak_bending_speed_deg_s"])
        self.assertIn("mass_g <= 66 violated by", text.split("the study's own actuator with")[1].splitlines()[0])

    def test_a_current_may_be_a_variable_and_needs_no_operating_point(self):
        write_study(self, operating_point=None, variables={"current_A": {"lower": 0.3, "upper": 1.6}},
                    constraints=[{"quantity": "current_over_limit", "at_most": 1}])
        self.size()
        answer = self.result("out/result.json")
        self.assertLessEqual(answer["best"]["variables"]["current_A"], 1.4)
        # More current is faster without end: the best is at the limit, to the binding margin of 1e-3.
        self.assertAlmostEqual(answer["best"]["variables"]["current_A"], 1.4, delta=1.4e-3)
        self.assertEqual(answer["operating_point"]["current_A"], answer["best"]["variables"]["current_A"])
        # The study's own actuator is as fast at what its own wire carries, found to a thousandth of the range.
        self.assertLessEqual(answer["base"]["current_A"], 1.4)
        self.assertAlmostEqual(answer["base"]["current_A"], 1.4, delta=1.3e-3)

    def test_configurations_are_written_by_letter_and_whole_numbers_without_a_point(self):
        write_study(self, variables={"configuration": {"values": ["B", "D"]}, "turns_axial": {"lower": 28, "upper": 30}},
                    constraints=[])
        self.size()
        variables = self.result("out/result.json")["best"]["variables"]
        self.assertIn(variables["configuration"], ("B", "D"))
        self.assertIsInstance(variables["turns_axial"], int)
        self.assertEqual({row["configuration"] for row in self.table("out/evaluations.csv")}, {"B", "D"})

    def test_nothing_feasible_is_3_and_the_nearest_design_is_written(self):
        write_study(self, constraints=[{"quantity": "mass_g", "at_most": 40}, {"quantity": "width_mm", "at_most": 90}])
        text = self.size(code=3)
        answer = self.result("out/result.json")
        self.assertFalse(answer["feasible"])
        self.assertEqual(answer["violated"], ["mass_g <= 40"])
        self.assertIn("No design that was found keeps every limit", text)
        rows = self.table("out/evaluations.csv")
        self.assertEqual({row["status"] for row in rows}, {"infeasible"})
        nearest = max(float(row["mass_max_margin_g"]) for row in rows)
        self.assertAlmostEqual(answer["best"]["constraints"][0]["margin"], nearest, places=9)
        self.assertEqual(json.loads((self.folder / "out/actuator.json").read_text())["name"],
                         "small (least infeasible)")
        # No promise that more evaluations would help: none would.
        self.assertIn("None keeps every limit: more evaluations (--max-evaluations) help only if some design does",
                      self.size("--max-evaluations", "30", code=3))

    def test_designs_that_cannot_be_built_say_why(self):
        write_study(self, variables={"coil_inner_radius_mm": {"values": [0.3, 0.4, 0.5]}})
        text = self.size(code=3)
        rows = self.table("out/evaluations.csv")
        self.assertEqual({row["status"] for row in rows}, {"failed"})
        self.assertEqual({row["peak_bending_speed_deg_s"] for row in rows}, {""})
        self.assertTrue(all("coil inner radius must be at least" in row["reason"] for row in rows))
        # 0.5 mm is the nearest to what the wire needs.
        self.assertEqual(self.result("out/result.json")["best"]["variables"], {"coil_inner_radius_mm": 0.5})
        self.assertIn("This design cannot be evaluated: coil inner radius", text)

    def test_threads_change_no_byte_and_the_seed_does(self):
        write_study(self)
        bytes_of = {}
        for threads in ("1", "2", "3"):
            text = self.size("--threads", threads)
            # The archive says when each design was evaluated, and how long that took.
            bytes_of[threads] = ({k: v for k, v in self.files().items()
                                  if k.startswith("out/") and k != "out/archive.sqlite"}, text)
        self.assertEqual(bytes_of["1"], bytes_of["2"])
        self.assertEqual(bytes_of["1"], bytes_of["3"])
        self.size("--seed", "6")
        self.assertNotEqual(self.files()["out/evaluations.csv"], bytes_of["1"][0]["out/evaluations.csv"])
        self.assertEqual(self.result("out/result.json")["seed"], 6)

    def test_options_override_the_study(self):
        write_study(self)
        self.size("--max-evaluations", "17", "--algorithm", "cobyla", "--quiet")
        answer = self.result("out/result.json")
        self.assertEqual((answer["max_evaluations"], answer["algorithm"]), (17, "cobyla"))
        self.assertLessEqual(answer["evaluations"]["search"], 17)
        for arguments, message in (
            (["--algorithm", "magic"], "--algorithm: "),
            (["--threads", "-1"], '--threads: must be from 0 to 1024; got "-1"'),
            (["--max-evaluations", "0"], '--max-evaluations: must be from 1 to 1000000000; got "0"'),
            (["--seed", "x"], '--seed: must be a whole number; got "x"'),
        ):
            result = run("size", "study.json", "--out", "out", *arguments, cwd=self.folder)
            self.assertEqual(result.returncode, 2)
            self.assertTrue(result.stderr.startswith("coilwright: size: " + message), result.stderr)
            self.assertEqual(result.stderr.count("\n"), 1)

    def test_json_prints_the_result_file(self):
        write_study(self)
        self.assertEqual(self.size("--json"), (self.folder / "out/result.json").read_text())

    def test_progress_is_shown_on_a_terminal_and_taken_away_again(self):
        write_study(self)
        for arguments, shown in (([], True), (["--quiet"], False)):
            terminal, stderr = pty.openpty()
            process = subprocess.Popen([PROGRAM, "size", "study.json", "--out", "out", "--force", *arguments], cwd=self.folder,
                                       stdout=subprocess.PIPE, stderr=stderr)
            output, _ = process.communicate(timeout=HANGS)
            os.close(stderr)
            text = b""
            try:
                while piece := os.read(terminal, 4096):
                    text += piece
            except OSError:  # how Linux says that the other end is closed
                pass
            os.close(terminal)
            self.assertEqual(process.returncode, 0)
            self.assertEqual(b" of 60 evaluations" in text, shown)
            self.assertNotIn(b" of 60 evaluations", output)
            if shown:
                self.assertRegex(text, rb"\r +\r$")

    def test_results_name_no_place_and_no_time(self):
        write_study(self)
        self.size()
        for name, content in self.files().items():
            if name.startswith("out/"):
                self.assertNotIn(str(self.folder).encode(), content or b"")

    def test_another_number_of_objectives_is_refused(self):
        write_study(self, objectives=FRONT)
        self.assert_refused(["size", "study.json", "--out", "out"],
                            "study.json: /objectives: must be one for size (pareto takes two or three); got 2")

    def test_folders_that_cannot_be_written_are_refused_before_the_work(self):
        write_study(self, search={"max_evaluations": 1000000})
        self.write("file", "precious")
        for command in ("size",):
            self.assert_refused([command, "study.json", "--out", "file/out"],
                                "file/out: cannot be written: Not a directory")
            self.assert_refused([command, "study.json", "--out", "file"],
                                "file: cannot be written: Not a directory")
            (self.folder / "taken/result.json").mkdir(parents=True)
            self.assert_refused([command, "study.json", "--out", "taken", "--force"],
                                "taken/result.json: cannot be written: Is a directory")


if __name__ == "__main__":
    unittest.main()
