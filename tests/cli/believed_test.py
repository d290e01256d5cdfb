"""What an answer rests on is not believed because an archive says it: each design that a command states is evaluated again, and
a number that comes out otherwise is told with file, row, both numbers and the cure. Every row of an archive is changed in turn,
with the checksums of a program that knows them."""

import contextlib
import re
import shutil
import sqlite3
import unittest

from archived_runs import ARCHIVE, forge
from program import ProgramTest, run
from study import FRONT, GRID, write_study

SAMPLED = 3  # designs that are evaluated again before an archive is taken at all, and refused in other words
KINDS = {
    "size": {"search": {"max_evaluations": 12, "seed": 5}},
    "pareto": {"objectives": FRONT, "search": {"max_evaluations": 30, "seed": 5}},
    "sweep": {"variables": GRID, "objectives": FRONT},
    "pareto, nothing feasible": {"objectives": FRONT, "constraints": [{"quantity": "mass_g", "at_most": 20}],
                                 "search": {"max_evaluations": 20, "seed": 5}},
    "sweep, nothing feasible": {"variables": GRID, "constraints": [{"quantity": "mass_g", "at_most": 20}]},
}


class Believed(ProgramTest):
    def made(self, kind):
        """A finished run, and how it is said again."""
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        write_study(self, **KINDS[kind])
        self.command = [kind.split(",")[0], "study.json", "--out", "out", "--quiet"]
        result = run(*self.command, cwd=self.folder)
        self.assertIn(result.returncode, (0, 3), result.stderr)
        self.said = result.stdout
        shutil.move(self.folder / "out", self.folder / "whole")

    def again(self, *options, sql=None):
        """Said again where the archive was changed."""
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        shutil.copytree(self.folder / "whole", self.folder / "out")
        if sql:
            forge(self.folder / "out", sql)
        return run(*self.command, *options, cwd=self.folder)

    def rows(self, table):
        with contextlib.closing(sqlite3.connect(self.folder / "whole" / ARCHIVE)) as database:
            return [row for (row,) in database.execute(f"SELECT id FROM {table} WHERE mass_g IS NOT NULL ORDER BY id")]

    def assert_told_or_of_no_consequence(self, table, column, change):
        """How many rows are told of. A quantity beside objectives and limits leaves the way of the search as it is."""
        told = 0
        rows = self.rows(table)
        for row in rows if table == "designs" else rows[::6]:
            with self.subTest(table=table, row=row):
                result = self.again(sql=f"UPDATE {table} SET {column} = {change} WHERE id = {row}")
                if result.returncode == 2:
                    told += 1
                    self.assertRegex(result.stderr, r"^coilwright: out/archive\.sqlite: [^\n]+\n$")
                    if "gives other numbers on this machine" not in result.stderr:
                        self.assertRegex(result.stderr, rf"row {row} of {table}: .*{column} is [-\d.e]+ when it is evaluated again"
                                                        r".*--force starts anew; got [-\d.e]+\n")
                    self.assertEqual(result.stdout, "")
                    self.assertEqual((self.folder / "out/result.json").read_bytes(), (self.folder / "whole/result.json").read_bytes())
                else:
                    self.assertIn((result.returncode, result.stderr), ((0, ""), (3, "")))
                    self.assertEqual(result.stdout, self.said)
        return told

    def test_each_design_that_an_answer_states_is_evaluated_again(self):
        for kind in KINDS:
            with self.subTest(kind):
                self.made(kind)
                told = self.assert_told_or_of_no_consequence("designs", "mass_g", "mass_g * (1 + 1e-9)")
                print(f"{kind}: {told} of {len(self.rows('designs'))} designs, changed one at a time, were told of")
                stated = {"size": 1 + 4, "pareto": len(self.table("whole/front.csv")) if kind == "pareto" else 1,
                          "sweep": 2 if kind == "sweep" else 1}[kind.split(",")[0]]
                self.assertGreater(told, min(stated, SAMPLED))
                shutil.rmtree(self.folder / "whole")

    def test_so_is_each_design_under_another_modelling_choice(self):
        self.made("size")
        told = self.assert_told_or_of_no_consequence("other_choices", "mass_g", "mass_g * (1 + 1e-9)")
        with contextlib.closing(sqlite3.connect(self.folder / "whole" / ARCHIVE)) as database:
            best = database.execute("SELECT min(id), choice FROM other_choices GROUP BY choice").fetchall()
        for row, choice in best:  # the answer itself comes first
            with self.subTest(choice):
                result = self.again(sql=f"UPDATE other_choices SET objective_1 = objective_1 * 2 WHERE id = {row}")
                self.assertEqual(result.returncode, 2, choice)
                self.assertIn(f"row {row} of other_choices", result.stderr)
        print(f"{told} of a sixth of the designs under other choices, and {len(best)} answers under them, were told of")

    def test_an_archive_of_another_version_is_believed_no_more(self):
        self.made("size")
        row = self.stated_row()
        change = f"UPDATE designs SET mass_g = mass_g + 1 WHERE id = {row}"
        shutil.rmtree(self.folder / "out")
        shutil.copytree(self.folder / "whole", self.folder / "out")
        forge(self.folder / "out", "UPDATE study SET version = '0.0.9', commit_hash = 'abc'")
        result = run(*self.command, "--resume", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (0, self.said), result.stderr)
        forge(self.folder / "out", change)
        result = run(*self.command, "--resume", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
        self.assertRegex(result.stderr.splitlines()[-1], rf"row {row} of designs: .*mass_g is")

    def test_so_are_designs_of_another_study(self):
        self.made("size")
        row = self.stated_row()
        for change, code in (("mass_g = mass_g", 0), ("mass_g = mass_g + 1", 2)):
            shutil.rmtree(self.folder / "other", ignore_errors=True)
            shutil.copytree(self.folder / "whole", self.folder / "other")
            forge(self.folder / "other", f"UPDATE designs SET {change} WHERE id = {row}")
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            result = run(*self.command, "--reuse", "other", cwd=self.folder)
            self.assertEqual(result.returncode, code, result.stderr)
        self.assertRegex(result.stderr, rf"^coilwright: other/archive\.sqlite: row {row} of designs: .*leave out --reuse[^\n]*\n$")

    def stated_row(self):
        """A row that an answer states, and that is none of those evaluated again before an archive is taken."""
        for row in self.rows("designs"):
            result = self.again(sql=f"UPDATE designs SET mass_g = mass_g + 1 WHERE id = {row}")
            if re.search(rf"row {row} of designs", result.stderr):
                return row
        self.fail("no row is stated")


if __name__ == "__main__":
    unittest.main()
