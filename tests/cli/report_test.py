"""Pages of result folders: what is refused, and what is written."""

import json
import re
import unittest

from program import ProgramTest, run
from study import write_study


class Report(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "none").mkdir()
        if "built without Vega" in run("report", "none", cwd=self.folder).stderr:
            self.skipTest("the program was built without Vega")

    def size(self, *arguments):
        write_study(self)
        result = run("size", "study.json", "--out", "out", "--quiet", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_what_is_no_folder_of_results_is_refused(self):
        self.assert_refused(("report", "nowhere"), "nowhere: must be a folder of results")
        self.assert_refused(("report", "none"), "none: has neither result.json nor diagnosis.json: it is no folder of size, "
                                                "pareto or diagnose")
        self.write("none/result.json", '{"command": "sweep"}')
        self.assert_refused(("report", "none"), 'none/result.json: /command: must be "size" or "pareto": there is no page of '
                                                'other results; got text "sweep"')

    def test_a_damaged_result_is_refused_and_nothing_written(self):
        self.write("none/result.json", '{"command": "size", "study": "s", "objectives": [{"maximise": "mass_g"}]}')
        self.assert_refused(("report", "none"),
                            "none/result.json: lacks a key that these results have (docs/formats.md)")

    def test_a_page_comes_with_the_results_where_it_is_asked_for(self):
        self.size("--report")
        page = (self.folder / "out/report.html").read_text()
        again = run("report", "out", "--out", "again.html", cwd=self.folder)
        self.assertEqual((again.returncode, again.stdout), (0, "again.html\n"))
        self.assertEqual((self.folder / "again.html").read_text(), page)

    def test_the_numbers_of_a_page_are_those_of_its_files(self):
        self.size("--report")
        page = (self.folder / "out/report.html").read_text()
        specs = {name: json.loads(text) for name, text in re.findall(
            r'<script type="application/json" class="spec" data-figure="([^"]+)">(.*?)</script>', page, re.DOTALL)}
        result = self.result("out/result.json")
        (objective,) = result["best"]["objectives"]
        series = {row["series"]: row for row in specs["search"]["data"]["values"]}
        best = [float(row["best_" + objective]) for row in self.table("out/convergence.csv") if row["best_" + objective]]
        self.assertEqual(series["best so far"]["y"], best)
        kept = [float(row[objective]) for row in self.table("out/evaluations.csv") if row["status"] == "ok"]
        self.assertEqual(sorted(series["keeps every limit"]["y"]), sorted(kept))
        steps = [step["objective_change"] for step in result["steps"] if step["objective_change"] is not None]
        self.assertEqual([row["value"] for row in specs["steps"]["data"]["values"]], steps)

    def test_every_figure_can_be_had_as_a_file(self):
        self.size()
        done = run("report", "out", "--figures", "figures", cwd=self.folder)
        self.assertEqual(done.returncode, 0)
        names = {path.name for path in (self.folder / "figures").iterdir()}
        self.assertLessEqual({"pose-rest.svg", "pose-peak.svg", "section.svg", "response.vl.json"}, names)
        self.assertNotIn("var(", (self.folder / "figures/pose-rest.svg").read_text())
        # With Node the charts are drawn as well; without, a line says what is missing.
        self.assertEqual("response.svg" in names, done.stderr == "")


if __name__ == "__main__":
    unittest.main()
