"""`coilwright pareto`: a front that no evaluated design beats, its files, Ctrl-C."""

import html
import json
import signal
import subprocess
import time
import unittest

from program import HANGS, PROGRAM, ProgramTest, run
from study import FRONT, write_study

NAMES = ("peak_bending_speed_deg_s", "mass_g")


def losses(row):
    """Both objectives of a row as numbers to make small."""
    return -float(row[NAMES[0]]), float(row[NAMES[1]])


class Pareto(ProgramTest):
    def pareto(self, *arguments, code=0):
        result = run("pareto", "study.json", "--out", "out", "--force", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (code, ""))
        return result.stdout

    def test_the_front_is_what_no_evaluated_design_beats(self):
        write_study(self, objectives=FRONT)
        self.pareto()
        front, rows = self.table("out/front.csv"), self.table("out/evaluations.csv")
        asked_for = ["turns_radial", "wire_gauge_AWG", "gap_mm", *NAMES, "mass_max_margin_g", "thermal_load_max_margin"]
        self.assertEqual(list(front[0])[:len(asked_for)], asked_for)
        # And every other quantity, each once.
        others = list(front[0])[len(asked_for):]
        listed = json.loads(run("list", "quantities", "--json").stdout)
        quantities = {row["key"] for row in listed if row["of"] == "evaluate"}
        self.assertEqual(set(others), quantities - set(NAMES))
        self.assertEqual(len(others), len(set(others)))
        feasible = {losses(row) for row in rows if row["status"] == "ok"}

        def beaten(a):
            return any(b != a and b[0] <= a[0] and b[1] <= a[1] for b in feasible)

        got = [losses(row) for row in front]
        self.assertEqual(sorted(got), sorted(a for a in feasible if not beaten(a)))
        self.assertEqual(got, sorted(got))  # fastest first
        self.assertGreater(len(front), 3)
        for row in front:
            self.assertGreaterEqual(min(float(row["mass_max_margin_g"]), float(row["thermal_load_max_margin"])), 0)
        answer = self.result("out/result.json")
        self.assertEqual((answer["front_size"], answer["evaluations"]["total"]), (len(front), len(rows)))
        self.assertLessEqual(len(rows), 60)

    def test_the_hypervolume_is_that_of_the_front_in_its_own_frame(self):
        write_study(self, objectives=FRONT)
        self.pareto()
        points = [losses(row) for row in self.table("out/front.csv")]
        ideal, nadir = [[pick(point[i] for point in points) for i in (0, 1)] for pick in (min, max)]
        # From 0 (ideal) to 1 (nadir), fastest first: steps of a staircase up to the reference 1.1.
        scaled = sorted(tuple((point[i] - ideal[i]) / (nadir[i] - ideal[i]) for i in (0, 1)) for point in points)
        edges = [point[0] for point in scaled[1:]] + [1.1]
        volume = sum((edge - point[0]) * (1.1 - point[1]) for point, edge in zip(scaled, edges))
        self.assertAlmostEqual(self.result("out/result.json")["hypervolume"], volume, places=9)

    def test_json_prints_the_result_file(self):
        write_study(self, objectives=FRONT)
        self.assertEqual(self.pareto("--json"), (self.folder / "out/result.json").read_text())

    def test_the_ends_are_printed_and_written(self):
        write_study(self, objectives=FRONT)
        text = self.pareto()
        answer, front = self.result("out/result.json"), self.table("out/front.csv")
        for end, name, best in zip(answer["ends"], NAMES, (max, min)):
            self.assertEqual(end["objectives"][name], best(float(row[name]) for row in front))
            self.assertIn("best " + name, text)
        self.assertIn("\n  middle ", text)

    def test_names_configurations_that_are_not_on_the_front(self):
        # D has the parts of A twice and more: it is heavier and dearer.
        write_study(self, objectives=[{"minimise": "mass_g"}, {"minimise": "cost_USD"}],
                    variables={"configuration": {"values": ["A", "D"]}, "turns_radial": {"lower": 12, "upper": 13}},
                    constraints=None)
        text = self.pareto()
        self.assertEqual({row["configuration"] for row in self.table("out/front.csv")}, {"A"})
        self.assertIn("No design of configuration D is on it: each that was found is beaten or breaks a limit.\n", text)

    def test_counts_designs_that_break_limits_of_their_parts(self):
        write_study(self, objectives=FRONT, operating_point={"current_A": 1.4, "duty": 1}, constraints=None)
        result = run("pareto", "study.json", "--out", "out", "--report", cwd=self.folder)
        answer = self.result("out/result.json")
        hot = [row for row in self.table("out/front.csv") if float(row["magnet_temperature_degC"]) > 60]
        (told,) = [each for each in answer["broken_part_limits"] if each["quantity"] == "magnet_temperature_degC"]
        self.assertGreater(told["designs"], 0)
        self.assertEqual(told["designs"], len(hot))
        line = f"  magnet_temperature_degC: {len(hot)} of {answer['front_size']} designs: {told['consequence']}\n"
        self.assertIn("\nBEWARE: designs of this front break limits of their parts\n", result.stdout)
        self.assertIn(line, result.stdout)
        self.assertIn(line.strip(), html.unescape((self.folder / "out/report.html").read_text()))

    def test_three_objectives_of_either_sense(self):
        write_study(self, objectives=[*FRONT, {"maximise": "grasp_force_N"}], constraints=None)
        self.pareto()
        forces = [float(row["grasp_force_N"]) for row in self.table("out/front.csv")]
        self.assertEqual(self.result("out/result.json")["ends"][2]["objectives"]["grasp_force_N"], max(forces))

    def test_threads_change_no_byte_of_any_file(self):
        write_study(self, objectives=FRONT)
        outputs = []
        for threads in ("1", "2"):
            text = self.pareto("--threads", threads)
            # The archive says when each design was evaluated, and how long that took.
            outputs.append((text, {k: v for k, v in self.files().items()
                                   if k.startswith("out/") and k != "out/archive.sqlite"}))
        self.assertEqual(outputs[0], outputs[1])
        self.pareto("--seed", "11")
        self.assertNotEqual(self.files()["out/evaluations.csv"], outputs[0][1]["out/evaluations.csv"])

    def test_nothing_feasible_is_3_and_the_nearest_design_is_written(self):
        write_study(self, objectives=FRONT, constraints=[{"quantity": "mass_g", "at_most": 40}])
        text = self.pareto(code=3)
        answer = self.result("out/result.json")
        self.assertEqual(self.table("out/front.csv"), [])
        self.assertEqual(answer["least_infeasible"]["violated"], ["mass_g <= 40"])
        self.assertIsNone(answer["hypervolume"])
        self.assertRegex(text, r"It is not feasible: mass_g <= 40 violated by [\d.]+ g\n")

    def test_one_objective_is_refused(self):
        write_study(self)
        self.assert_refused(["pareto", "study.json", "--out", "out"],
                            "study.json: /objectives: must be two or three for pareto (size takes one); got 1")

    def test_ctrl_c_writes_what_was_found_so_far(self):
        for command, objectives in (("pareto", FRONT), ("size", FRONT[:1])):
            write_study(self, objectives=objectives, search={"max_evaluations": 1000000, "algorithm": "isres"})
            process = subprocess.Popen([PROGRAM, command, "study.json", "--out", command], cwd=self.folder,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
            deadline = time.monotonic() + 30
            while not (self.folder / command).exists():  # from then on Ctrl-C is caught
                self.assertLess(time.monotonic(), deadline)
                time.sleep(0.02)
            time.sleep(2)  # enough for some hundred evaluations
            process.send_signal(signal.SIGINT)
            output, errors = process.communicate(timeout=HANGS)
            with self.subTest(command):
                self.assertEqual((process.returncode, errors), (130, f"coilwright: interrupted: what was evaluated is in "
                                                              f"{command}/archive.sqlite; --resume goes on from there\n"))
                self.assertIn("it was interrupted", output)
                answer, rows = self.result(f"{command}/result.json"), self.table(f"{command}/evaluations.csv")
                self.assertEqual(answer["stop_reason"], "interrupted")
                self.assertEqual(answer["evaluations"]["total"], len(rows))
                self.assertGreater(len(rows), 0)


if __name__ == "__main__":
    unittest.main()
