"""Every command that writes, on small inputs: what a fault or a kill may leave of it, and that it then ends well."""

import contextlib
import hashlib
import json
import pathlib
import shutil
import sqlite3
import tempfile
import time

from archived_runs import ARCHIVE, designs_of
from diagnose_test import QUICK_PLAN, ROD
from program import DATA, ProgramTest, run
from study import FRONT, GRID, write_study

FINGER = ["finger.json"]
# Seconds each, and no other way to write than others have: a tenth of the faults and kills.
SLOW = {"reach", "distribute"}
SEARCH = {"max_evaluations": 10, "seed": 5}

# Of each the arguments; those of studies and of diagnose are said again with --resume, all others as they are.
STUDIES = {
    "size": ["size", "size.json", "--out", "out", "--quiet"],
    "pareto": ["pareto", "pareto.json", "--out", "out", "--quiet"],
    "sweep": ["sweep", "sweep.json", "--out", "out", "--quiet"],
}
COMMANDS = {
    **STUDIES,
    "twin": ["twin", "rod.json", "--experiment", "plan.json", "--out", "out"],
    "diagnose": ["diagnose", "set", "--out", "out"],
    "rig": ["rig", "torque-bench", *FINGER, "--out", "out"],
    "simulate": ["simulate", *FINGER, "--step-A", "1.2", "--out", "out.csv"],
    "linearise": ["linearise", *FINGER, "--current-A", "1", "--out", "out.json"],
    "reach": ["reach", *FINGER, "--angle-deg", "40", "--out", "out.csv", "--c-header", "out.h", "--pieces", "1"],
    "drive": ["drive", *FINGER, "--mean-A", "1", "--motion-s", "0.05", "--out", "out.csv"],
    "field": ["field", "pair.json", "--map", "xz", "--window", "-30", "30", "-10", "40", "--cells", "30", "--out", "out.csv",
              "--svg", "out.svg"],
    "export": ["export", *FINGER, "--as", "workshop", "--out", "out"],
    "init": ["init", "study", "--out", "out"],
    "schema": ["schema", "study", "--out", "out"],
    "man": ["man", "--out", "out"],
    "report": ["report", "done", "--out", "page.html"],
    "evaluate --report": ["evaluate", *FINGER, "--current-A", "1", "--report", "page.html"],
    "archive csv": ["archive", "csv", "done", "--out", "all.csv"],
    "archive pick": ["archive", "pick", "done", "--row", "3", "--out", "third.json"],
    "yield --part": ["yield", "spread.json", *FINGER, "--builds", "20", "--part", "1/2", "--out", "out", "--quiet"],
    "merge": ["merge", "out", "part1", "part2"],
    "distribute": ["distribute", "sweep.json", "--parts", "2", "--options", "--sample 8", "--out", "out", "--force"],
    "archive check --repair": ["archive", "check", "damaged", "--repair"],
}


def files_of(folder):
    """All but archives, which say when and how fast, and their logs, and passwords, which are drawn; of programs a digest,
    or unittest would tell the bytes."""
    found = {str(path.relative_to(folder)): path.read_bytes() for path in pathlib.Path(folder).rglob("*")
             if path.is_file() and not path.name.startswith(ARCHIVE) and path.name != "password"}
    return {name: hashlib.sha256(content).digest() if content.startswith(b"\x7fELF") else content for name, content in found.items()}


class WritingCommands(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """The inputs of all commands, and what each gives undisturbed."""
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.inputs = pathlib.Path(temporary.name)
        cls.known, cls.durations = {}, {}
        maker = cls()
        maker.folder = cls.inputs
        for name, changes in (("size", {}), ("pareto", {"objectives": FRONT}), ("sweep", {"variables": GRID}),
                              ("spread", {"spread": {"parts": "usual"}})):
            write_study(maker, **{"search": SEARCH, **changes})
            (cls.inputs / "study.json").rename(cls.inputs / f"{name}.json")
        for name, content in (("rod.json", ROD), ("plan.json", QUICK_PLAN)):
            maker.write(name, json.dumps(content))
        shutil.copy(DATA / "formats" / "two_magnets.json", cls.inputs / "pair.json")
        for arguments in (["size", "size.json", "--out", "done", "--quiet"],
                          ["twin", "rod.json", "--experiment", "plan.json", "--out", "set", "--effect", "base_tilt:angle_deg=3"],
                          *(["sweep", "sweep.json", "--part", f"{k}/2", "--out", f"part{k}", "--quiet"] for k in (1, 2))):
            assert run(*arguments, cwd=cls.inputs).returncode == 0, arguments
        # A tilted rod of which all else is known: half a second to diagnose, and an experiment is proposed too.
        known = {**maker.result("set/dataset.json"), "calibrate": [], "tolerances": "exact"}
        maker.write("set/dataset.json", json.dumps(known))
        shutil.copytree(cls.inputs / "done", cls.inputs / "damaged")
        with contextlib.closing(sqlite3.connect(cls.inputs / "damaged" / ARCHIVE)) as database, database:
            database.execute("UPDATE designs SET mass_g = 1 WHERE id > 4")
            database.execute("UPDATE other_choices SET mass_g = 1 WHERE id < 9")

    def runTest(self):
        """unittest wants one of a maker."""

    def setUp(self):
        super().setUp()
        self.place = self.folder / "place"

    def lay_out(self):
        shutil.rmtree(self.place, ignore_errors=True)
        shutil.copytree(self.inputs, self.place)

    def undisturbed(self, name):
        """What it prints and what lies there afterwards."""
        if name not in self.known:
            self.lay_out()
            begin = time.monotonic()
            result = run(*COMMANDS[name], cwd=self.place)
            self.durations[name] = time.monotonic() - begin
            self.assertEqual(result.returncode, 0, result.stderr)
            self.known[name] = (result.stdout, files_of(self.place))
        return self.known[name]

    def assert_nothing_is_wrong(self, name, how):
        """Of whatever lies there now each file is whole: as it was, or as the command makes it."""
        _, whole = self.undisturbed(name)
        before = files_of(self.inputs)
        now = files_of(self.place)
        for file, content in now.items():
            if ".part-" not in file:
                self.assertIn(content, (whole.get(file), before.get(file)), f"{name}, {how}: {file}")
        for file in before:
            self.assertIn(file, now, f"{name}, {how}: {file} is gone")

    def assert_ends_well(self, name, how):
        """Said again it gives the same bytes, and clears away what was left."""
        said, whole = self.undisturbed(name)
        if name == "init" and files_of(self.place) == whole:
            return  # which replaces no file, not even its own
        arguments = COMMANDS[name] + (["--resume"] if name in {*STUDIES, "diagnose"} else [])
        result = run(*arguments, cwd=self.place)
        self.assertEqual(result.returncode, 0, f"{name}, {how}: {result.stderr}")
        if "--repair" not in arguments:  # which says what it did
            self.assertEqual(result.stdout, said, f"{name}, {how}")
        self.assertEqual(files_of(self.place), whole, f"{name}, {how}")
        if "--repair" in arguments:
            self.assertEqual(designs_of(self.place / "damaged"), designs_of(self.inputs / "done"), how)

