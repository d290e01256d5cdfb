"""`--start DIR` of size and pareto: a search that begins with what the archives of other runs answer."""

import itertools
import json
import unittest

from program import ProgramTest, run
from study import FRONT, GRID, write_study
from system_study_test import GRIPPER

NAMES = ("peak_bending_speed_deg_s", "mass_g")
VARIABLES = ("turns_radial", "wire_gauge_AWG", "gap_mm")


def losses(row):
    return -float(row[NAMES[0]]), float(row[NAMES[1]])


class Start(ProgramTest):
    def search(self, command, out, *arguments, told="", **changes):
        write_study(self, **changes)
        result = run(command, "study.json", "--out", out, *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, told))
        return result.stdout

    def rows(self, out, proposed_by=None):
        rows = sorted(self.table(f"{out}/evaluations.csv"), key=lambda row: int(row["evaluation"]))
        return [row for row in rows if proposed_by in (None, row["proposed_by"])]

    def assert_in_front(self, design, out):
        """Of a design of evaluations.csv: it, or one that beats it."""
        self.assertEqual(design["status"], "ok")
        front = [losses(row) for row in self.table(f"{out}/front.csv")]
        self.assertTrue(any(all(a <= b for a, b in zip(each, losses(design))) for each in front), losses(design))

    def test_a_front_has_what_size_found_or_beats_it(self):
        self.search("size", "fast", "--answer-only", search={"max_evaluations": 200, "seed": 5})
        self.search("size", "light", "--answer-only", objectives=FRONT[1:], search={"max_evaluations": 200, "seed": 5})
        # Other limits and another operating point: only the points are taken.
        small = {"objectives": FRONT, "search": {"max_evaluations": 12, "seed": 3},
                 "constraints": [{"quantity": "mass_g", "at_most": 80}],
                 "operating_point": {"share_of_current_limit": 0.8, "duty": 0.5}}
        self.search("pareto", "front", "--start", "fast", "--start", "light", **small)
        first = self.rows("front", "start")
        self.assertEqual([int(row["evaluation"]) for row in first], [1, 2, 3])
        for row, folder in zip(first[1:], ("fast", "light")):
            best = self.result(f"{folder}/result.json")["best"]["variables"]
            self.assertEqual([float(row[name]) for name in VARIABLES], [best[name] for name in VARIABLES])
            self.assert_in_front(row, "front")
        self.assertLessEqual(len(self.rows("front")), 12)
        self.search("pareto", "alone", **small)
        self.assertEqual(len(self.rows("alone", "start")), 1)

    def test_every_design_of_a_front_starts_a_search_of_any_algorithm(self):
        self.search("pareto", "front", objectives=FRONT)
        front = self.table("front/front.csv")
        expected = [[row[name] for name in VARIABLES] for row in front]
        for command, algorithm, objectives in (("pareto", "automatic", FRONT), ("size", "automatic", FRONT[:1]),
                                               ("size", "cobyla", FRONT[:1])):
            out = command + algorithm
            with self.subTest(out):
                self.search(command, out, "--start", "front", "--algorithm", algorithm, objectives=objectives,
                            search={"max_evaluations": len(front) + 5, "seed": 3})
                started = [[row[name] for name in VARIABLES] for row in self.rows(out, "start")]
                # The study's own actuator is one of them, or comes before them.
                self.assertEqual([each for each in started if each in expected],
                                 sorted(expected, key=started.index))
                if command == "size":
                    best = self.result(f"{out}/result.json")["best"]["objectives"][NAMES[0]]
                    self.assertGreaterEqual(best, max(float(row[NAMES[0]]) for row in front))
        for design in self.rows("paretoautomatic", "start"):
            if design["status"] == "ok":
                self.assert_in_front(design, "paretoautomatic")

    def test_what_a_study_does_not_take_is_told(self):
        self.search("size", "one", "--answer-only", variables={"turns_radial": {"values": [16]},
                                                               "gap_mm": {"values": [1.5]}}, constraints=None)
        self.search("size", "nearest", "--start", "one", "--answer-only", constraints=None,
                    variables={"gap_mm": {"lower": 0.7, "upper": 1.2}},
                    told="coilwright: one/archive.sqlite: varies turns_radial, which this study does not: its designs start "
                         "with what the study has there\n"
                         "coilwright: one/archive.sqlite: 1 of 1 designs have values that this study does not take, and "
                         "start at the nearest that it takes (first gap_mm 1.5, here 1.2)\n")
        self.assertIn(1.2, [float(row["gap_mm"]) for row in self.rows("nearest", "start")])

    def test_a_word_that_a_study_does_not_take_has_no_nearest(self):
        kinds = {"configuration": {"values": ["A", "B"]}, "turns_radial": {"lower": 12, "upper": 15}}
        self.search("pareto", "both", variables=kinds, objectives=[{"minimise": "mass_g"}, {"maximise": "stroke_deg"}],
                    constraints=None)
        rows = self.table("both/front.csv")
        of_b = [row for row in rows if row["configuration"] == "B"]
        self.assertTrue(0 < len(of_b) < len(rows))
        self.search("size", "b", "--start", "both", "--answer-only", constraints=None,
                    variables={**kinds, "configuration": {"values": ["B", "C"]}},
                    told=f"coilwright: both/archive.sqlite: {len(rows) - len(of_b)} of {len(rows)} designs are left out, as "
                         "this study does not take them (first configuration A)\n")
        write_study(self, variables={**kinds, "configuration": {"values": ["C", "D"]}}, constraints=None)
        refused = run("size", "study.json", "--out", "none", "--start", "both", cwd=self.folder)
        self.assertEqual((refused.returncode, refused.stdout), (2, ""))
        self.assertRegex(refused.stderr, r"\Acoilwright: both/archive\.sqlite: must have a design that this study takes, "
                                         r"and it takes no configuration [AB]: add it to the study's values\n\Z")

    def test_the_best_of_a_sweep_and_of_a_run_that_was_killed_are_starts(self):
        self.search("sweep", "swept", variables=GRID, objectives=FRONT)
        best = [row for row in self.table("swept/designs.csv") if row["status"] == "ok"]
        front = [row for row in best if not any(
            losses(each) != losses(row) and all(a <= b for a, b in zip(losses(each), losses(row))) for each in best)]
        # A run that was killed has nothing but its archive.
        for file in (self.folder / "swept").iterdir():
            if not file.name.startswith("archive.sqlite"):
                file.unlink()
        self.search("pareto", "out", "--start", "swept", variables={**GRID, "gap_mm": {"lower": 0.7, "upper": 1.3}},
                    objectives=FRONT)
        started = {losses(row) for row in self.rows("out", "start")[1:]}
        self.assertEqual(started, {losses(row) for row in front})
        self.assertGreater(len(started), 1)

    def test_refusals(self):
        self.search("size", "one", "--answer-only", variables={"gap_mm": {"lower": 0.7, "upper": 1.6}}, constraints=None)
        self.search("pareto", "front", objectives=FRONT)
        designs = len(self.table("front/front.csv"))
        for folder, more, message in (
                ("one", (), "one/archive.sqlite: must have turns_radial, which the study varies: start from a run that "
                            "varies it, too"),
                ("front", ("--max-evaluations", designs),
                 f"--start: must bring fewer designs ({designs}) than max_evaluations ({designs}), as the study's own "
                 "actuator comes first: give --max-evaluations")):
            with self.subTest(folder):
                self.assert_refused(("pareto", "study.json", "--out", "out", "--start", folder, *more), message)
        self.assert_refused(("distribute", "study.json", "--as", "pareto", "--parts", 2, "--out", "work",
                             "--options", "--start front"),
                            "--options: must not have --start, which distribute sets or parts cannot have")
        (self.folder / "text").mkdir()
        self.write("text/archive.sqlite", "no archive")
        for option, folder in itertools.product(("--start", "--reuse"), ("nowhere", "text", "study.json")):
            with self.subTest(option=option, folder=folder):
                refused = run("pareto", "study.json", "--out", "out", option, folder, cwd=self.folder)
                self.assertEqual((refused.returncode, refused.stdout), (2, ""))
                self.assertRegex(refused.stderr, rf"\Acoilwright: {option}: must name the folder of a run of size, pareto or "
                                                 rf"sweep: {folder}/archive\.sqlite: [^\n]+\n\Z")
        for option in ("--start", "--reuse"):
            self.assert_refused(("pareto", "study.json", "--out", "out", option, "nowhere"),
                                f"{option}: must name the folder of a run of size, pareto or sweep: "
                                "nowhere/archive.sqlite: cannot be read: there is no such file")
        self.assert_refused(("pareto", "study.json", "--out", "front", "--start", "front", "--force"),
                            "front/archive.sqlite: cannot be written: it is an input of this command")
        self.assertFalse((self.folder / "out/result.json").exists())

    def test_a_folder_without_an_answer(self):
        write_study(self, objectives=FRONT, constraints=[{"quantity": "mass_g", "at_most": 1}])
        self.assertEqual(run("pareto", "study.json", "--out", "none", cwd=self.folder).returncode, 3)
        write_study(self)
        self.assert_refused(("size", "study.json", "--out", "out", "--start", "none"),
                            "none/archive.sqlite: must have a design that keeps its limits to start from, and has none: "
                            "leave out --start")

    def test_a_folder_is_not_gone_on_with_from_other_starts(self):
        self.search("size", "one", "--answer-only")
        self.search("size", "other", "--answer-only", "--seed", "8", search={"max_evaluations": 10})
        whole = self.search("pareto", "out", "--start", "one", objectives=FRONT)
        bytes_of_run = (self.folder / "out/evaluations.csv").read_bytes()
        self.search("pareto", "plain", objectives=FRONT)
        told, plain = self.result("out/provenance.json"), self.result("plain/provenance.json")
        self.assertEqual([each["file"] for each in told["starts"]], ["one/archive.sqlite"])
        self.assertNotIn("starts", plain)
        # It is the same question, and its designs have the same numbers.
        self.assertEqual(told["question_sha256"], plain["question_sha256"])
        self.assertEqual(self.search("pareto", "out", "--start", "one", "--resume", objectives=FRONT), whole)
        self.assertEqual((self.folder / "out/evaluations.csv").read_bytes(), bytes_of_run)
        for folder, starts in (("out", ()), ("out", ("--start", "other")), ("plain", ("--start", "one"))):
            for how in ("--resume", "--quiet"):
                with self.subTest(folder=folder, starts=starts, how=how):
                    result = run("pareto", "study.json", "--out", folder, how, *starts, cwd=self.folder)
                    self.assertEqual(result.returncode, 2)
                    self.assertIn("holds the archive of another run (algorithm", result.stderr)
                    self.assertIn("from --start of SHA-256 ", result.stderr)
        replayed = run("archive", "replay", "out", "--row", 2, "--json", cwd=self.folder)
        self.assertEqual(replayed.returncode, 0, replayed.stderr)
        self.assertTrue(json.loads(replayed.stdout)["same"])

    def test_designs_of_a_gripper_are_reused_wherever_the_search_began(self):
        study = {"gripper": {**GRIPPER, "spacing_mm": 70}, "operating_point": {"duty": 1}, "constraints": None,
                 "variables": {"current_A": {"values": [1, 1.4]}, "turns_radial": {"lower": 14, "upper": 15}},
                 "objectives": [{"minimise": "gripper_mass_g"}]}
        self.search("size", "one", "--answer-only", **study)
        self.search("size", "out", "--answer-only", "--start", "one", "--reuse", "one", **study)
        self.assertEqual(len(self.rows("out")), len(self.rows("one")))


if __name__ == "__main__":
    unittest.main()
