"""Pages of result folders: what is refused, and what is written."""

import html
import json
import re
import unittest

from program import ProgramTest, run
from study import FRONT, GRID, write_study


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

    def specs(self, file):
        """Of each figure of a page its Vega-Lite specification."""
        page = (self.folder / file).read_text()
        return {name: json.loads(text) for name, text in re.findall(
            r'<script type="application/json" class="spec" data-figure="([^"]+)">(.*?)</script>', page, re.DOTALL)}

    def test_what_is_no_folder_of_results_is_refused(self):
        self.assert_refused(("report", "nowhere"), "nowhere: must be a folder of results")
        self.assert_refused(("report", "none"), "none: has neither result.json nor diagnosis.json: it is no folder of size, "
                                                "sweep, pareto or diagnose")
        self.write("none/archive.sqlite", "")
        self.assert_refused(("report", "none"), "none: has no result yet: its run was killed or is under way; the same command "
                                                "with --resume goes on with it")
        self.write("none/result.json", '{"command": "plan"}')
        self.assert_refused(("report", "none"), 'none/result.json: /command: must be "size", "pareto" or "sweep": there is no '
                                                'page of other results; got text "plan"')

    def test_a_damaged_result_is_refused_and_nothing_written(self):
        self.write("none/result.json", '{"command": "size", "study": "s", "objectives": [{"maximise": "mass_g"}]}')
        self.assert_refused(("report", "none"),
                            'none/result.json: /: must have "summary" (docs/formats.md), which an earlier version did not '
                            'write: run it again')

    def test_a_page_comes_with_the_results_where_it_is_asked_for(self):
        self.size("--report")
        page = (self.folder / "out/report.html").read_text()
        again = run("report", "out", "--out", "again.html", cwd=self.folder)
        self.assertEqual((again.returncode, again.stdout), (0, "again.html\n"))
        (self.folder / "\x1b[31mred").mkdir()
        red = run("report", "out", "--out", "\x1b[31mred/a.html", cwd=self.folder)
        self.assertEqual((red.returncode, red.stdout), (0, "\\x1b[31mred/a.html\n"))
        self.assertEqual((self.folder / "again.html").read_text(), page)

    def test_a_page_of_a_run_may_have_a_name_of_its_own(self):
        write_study(self)
        self.write("mine.html", "<p>mine</p>")
        for name, message in (("mine.html", "mine.html: cannot be written: it holds something else; --force replaces it, another "
                                            "--out keeps it"),
                              ("", "size: --report: must not be empty (see coilwright size --help)"),
                              ("page.txt", 'size: --report: must end in .html; got "page.txt" (see coilwright size --help)'),
                              ("no/page.html", "no/page.html: cannot be written: No such file or directory")):
            self.assert_refused(("size", "study.json", "--out", "out", f"--report={name}"), message)  # before the work
        self.assertEqual((self.folder / "out").exists(), False)
        for place, command in enumerate((("size", "--report", "a.html", "study.json", "--out", "out"),
                                         ("size", "study.json", "--out", "new", "--report=new/b.html"),
                                         ("size", "--out", "out", "--report", "study.json"))):
            done = run(*command, "--quiet", "--answer-only", "--force", cwd=self.folder)
            self.assertEqual((done.returncode, done.stderr), (0, ""), command)
            self.assertEqual((self.folder / "out/report.html").exists(), place == 2)
        pages = [(self.folder / name).read_text() for name in ("a.html", "new/b.html", "out/report.html")]
        self.assertEqual(len(set(pages)), 1)
        self.assert_refused(("evaluate", "finger.json", "--current-A", "1", "--report"),
                            "evaluate: --report: 1 required FILE.html missing (see coilwright evaluate --help)")

    def test_the_numbers_of_a_page_are_those_of_its_files(self):
        self.size("--report")
        specs = self.specs("out/report.html")
        result = self.result("out/result.json")
        (objective,) = result["best"]["objectives"]
        series = {row["series"]: row for row in specs["search"]["data"]["values"]}
        best = [float(row["best_" + objective]) for row in self.table("out/convergence.csv") if row["best_" + objective]]
        self.assertEqual(series["best so far"]["y"], best)
        kept = [float(row[objective]) for row in self.table("out/evaluations.csv") if row["status"] == "ok"]
        self.assertEqual(sorted(series["keeps every limit"]["y"]), sorted(kept))
        steps = [step["objective_change"] for step in result["steps"] if step["objective_change"] is not None]
        self.assertEqual([row["value"] for row in specs["steps"]["data"]["values"]], steps)

    def test_the_axes_of_a_front_are_those_of_the_designs_that_keep_every_limit(self):
        write_study(self, objectives=FRONT, constraints=[{"quantity": "mass_g", "at_most": 62}])
        done = run("pareto", "study.json", "--out", "out", "--report", "--quiet", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        # How the search ended is said as on the terminal.
        page = (self.folder / "out/report.html").read_text()
        (end,) = [line for line in done.stdout.splitlines() if "The search ended because" in line]
        self.assertIn(end, html.unescape(page))
        spec = self.specs("out/report.html")["front"]
        rows = [row for row in self.table("out/evaluations.csv") if row["status"] in ("ok", "infeasible")]
        names = ("peak_bending_speed_deg_s", "mass_g")
        inside = {status: 0 for status in ("ok", "infeasible")}
        axes = [spec["layer"][0]["encoding"][axis]["scale"]["domain"] for axis in "xy"]
        for row in rows:
            inside[row["status"]] += all(low <= float(row[name]) <= high for name, (low, high) in zip(names, axes))
        for name, (low, high) in zip(names, axes):
            kept = [float(row[name]) for row in rows if row["status"] == "ok"]
            room = 0.04 * (max(kept) - min(kept))
            self.assertAlmostEqual(low, min(kept) - room, places=9)
            self.assertAlmostEqual(high, max(kept) + room, places=9)
        infeasible = sum(row["status"] == "infeasible" for row in rows)
        self.assertLess(inside["infeasible"], infeasible)
        shown = [each for each in spec["datasets"]["others"] if each["kind"] == "breaks a limit"]
        self.assertEqual(len(shown), inside["infeasible"])
        self.assertIn(f'{infeasible} that break a limit ({infeasible - inside["infeasible"]} outside of the axes)',
                      spec["description"])

    def sweep(self):
        write_study(self, variables=GRID, objectives=FRONT)
        result = run("sweep", "study.json", "--out", "out", "--report", "--quiet", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return self.table("out/designs.csv")

    def test_a_sweep_shows_the_best_at_each_value_of_each_variable(self):
        rows = self.sweep()
        specs = self.specs("out/report.html")
        variables = list(GRID)
        for number, (objective, best_of) in enumerate((("peak_bending_speed_deg_s", max), ("mass_g", min)), start=1):
            for place, name in enumerate(variables, start=1):
                if name == "configuration":
                    continue
                series = {row["series"]: row for row in specs[f"effect-{number}-{place}"]["data"]["values"]}
                for letter in "AB":
                    kept = [row for row in rows if row["configuration"] == letter and row["status"] == "ok"]
                    values = sorted({float(row[name]) for row in kept})
                    line = series[f"best with configuration {letter}"]
                    self.assertEqual(line["x"], values)
                    self.assertEqual(line["y"], [best_of(float(row[objective]) for row in kept if float(row[name]) == value)
                                                 for value in values])
                shown = series["keeps every limit"]
                self.assertEqual(sorted(shown["y"]), sorted(float(row[objective]) for row in rows if row["status"] == "ok"))

    def test_a_sweep_counts_who_breaks_each_limit(self):
        rows = self.sweep()
        margins = [name for name in rows[0] if "_margin" in name and ("_max_" in name or "_min_" in name)]
        page = (self.folder / "out/report.html").read_text().replace("<wbr>", "")
        for name in margins:
            broken = [row for row in rows if row[name] and float(row[name]) < 0]
            alone = [row for row in broken if sum(float(row[other]) < 0 for other in margins) == 1]
            cells = re.search(rf"{name}</t[hd]>\s*<td[^>]*>(\d+)</td>\s*<td[^>]*>(\d+)</td>", page)
            self.assertEqual((int(cells[1]), int(cells[2])), (len(broken), len(alone)), name)

    def test_a_sweep_whose_tables_do_not_belong_together_is_refused(self):
        self.sweep()
        file = self.folder / "out/designs.csv"
        file.write_text("status,gap_mm\nok,1\n")
        self.assert_refused(("report", "out", "--out", "again.html"),
                            "out/designs.csv: must have the columns of best.csv")
        self.assertFalse((self.folder / "again.html").exists())

    def test_evaluate_and_validate_make_a_page_of_what_they_print(self):
        write_study(self)
        done = run("evaluate", "finger.json", "--current-A", "1", "--json", "--report", "one.html", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        printed = json.loads(done.stdout)
        page = (self.folder / "one.html").read_text()
        self.assertIn(f"peak_bending_speed_deg_s {printed['peak_bending_speed_deg_s']:.6g}", page)
        margins = {row["label"].split()[0]: row["value"] for row in self.specs("one.html")["margins"]["data"]["values"]}
        for each in printed["part_limits"]:
            room = each["at_most"] - each["value"] if "at_most" in each else each["value"] - each["at_least"]
            limit = each.get("at_most", each.get("at_least"))
            self.assertAlmostEqual(margins[each["quantity"]], 100 * room / (abs(limit) or 1), places=9)
        done = run("validate", "--json", "--report", "paper.html", cwd=self.folder)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        shown = [row["value"] for row in self.specs("paper.html")["differences"]["data"]["values"]
                 if row["group"].startswith("difference")]
        self.assertEqual(shown, [row["difference_pct"] for row in json.loads(done.stdout)["rows"]])

    def test_a_lumped_model_has_no_page(self):
        self.write("rod.json", json.dumps({
            "format": "lumped-model/1", "name": "rod", "gravity_m_s2": 9.81, "magnetics": None,
            "links": [{"length_m": 0.2, "com_along_m": 0.2, "com_offset_m": 0, "mass_kg": 0.5, "inertia_kgm2": 0}],
            "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 0.005}]}))
        self.assert_refused(("evaluate", "rod.json", "--current-A", "1", "--report", "one.html"),
                            "rod.json: is a lumped model: --report draws a design with its dimensions (actuator/1)")
        self.assertFalse((self.folder / "one.html").exists())

    def test_a_page_never_takes_the_place_of_what_it_is_made_of_or_of_something_else(self):
        write_study(self)
        before = (self.folder / "finger.json").read_bytes()
        (self.folder / "finger.html").symlink_to("finger.json")
        self.assert_refused(("evaluate", "finger.json", "--current-A", "1", "--report", "finger.html"),
                            "finger.html: cannot be written: it is an input of this command")
        self.assert_refused(("evaluate", "finger.json", "--current-A", "1", "--report", "finger.json"),
                            'evaluate: --report: must end in .html; got "finger.json" (see coilwright evaluate --help)')
        self.assertEqual((self.folder / "finger.json").read_bytes(), before)
        self.assert_refused(("evaluate", "finger.json", "--current-A", "1", "--report", "-"),
                            "evaluate: --report: must be a file: standard output has the answer itself "
                            "(see coilwright evaluate --help)")
        self.size()
        result = (self.folder / "out/result.json").read_bytes()
        self.assert_refused(("report", "out", "--out", "out/result.json"),
                            'report: --out: must end in .html; got "out/result.json" (see coilwright report --help)')
        self.assertEqual((self.folder / "out/result.json").read_bytes(), result)

    def test_a_page_of_somebody_is_kept(self):
        self.size()
        kept = "{}: cannot be written: it holds something else; --force replaces it, another --out keeps it"
        evaluate = ("evaluate", "finger.json", "--current-A", "1", "--report", "mine.html")
        report = ("report", "out", "--out", "mine.html")
        self.write("mine.html", "<!DOCTYPE html>\n<title>Mine</title>\n")
        for command in (evaluate, report):
            self.assert_refused(command, kept.format("mine.html"))
        for command in ((*evaluate, "--force"), report, evaluate):  # a page of its own may go
            self.assertEqual(run(*command, cwd=self.folder).returncode, 0)
        (self.folder / "figures").mkdir()
        self.write("figures/section.svg", "<svg/>")
        result = run(*report, "--figures", "figures", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn(kept.format("figures/section.svg"), result.stderr)  # without Node behind another line
        self.assertEqual((self.folder / "figures/section.svg").read_text(), "<svg/>")
        for option in (["--force"], []):
            self.assertEqual(run(*report, "--figures", "figures", *option, cwd=self.folder).returncode, 0)

    def test_every_figure_can_be_had_as_a_file(self):
        self.size()
        done = run("report", "out", "--figures", "figures", cwd=self.folder)
        self.assertEqual(done.returncode, 0)
        names = {path.name for path in (self.folder / "figures").iterdir()}
        self.assertLessEqual({"pose-rest.svg", "pose-peak.svg", "section.svg", "response.vl.json"}, names)
        self.assertNotIn("var(", (self.folder / "figures/pose-rest.svg").read_text())
        # With Node the charts are drawn as well; without, a line says what is missing.
        self.assertEqual("response.svg" in names, done.stderr == "")
        for picture in (self.folder / "figures").glob("*.svg"):
            self.assert_whole_legend(picture)

    def assert_whole_legend(self, picture):
        """A legend of several rows lies below the upper edge of the picture."""
        text = picture.read_text()
        if "role-legend" not in text:
            return
        frame = float(re.search(r'<g fill="none"[^>]* transform="translate\([^,]+,([^)]+)\)"', text)[1])
        legend = float(re.search(r'role-legend"[^>]*><g transform="translate\([^,]+,([^)]+)\)"', text)[1])
        self.assertGreaterEqual(frame + legend, 0.0, picture.name)


if __name__ == "__main__":
    unittest.main()
