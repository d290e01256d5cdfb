"""`coilwright archive`: designs that were recorded, listed, selected, taken out and evaluated again."""

import csv
import io
import json
import resource
import unittest

from archived_runs import forge
from program import ProgramTest, run
from study import write_study


class Archive(ProgramTest):
    def setUp(self):
        super().setUp()
        write_study(self, search={"max_evaluations": 40, "seed": 5})
        result = run("size", "study.json", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        # An archive is enough: the files that it was made of may change or go.
        (self.folder / "finger.json").unlink()
        (self.folder / "study.json").unlink()

    def archive(self, command, *arguments, code=0):
        result = run("archive", command, "out", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (code, ""))
        return result.stdout

    def designs(self, command, *arguments):
        return json.loads(self.archive(command, *arguments, "--json"))["designs"]

    def change(self, sql):
        forge(self.folder / "out", sql)

    def test_check_says_that_every_row_is_what_was_written(self):
        counts = self.result("out/result.json")["evaluations"]
        self.assertEqual(self.archive("check"),
                         f'out/archive.sqlite: {counts["total"]} designs of 1 runs, each as it was written.\n')
        self.assertEqual(json.loads(self.archive("check", "--repair", "--json")),
                         {"archive": "out/archive.sqlite", "designs": counts["total"], "runs": 1, "has_checksums": True,
                          "mended": 0, "dropped": 0, "dropped_rows": [], "gone": 0})

    def test_a_checksum_is_what_the_docs_say(self):
        self.change("UPDATE designs SET number = number")  # all checksums anew, by the test's own function
        self.archive("check")

    def test_list_says_what_it_is_of_and_which_runs_wrote_it(self):
        counts = self.result("out/result.json")["evaluations"]
        text = self.archive("list")
        self.assertIn(f'size of "small": {counts["total"]} designs recorded; {counts["ok"]} keep every limit, '
                      f'{counts["infeasible"]} break one, {counts["failed"]} could not be evaluated.\n', text)
        self.assertRegex(text, r"From study\.json \(SHA-256 [0-9a-f]{8}\) and finger\.json \(SHA-256 [0-9a-f]{8}\); algorithm "
                               r"automatic, seed 5\.\n")
        self.assertRegex(text, r"\n  1  \d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ  \d{4}\S+Z  evaluation_limit +40 ")
        told = json.loads(self.archive("list", "--json"))
        self.assertEqual((told["command"], told["seed"], told["designs"]["ok"]), ("size", 5, counts["ok"]))
        self.assertEqual(told["runs"][0]["evaluated"], counts["total"])
        self.assertEqual(told["question_sha256"], self.result("out/provenance.json")["question_sha256"])

    def test_list_says_of_a_killed_run_that_it_has_not_ended(self):
        self.change("UPDATE runs SET ended_utc = NULL, stop_reason = NULL, evaluated = 0")
        self.assertRegex(self.archive("list"), r"\n  1  \S+Z  killed, or under way +- +40 +- +- +-\n")

    def test_csv_has_the_numbers_of_the_result_files(self):
        rows = list(csv.DictReader(io.StringIO(self.archive("csv"))))
        evaluations = {row["evaluation"]: row for row in self.table("out/evaluations.csv")}
        self.assertEqual(len(rows), len(evaluations))
        for row in rows:
            known = evaluations[row["number"]]
            for name in ("turns_radial", "wire_gauge_AWG", "gap_mm", "status", "peak_bending_speed_deg_s", "mass_g", "reason"):
                self.assertEqual(row[name], known[name], name)
        self.archive("csv", "--out", "all.csv")
        self.assertEqual([dict(row) for row in self.table("all.csv")], rows)
        heavy = list(csv.DictReader(io.StringIO(self.archive("csv", "--where", "mass_g > 60"))))
        self.assertEqual(heavy, [row for row in rows if row["mass_g"] and float(row["mass_g"]) > 60])

    def test_filter_takes_a_condition_over_every_column(self):
        every = self.designs("filter", "--where", "1")
        some = self.designs("filter", "--where", "mass_g < 62 and wire_gauge_AWG = 28")
        self.assertGreater(len(some), 0)
        self.assertEqual(some, [row for row in every
                                if row["quantities"]["mass_g"] < 62 and row["variables"]["wire_gauge_AWG"] == 28])
        lines = self.archive("filter", "--where", "mass_g < 62 and wire_gauge_AWG = 28").splitlines()
        self.assertEqual(lines[0].split(), ["row", "number", "status", "turns_radial", "wire_gauge_AWG", "gap_mm",
                                            "peak_bending_speed_deg_s"])
        self.assertEqual([int(line.split()[0]) for line in lines[1:]], [row["row"] for row in some])
        self.assertEqual(self.archive("filter", "--where", "mass_g < 0"), "No design of the archive is so.\n")

    def test_top_is_the_best_of_a_quantity_among_those_that_keep_the_limits(self):
        best, second = self.designs("top", "--most", "peak_bending_speed_deg_s", "--count", "2")
        answer = self.result("out/result.json")["best"]
        self.assertEqual(best["variables"], answer["variables"])
        self.assertEqual(best["objectives"], answer["objectives"])
        self.assertLess(second["objectives"]["peak_bending_speed_deg_s"], best["objectives"]["peak_bending_speed_deg_s"])
        every = self.designs("filter", "--where", "cost_USD is not null")
        (cheapest,) = self.designs("top", "--least", "cost_USD", "--count", "1", "--where", "1")
        self.assertEqual(cheapest["quantities"]["cost_USD"], min(row["quantities"]["cost_USD"] for row in every))
        self.assertIn("cost_USD", self.archive("top", "--least", "cost_USD").splitlines()[0])

    def test_the_answer_picked_is_the_actuator_that_size_wrote(self):
        (best,) = self.designs("top", "--most", "peak_bending_speed_deg_s", "--count", "1")
        self.archive("pick", "--row", best["row"], "--out", "picked.json")
        self.assertEqual((self.folder / "picked.json").read_text(), (self.folder / "out/actuator.json").read_text())
        (other,) = self.designs("top", "--least", "mass_g", "--count", "1")
        self.archive("pick", "--row", other["row"], "--out", "light.json")
        before = (self.folder / "light.json").read_bytes()
        self.archive("pick", "--row", other["row"], "--out", "light.json")  # the same again loses nothing
        self.assert_refused(["archive", "pick", "out", "--row", str(best["row"]), "--out", "light.json"],
                            "light.json: cannot be written: it holds something else; --force replaces it, another --out keeps it")
        self.assertEqual((self.folder / "light.json").read_bytes(), before)
        self.archive("pick", "--row", best["row"], "--out", "light.json", "--force")
        self.assertEqual((self.folder / "light.json").read_bytes(), (self.folder / "picked.json").read_bytes())
        self.archive("pick", "--row", other["row"], "--out", "light.json", "--force")
        result = run("evaluate", "light.json", "--json", cwd=self.folder)
        self.assertEqual(json.loads(result.stdout)["mass_g"], other["quantities"]["mass_g"])

    def test_no_command_writes_over_the_archive_or_what_it_did_not_write(self):
        for name in ("out/archive.sqlite", "link"):
            (self.folder / "link").unlink(missing_ok=True)
            (self.folder / "link").symlink_to("out/archive.sqlite")
            for command in (["csv", "out"], ["pick", "out", "--row", "1"]):
                for option in ([], ["--force"]):
                    self.assert_refused(["archive", *command, "--out", name, *option],
                                        f"{name}: cannot be written: it is an input of this command")
        self.write("notes.csv", "mine\n1\n")
        self.assert_refused(["archive", "csv", "out", "--out", "notes.csv"],
                            "notes.csv: cannot be written: it holds something else; --force replaces it, another --out keeps it")
        self.archive("csv", "--out", "notes.csv", "--force")
        every = self.table("notes.csv")
        self.archive("csv", "--out", "notes.csv", "--where", "id < 3")  # a table of its own may go
        self.assertEqual(self.table("notes.csv"), every[:2])

    def test_replay_gives_the_same_numbers_or_says_which_and_whose(self):
        count = self.result("out/result.json")["evaluations"]["total"]
        for row in (1, count // 2, count):
            self.assertRegex(self.archive("replay", "--row", row),
                             rf"^Row {row} gives the same \d+ numbers again, to the last bit\.\n$")
        self.change("UPDATE designs SET mass_g = 12.5, failure = NULL WHERE id = 2")
        self.change("UPDATE study SET version = '0.0.9', commit_hash = 'abcdef0123'")
        text = self.archive("replay", "--row", "2", code=1)
        self.assertRegex(text, r"^Row 2 gives other numbers now\. Recorded by coilwright 0\.0\.9 \(commit abcdef0.*\), "
                               r"evaluated again by 0\.1\.0 \(.*\)\.\n")
        self.assertRegex(text, r"\n  mass_g +12\.5  \d+\.\d+\n$")
        told = json.loads(self.archive("replay", "--row", "2", "--json", code=1))
        self.assertEqual((told["same"], [each["name"] for each in told["differences"]]), (False, ["mass_g"]))

    def test_a_condition_without_an_end_is_refused_soon(self):
        endless = "WITH RECURSIVE c(x) AS (SELECT 1 UNION {} SELECT x + 1 FROM c)"
        for condition in (f"({endless.format('ALL')} SELECT count(*) FROM c) > 0", f"id IN ({endless.format('')} SELECT x FROM c)",
                          "EXISTS (SELECT 1 FROM designs a, designs b, designs c, designs d, designs e WHERE a.mass_g + b.mass_g "
                          "+ c.mass_g + d.mass_g + e.mass_g < 0)"):
            with self.subTest(condition):
                before = resource.getrusage(resource.RUSAGE_CHILDREN)
                self.assert_refused(["archive", "filter", "out", "--where", condition],
                                    "--where: takes too long, or has no end; a condition is written as mass_g < 60 and status = 'ok'")
                after = resource.getrusage(resource.RUSAGE_CHILDREN)
                self.assertLess(after.ru_utime - before.ru_utime, 4)  # s; of ten times as many steps the second took 15

    def test_mistakes_are_one_line(self):
        for arguments, message in (
                (["filter", "out", "--where", "mas_g < 60"], '--where: no such column: mas_g; did you mean "mass_g"?'),
                (["filter", "out", "--where", "mass_g <"], '--where: near ")": syntax error; a condition is written as '
                 "mass_g < 60 and status = 'ok'"),
                (["csv", "out", "--out", "all.csv", "--where", "abs(-9223372036854775807 - 1) > 0"],
                 "--where: integer overflow; a condition is written as mass_g < 60 and status = 'ok'"),
                (["top", "out", "--most", "mass_g", "--where", "mass_g IN (WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT "
                  "x + 1 FROM c) SELECT x FROM c WHERE x < 0)"],
                 "--where: takes too long, or has no end; a condition is written as mass_g < 60 and status = 'ok'"),
                (["top", "out", "--most", "nosuch"], "--most: no such column: nosuch; coilwright archive csv DIR has every column"),
                (["top", "out", "--most", "mas_g"], '--most: no such column: mas_g; did you mean "mass_g"?'),
                (["top", "out"], "top: needs --most or --least, one of the two"),
                (["replay", "out", "--row", "99999"],
                 f"out/archive.sqlite: has {self.result('out/result.json')['evaluations']['total']} designs, and none in "
                 "row 99999"),
                (["list", "none"], "none/archive.sqlite: cannot be read: there is no such file")):
            with self.subTest(arguments[0]):
                self.assert_refused(["archive", *arguments], message)
        self.change("UPDATE designs SET wire_gauge_AWG = 29 WHERE id = 1")
        self.assert_refused(["archive", "pick", "out", "--row", "1", "--out", "x.json"],
                            "out/archive.sqlite: row 1: must have values that the study's variables take")


if __name__ == "__main__":
    unittest.main()
