"""`coilwright sweep`: every design in order, the best of each configuration, bounded memory, Ctrl-C."""

import itertools
import json
import signal
import subprocess
import time
import unittest

from archived_runs import results_of
from program import HANGS, PROGRAM, ProgramTest, peak_memory_of_children, run
from study import FRONT, GRID, write_study


class Sweep(ProgramTest):
    def sweep(self, *arguments, code=0):
        result = run("sweep", "study.json", "--out", "out", "--force", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (code, ""))
        return result.stdout

    def test_writes_every_design_of_the_grid_once_and_in_order(self):
        write_study(self, variables=GRID)
        self.sweep()
        rows = self.table("out/designs.csv")
        expected = list(itertools.product("AB", (12, 13, 14, 15), (0.7, 0.9, 1.1, 1.3)))
        got = [(row["configuration"], float(row["turns_radial"]), float(row["gap_mm"])) for row in rows]
        self.assertEqual(got, expected)

    def test_a_sample_needs_no_grid(self):
        write_study(self, variables={"gap_mm": {"lower": 0.7, "upper": 1.3}, "turns_radial": {"values": [12, 15]}})
        self.assert_refused(["sweep", "study.json", "--out", "out"], 'study.json: /variables/gap_mm: needs "step" or "values" in a sweep, or --sample N')
        self.sweep("--sample", "8")
        rows = self.table("out/designs.csv")
        self.assertEqual(sorted(int((float(row["gap_mm"]) - 0.7) / 0.6 * 8) for row in rows), list(range(8)))
        self.assertEqual(sorted(row["turns_radial"] for row in rows), ["12"] * 4 + ["15"] * 4)
        self.assertEqual(self.result("out/result.json")["sample"], {"sampling": "latin_hypercube", "drawn": 8, "seed": 5})
        self.assertEqual(self.result("out/provenance.json")["seed"], 5)
        self.sweep("--sample", "8", "--threads", "1")
        self.assertEqual(self.table("out/designs.csv"), rows)
        self.sweep("--sample", "8", "--sampling", "random")
        self.assertNotEqual(self.table("out/designs.csv"), rows)
        result = run("sweep", "study.json", "--out", "out", "--sampling", "random", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (2, "coilwright: sweep: --sampling requires --sample (see coilwright sweep --help)\n"))

    def test_a_sample_has_each_design_once(self):
        write_study(self, variables={"turns_radial": {"values": [12, 15]}}, constraints=None)
        text = self.sweep("--sample", "8")
        self.assertEqual(sorted(row["turns_radial"] for row in self.table("out/designs.csv")), ["12", "15"])
        self.assertIn("2 of 2 designs evaluated (those that differ of 8 drawn: latin_hypercube, seed 5)", text)
        self.assertEqual(self.result("out/result.json")["designs"], 2)

    def test_another_sample_is_refused_in_the_folder_of_the_first(self):
        write_study(self, constraints=None)
        self.sweep("--sample", "8")
        before = results_of(self.folder / "out")
        for options, differing in (
                (("--sample", "9"), "latin_hypercube of 8 designs, not latin_hypercube of 9 designs"),
                (("--sample", "8", "--sampling", "random"), "latin_hypercube of 8 designs, not random of 8 designs")):
            self.assert_refused(["sweep", "study.json", "--out", "out", *options],
                                f"out: holds the archive of another run (algorithm {differing}): --force replaces it, "
                                "another --out keeps it, and --reuse out takes its designs over")
            self.assertEqual(results_of(self.folder / "out"), before)

    def test_a_row_is_what_evaluate_says(self):
        # evaluate does not know which figures matter: it takes the worse of both poses.
        write_study(self, variables=GRID,
                    operating_point={"share_of_current_limit": 0.9, "duty": 0.5, "cases": "both"})
        self.sweep()
        row = next(row for row in self.table("out/designs.csv")
                   if (row["configuration"], row["turns_radial"], row["gap_mm"]) == ("A", "13", "0.9"))
        result = run("evaluate", "finger.json", "--current-A", row["current_A"], "--duty", "0.5", "--json", "--set",
                     "configuration=A", "--set", "turns_radial=13", "--set", "gap_mm=0.9", cwd=self.folder)
        performance = json.loads(result.stdout)
        compared = 0
        for key, value in performance.items():
            if isinstance(value, float):
                self.assertEqual(float(row[key]), value, key)
                compared += 1
        self.assertGreater(compared, 25)
        self.assertAlmostEqual(float(row["mass_max_margin_g"]), 66 - performance["mass_g"], places=9)

    def test_the_best_of_each_configuration_is_the_best_of_its_feasible_rows(self):
        write_study(self, variables=GRID, objectives=FRONT)
        text = self.sweep()
        rows, best = self.table("out/designs.csv"), self.table("out/best.csv")
        self.assertEqual([(row["configuration"], row["best_for"]) for row in best],
                         list(itertools.product("AB", ("peak_bending_speed_deg_s", "mass_g"))))
        for row in best:
            rivals = [float(other[row["best_for"]]) for other in rows
                      if other["configuration"] == row["configuration"] and other["status"] == "ok"]
            best_of = max if row["best_for"] == "peak_bending_speed_deg_s" else min
            self.assertEqual(float(row[row["best_for"]]), best_of(rivals))
        self.assertIn("32 of 32 designs evaluated", text)

    def test_configurations_alone_are_the_simplest_sweep(self):
        write_study(self, variables={"configuration": {"values": ["A", "B", "C", "D"]}}, constraints=None, search=None)
        text = self.sweep()
        mass = {row["configuration"]: float(row["mass_g"]) for row in self.table("out/designs.csv")}
        self.assertEqual(sorted(mass, key=mass.get), ["A", "B", "C", "D"])
        warnings, table = text.split("\nMIND what the best designs need, or give up\n")[1].split("\nThe best designs\n")
        self.assertEqual(len(table.splitlines()), 1 + 4)  # header, a line each
        self.assertRegex(warnings, r"^  thermal_load_still_air: 4 of 4 designs: only moving air,")

    def test_a_configuration_with_nothing_feasible_says_what_is_in_the_way(self):
        write_study(self, variables={"configuration": {"values": ["A", "C"]}},
                    constraints=[{"quantity": "mass_g", "at_most": 60}])
        text = self.sweep()
        self.assertRegex(text, r"C +\S+ +none is feasible; the nearest: mass_g <= 60 violated by [\d.]+ g\n")
        self.assertEqual([row["status"] for row in self.table("out/best.csv")], ["ok", "infeasible"])

    def test_nothing_feasible_at_all_is_3(self):
        write_study(self, variables=GRID, constraints=[{"quantity": "mass_g", "at_most": 6}])
        self.sweep(code=3)
        self.assertEqual([row["status"] for row in self.table("out/best.csv")], ["infeasible", "infeasible"])

    def test_json_says_what_the_table_says(self):
        write_study(self, variables=GRID, objectives=FRONT)
        answer = json.loads(self.sweep("--json"))
        self.assertEqual((answer["study"], answer["designs"], answer["evaluated"]), ("small", 32, 32))
        best = self.table("out/best.csv")
        self.assertEqual([entry["best_for"] for entry in answer["best"]], [row["best_for"] for row in best])
        for entry, row in zip(answer["best"], best):
            self.assertEqual(entry["variables"]["gap_mm"], float(row["gap_mm"]))
            self.assertEqual(entry["objectives"]["mass_g"], float(row["mass_g"]))
            self.assertEqual(entry["status"], "ok")

    def test_threads_change_no_byte(self):
        write_study(self, variables=GRID, objectives=FRONT)
        outputs = []
        for threads in ("1", "2"):
            text = self.sweep("--threads", threads)
            # The archive says when each design was evaluated, and how long that took.
            outputs.append((text, {k: v for k, v in self.files().items()
                                   if k.startswith("out/") and k != "out/archive.sqlite"}))
        self.assertEqual(outputs[0], outputs[1])

    def test_a_variable_without_end_is_refused(self):
        write_study(self)
        self.assert_refused(["sweep", "study.json", "--out", "out"],
                            'study.json: /variables/gap_mm: needs "step" or "values" in a sweep, or --sample N')
        huge = {name: {"lower": 1, "upper": 2, "step": 2e-6}
                for name in ("gap_mm", "side_wall_mm", "top_wall_mm")}
        write_study(self, variables=huge)
        self.assert_refused(["sweep", "study.json", "--out", "out"],
                            "study.json: /variables: a grid must have at most 1000000000000 designs")

    def test_a_million_designs_stream_in_bounded_memory(self):
        # Too tight a bore for the wire: refused at once, so that this takes seconds.
        write_study(self, variables={"configuration": {"values": ["A", "B", "C", "D"]},
                                     "coil_inner_radius_mm": {"lower": 0.1, "upper": 0.5, "step": 0.1},
                                     "turns_radial": {"lower": 1, "upper": 50}, "turns_axial": {"lower": 1, "upper": 20},
                                     "gap_mm": {"lower": 0.6, "upper": 5.5, "step": 0.1}})
        self.assertIn("1000000 of 1000000 designs evaluated", self.sweep("--quiet", code=3))
        with open(self.folder / "out/designs.csv") as file:
            self.assertEqual(sum(1 for _ in file), 1_000_001)
        # What a sanitizer keeps beside it is not the program's.
        self.assertLess(peak_memory_of_children(), 200_000_000)

    def test_ctrl_c_writes_what_was_evaluated_so_far(self):
        write_study(self, variables={"configuration": {"values": ["B", "C"]},
                                     "gap_mm": {"lower": 0.7, "upper": 1.6, "step": 1e-6}})
        process = subprocess.Popen([PROGRAM, "sweep", "study.json", "--out", "out"], cwd=self.folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")
        deadline = time.monotonic() + 60
        part = self.folder / "out" / f".designs.csv.part-{process.pid}"
        while not (part.exists() and part.stat().st_size > 50_000):
            self.assertLess(time.monotonic(), deadline)
            self.assertIsNone(process.poll())
            time.sleep(0.02)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=HANGS)
        self.assertEqual((process.returncode, errors), (130, "coilwright: interrupted: what was evaluated is in "
                                                         "out/archive.sqlite; --resume goes on from there\n"))
        rows = self.table("out/designs.csv")
        self.assertIn(f"{len(rows)} of 1800002 designs evaluated", output)
        for index, row in enumerate(rows):
            self.assertAlmostEqual(float(row["gap_mm"]), 0.7 + index * 1e-6, places=12)
            self.assertNotEqual(row["mass_g"], "")
        self.assertEqual(sorted(path.name for path in (self.folder / "out").iterdir()), ["archive.sqlite", "best.csv", "designs.csv", "provenance.json", "result.json"])


if __name__ == "__main__":
    unittest.main()
