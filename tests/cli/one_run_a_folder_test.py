"""A folder holds one run: each command that writes a folder, with --force after each other one, leaves there what it
leaves alone, or the folder as it was; and `report` shows the last."""

import json
import os
import shutil
import unittest

from program import drawn, run
from writing_commands import COMMANDS, SLOW, WritingCommands, files_of

# All that write a folder of results, of a data set or of a workflow; the others have files that no run has.
FOLDERS = ["size", "pareto", "sweep", "twin", "diagnose", "rig", "yield --part", "merge", "distribute"]
MORE = {
    "sweep --part": ["sweep", "sweep.json", "--part", "1/2", "--out", "out", "--quiet"],
    "size --part": ["size", "size.json", "--part", "1/2", "--out", "out", "--quiet"],
    "pareto --part": ["pareto", "pareto.json", "--part", "1/2", "--out", "out", "--quiet"],
    "diagnose --part": ["diagnose", "set", "--part", "1/2", "--out", "out", "--quiet"],
    "another twin": ["twin", "rod.json", "--experiment", "other.json", "--out", "out"],
}


class OneRunAFolder(WritingCommands):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        plan = json.loads((cls.inputs / "plan.json").read_text())
        plan["runs"] = [{**plan["runs"][0], "file": "third.csv"}]
        (cls.inputs / "other.json").write_text(json.dumps(plan))
        cls.commands = {**{name: COMMANDS[name] for name in FOLDERS}, **MORE}
        cls.alone = {}
        cls.pages = {}
        for name, arguments in cls.commands.items():
            place = cls.inputs.parent / f"{cls.inputs.name} {name}"
            cls.addClassCleanup(shutil.rmtree, place)
            shutil.copytree(cls.inputs, place)
            result = run(*arguments, cwd=place)
            assert result.returncode == 0, (name, result.stderr)
            cls.alone[name] = place / "out"
            page = run("report", "out", cwd=place)
            cls.pages[name] = (page.returncode, (place / "out" / "report.html").read_bytes() if page.returncode == 0 else page.stderr)

    def after(self, first, page=False):
        """A folder in which a command has run, perhaps with its page."""
        self.lay_out()
        # A workflow has the whole program.
        shutil.copytree(self.alone[first], self.place / "out", ignore=None if page else shutil.ignore_patterns("report.html"),
                        copy_function=os.link if first == "distribute" else shutil.copy2)

    def files_alone(self, name):
        return {file: content for file, content in files_of(self.alone[name]).items() if file != "report.html"}

    def state(self):
        return {str(path.relative_to(self.place)): None if not path.is_file() else
                path.read_bytes() if path.stat().st_size < 1e6 else path.stat().st_mtime_ns for path in self.place.rglob("*")}

    def test_what_another_run_wrote_goes_first_or_the_folder_is_refused(self):
        replaced = refused = 0
        pairs = [(first, second) for first in self.commands for second in self.commands if second not in SLOW and first != second]
        for first, second in drawn(pairs):
            with self.subTest(first=first, second=second):
                self.after(first, page=True)
                before = self.state()
                forced = [*self.commands[second], "--force"]
                result = run(*forced, cwd=self.place)
                if result.returncode == 2:
                    refused += 1
                    self.assertRegex(result.stderr, r"^coilwright: out[^\n]*\n$")
                    self.assertEqual(self.state(), before)
                    continue
                replaced += 1
                self.assertEqual(result.returncode, 0, result.stderr)
                there, alone = files_of(self.place / "out"), self.files_alone(second)
                self.assertEqual(sorted(there), sorted(alone))
                self.assertEqual([name for name in alone if there[name] != alone[name]], [])
                self.assertEqual((self.place / "out" / "archive.sqlite").exists(), (self.alone[second] / "archive.sqlite").exists())
                page = run("report", "out", cwd=self.place)
                told = (self.place / "out" / "report.html").read_bytes() if page.returncode == 0 else page.stderr
                self.assertTrue((page.returncode, told) == self.pages[second], "the page is another one")
        print(f"{replaced} folders of another run were replaced, {refused} refused")
        self.assertGreater(replaced, 2 * refused)

    def test_without_force_a_folder_of_another_run_stays_as_it_is(self):
        # What is begun again goes on; a part of the same run with its own rows, too.
        pairs = [(first, second) for first in self.commands for second in self.commands
                 if second not in SLOW and first.split()[0] != second.split()[0]]
        for first, second in drawn(pairs):
            with self.subTest(first=first, second=second):
                self.after(first, page=True)
                before = self.state()
                result = run(*self.commands[second], cwd=self.place)
                self.assertEqual((result.returncode, result.stdout), (2, ""))
                self.assertRegex(result.stderr, r"^coilwright: out[^\n]*\n$")
                self.assertEqual(self.state(), before)

    def test_a_persons_files_stay(self):
        for second in ("size", "diagnose", "merge", "twin"):
            self.after("pareto")
            (self.place / "out" / "notes.txt").write_text("mine")
            (self.place / "out" / "pictures").mkdir()
            self.assertEqual(run(*self.commands[second], "--force", cwd=self.place).returncode, 0)
            self.assertEqual((self.place / "out" / "notes.txt").read_text(), "mine")
            self.assertTrue((self.place / "out" / "pictures").is_dir())

    def test_the_same_again_keeps_its_page_and_other_results_take_it_away(self):
        for name in ("size", "pareto", "sweep", "merge"):
            self.after(name, page=True)
            before = files_of(self.place / "out")
            self.assertEqual(run(*self.commands[name], cwd=self.place).returncode, 0)
            self.assertEqual(files_of(self.place / "out"), before)
        self.after("size", page=True)
        more = run(*self.commands["size"], "--max-evaluations", "14", "--resume", cwd=self.place)
        self.assertEqual(more.returncode, 0, more.stderr)
        self.assertFalse((self.place / "out" / "report.html").exists())

    def test_an_input_in_the_folder_is_kept(self):
        for name, arguments in (("size", ["size", "out/study.json", "--out", "out", "--quiet"]),
                                ("yield --part", ["yield", "spread.json", "out/actuator.json", "--builds", "20", "--part", "1/2", "--out", "out"]),
                                ("twin", ["twin", "out/actuator.json", "--experiment", "plan.json", "--out", "out"]),
                                ("rig", ["rig", "torque-bench", "out/actuator.json", "--out", "out"])):
            with self.subTest(name):
                self.after("size")
                study = json.loads((self.place / "size.json").read_text())
                (self.place / "out" / "study.json").write_text(json.dumps({**study, "actuator": "actuator.json"}))
                before = self.state()
                result = run(*arguments, "--force", cwd=self.place)
                self.assertEqual((result.returncode, result.stdout, result.stderr),
                                 (2, "", "coilwright: out/actuator.json: cannot be written: it is an input of this command\n"))
                self.assertEqual(self.state(), before)

    def test_a_diagnosis_that_fails_leaves_the_other_run_whole(self):
        self.after("size")
        (self.place / "set" / "slow.csv").write_text("time_s,current_A\n0,1\n")
        before = self.state()
        result = run("diagnose", "set", "--out", "out", "--force", cwd=self.place)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(self.state(), before)

    def test_a_diagnosis_cut_short_replaces_the_other_run_whole_or_not_at_all(self):
        self.after("size")
        result = run("diagnose", "set", "--out", "out", "--force", "--minutes", "0.0001", cwd=self.place)
        self.assertEqual(result.returncode, 130, result.stderr)
        there = set(files_of(self.place / "out"))
        if "diagnosis.json" in there:
            self.assertEqual(there & {"result.json", "evaluations.csv", "convergence.csv"}, set())
            self.assertFalse((self.place / "out" / "archive.sqlite").exists())
        else:
            self.assertEqual(there, set(self.files_alone("size")))

    def test_a_page_is_refused_of_a_folder_that_holds_two_runs(self):
        self.after("size")
        shutil.copy(self.alone["diagnose"] / "diagnosis.json", self.place / "out")
        result = run("report", "out", cwd=self.place)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"^coilwright: out: [^\n]+\n$")


if __name__ == "__main__":
    unittest.main()
