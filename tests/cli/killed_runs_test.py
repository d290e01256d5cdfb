"""kill -9 at random moments, of runs of studies every other one while designs are recorded, and --resume till the end:
nothing recorded is lost, and no byte of any result differs. The same of diagnoses, whose fits are recorded, and of every
other command that writes, said again."""

import contextlib
import json
import os
import pathlib
import random
import shutil
import sqlite3
import statistics
import struct
import subprocess
import tempfile
import time
import unittest

from archived_runs import ARCHIVE, checksum, designs_of, results_of, start, stop_with_designs
from diagnose_test import QUICK_PLAN, ROD
from program import HANGS, PROGRAM, THOROUGH, ProgramTest, run
from study import FRONT, GRID, write_study
from writing_commands import COMMANDS, SLOW, STUDIES as SMALL, WritingCommands

KILLS = 6 * THOROUGH  # of studies and of other commands, a fourth as many of diagnoses
KILLS_OF_A_RUN = 4  # one run may be killed several times before it ends
ENDED = 7  # of a design as designs_of() gives it: when its evaluation ended, unix s

# Most of the kills go to pareto.
STUDIES = {
    "pareto": {"objectives": FRONT, "search": {"max_evaluations": 700, "seed": 5}},
    "pareto of an NLopt algorithm": {"objectives": FRONT, "search": {"max_evaluations": 600, "algorithm": "cobyla"}},
    "size": {"search": {"max_evaluations": 400, "seed": 4}},
    "pareto with another seed": {"objectives": FRONT, "search": {"max_evaluations": 700, "seed": 9}},
    "sweep": {"variables": {**GRID, "gap_mm": {"lower": 0.7, "upper": 1.6, "step": 0.01}}},
}


class KilledRuns(ProgramTest):
    def setUp(self):
        super().setUp()
        self.random = random.Random(11)
        self.kills = 0
        self.kills_with_designs = 0
        self.lost = []  # s of evaluations, at most, by each kill at any moment between two of them
        self.known = {}

    def undisturbed(self, name):
        """How long the study takes, what it prints and leaves, and how many designs it records."""
        if name not in self.known:
            self.known[name] = self.run_whole(name.split()[0])
        return self.known[name]

    def run_whole(self, command):
        begin = time.monotonic()
        result = run(command, "study.json", "--out", "whole", "--force", "--quiet", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        whole = self.folder / "whole"
        return time.monotonic() - begin, result.stdout, results_of(whole), len(designs_of(whole))

    def wait(self, process, folder, duration, recorded, designs):
        """Every other kill comes when more designs are recorded, however slow the machine is; the others at any moment;
        whether it is one of those."""
        if self.kills % 2 == 0 and recorded < designs // 2:
            stop_with_designs(self, process, folder, recorded + self.random.randint(1, designs // 4))
            return False
        time.sleep(self.random.uniform(0, duration))
        return True

    def kill_and_resume(self, name):
        command = name.split()[0]
        duration, answer, whole, designs = self.undisturbed(name)
        folder = self.folder / "killed"
        recorded = []
        for _ in range(KILLS_OF_A_RUN):
            if self.kills == KILLS:
                break
            process = start(command, "study.json", "--out", "killed", "--resume", "--quiet", cwd=self.folder)
            is_at_any_moment = self.wait(process, folder, duration, len(recorded), designs)
            killed = time.time()
            process.kill()
            output, errors = process.communicate(timeout=HANGS)
            if process.returncode == 0:
                break  # it was faster than its kill
            # A kill may come when the answer is being printed, or was.
            self.assertEqual((process.returncode, errors), (-9, ""))
            self.assertTrue(answer.startswith(output), output)
            self.kills += 1
            now = designs_of(folder)
            self.assertEqual(now[:len(recorded)], recorded)
            if is_at_any_moment and len(recorded) < len(now) < designs:
                self.lost.append(killed - max(design[ENDED] for design in now))
            recorded = now
            self.kills_with_designs += len(recorded) > 0
        result = run(command, "study.json", "--out", "killed", "--resume", "--quiet", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual(result.stdout, answer)
        resumed = results_of(folder)
        self.assertEqual(sorted(resumed), sorted(whole))
        for name, content in whole.items():
            self.assertTrue(resumed[name] == content, name)
        now = designs_of(folder)
        self.assertEqual(now[:len(recorded)], recorded)
        # As many as without a kill: each design was recorded once, and none again.
        self.assertEqual(len(now), designs)

    def empty(self, folder):
        """What one study leaves must not be taken for the next one's, also where it failed."""
        for path in folder.iterdir() if folder.exists() else ():
            path.unlink()

    def test_nothing_recorded_is_lost_and_no_byte_differs(self):
        while self.kills < KILLS:
            for name, changes in STUDIES.items():
                if self.kills == KILLS:
                    break
                with self.subTest(name):
                    write_study(self, **changes)
                    try:
                        self.kill_and_resume(name)
                    finally:
                        self.empty(self.folder / "killed")
        print(f"{self.kills} kills, {self.kills_with_designs} of them with designs recorded")
        if self.lost:
            middle = statistics.median(self.lost)
            print(f"{len(self.lost)} of them between two evaluations: the last recorded had ended at most {max(self.lost):.2f} s "
                  f"before, in the median {middle:.2f} s")
            self.assertLess(middle, 0.2)  # s
        self.assertGreater(self.kills_with_designs, KILLS // 3)


class KilledDiagnoses(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """A set, and its diagnosis undisturbed."""
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.inputs = pathlib.Path(temporary.name)
        (cls.inputs / "rod.json").write_text(json.dumps(ROD))
        (cls.inputs / "plan.json").write_text(json.dumps(QUICK_PLAN))
        made = run("twin", "rod.json", "--experiment", "plan.json", "--out", "set", "--effect", "dry_friction:torque_Nmm=40",
                   cwd=cls.inputs)
        assert made.returncode == 0, made.stderr
        begin = time.monotonic()
        cls.answer = run("diagnose", "set", "--out", "whole", "--quiet", cwd=cls.inputs)
        cls.duration = time.monotonic() - begin

    def setUp(self):
        super().setUp()
        shutil.copytree(self.inputs, self.folder, dirs_exist_ok=True)
        self.assertEqual(self.answer.returncode, 0, self.answer.stderr)

    def fits(self):
        with contextlib.closing(sqlite3.connect(self.folder / "killed" / ARCHIVE)) as database:
            return database.execute("SELECT asked, found FROM fits ORDER BY asked").fetchall()

    def kill(self, after):
        process = start("diagnose", "set", "--out", "killed", "--resume", "--quiet", cwd=self.folder)
        time.sleep(after)
        process.kill()
        process.communicate(timeout=HANGS)
        return process.returncode == -9 and (self.folder / "killed" / ARCHIVE).exists()

    def kill_late(self):
        """With fits recorded; one that has ended before leaves nothing behind."""
        while not (self.kill(0.7 * self.duration) and len(self.fits()) > 20):
            shutil.rmtree(self.folder / "killed", ignore_errors=True)

    def assert_resumed(self, *arguments):
        """It ends like a run that was never interrupted, and its record goes."""
        result = run("diagnose", "set", "--out", "killed", "--quiet", "--resume", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr, result.stdout), (0, "", self.answer.stdout))
        self.assertEqual(results_of(self.folder / "killed"), results_of(self.folder / "whole"))
        self.assertFalse((self.folder / "killed" / ARCHIVE).exists())

    def test_no_finished_fit_is_lost_and_no_byte_differs(self):
        draw = random.Random(17)
        kills, kept = 0, 0
        while kills < max(3, KILLS // 4):
            fits = []
            while self.kill(draw.uniform(0, self.duration)) and kills < max(3, KILLS // 4):
                kills += 1
                now = self.fits()
                self.assertLessEqual(set(fits), set(now))
                fits, kept = now, max(kept, len(now))
            self.assert_resumed("--threads", draw.choice("12"))
        print(f"{kills} kills of diagnoses, up to {kept} fits recorded")
        self.assertGreater(kept, 20)

    def test_a_changed_byte_is_not_answered_from(self):
        self.kill_late()
        draw = random.Random(19)
        with contextlib.closing(sqlite3.connect(self.folder / "killed" / ARCHIVE)) as database, database:
            for asked, found in self.fits():
                changed = bytearray(found)
                if changed:
                    changed[draw.randrange(len(changed))] ^= 1 << draw.randrange(8)
                    database.execute("UPDATE fits SET found = ? WHERE asked = ?", (bytes(changed), asked))
        self.assert_resumed()

    def test_a_number_that_does_not_come_out_again_is_not_answered_from(self):
        """Whoever changed it made the checksum anew."""
        self.kill_late()
        with contextlib.closing(sqlite3.connect(self.folder / "killed" / ARCHIVE)) as database, database:
            for asked, found in self.fits():
                numbers = [number * (1 + 1e-6) for number in struct.unpack(f"{len(found) // 8}d", found)]
                changed = struct.pack(f"{len(numbers)}d", *numbers)
                database.execute("UPDATE fits SET found = ?, checksum = ? WHERE asked = ?", (changed, checksum(asked, changed), asked))
        result = run("diagnose", "set", "--out", "killed", "--quiet", "--resume", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (0, self.answer.stdout), result.stderr)
        self.assertEqual(set(result.stderr.splitlines()), {
            "coilwright: killed/archive.sqlite: a recorded fit has other numbers when it is evaluated again: it is made anew"})
        print(f"{len(result.stderr.splitlines())} changed fits were made anew")
        self.assertEqual(results_of(self.folder / "killed"), results_of(self.folder / "whole"))

    def test_other_data_or_another_seed_are_refused_in_a_line(self):
        while not self.kill(0.7 * self.duration):
            pass
        refused = run("diagnose", "set", "--out", "killed", "--resume", "--seed", "2", cwd=self.folder)
        self.assertEqual((refused.returncode, refused.stderr), (2,
            "coilwright: killed: holds the archive of another run (seed 1, not seed 2): --force replaces it, another --out keeps "
            "it\n"))
        with open(self.folder / "set" / "dataset.json", "a", encoding="utf-8") as data:
            data.write(" ")
        refused = run("diagnose", "set", "--out", "killed", "--resume", cwd=self.folder)
        self.assertEqual(refused.returncode, 2)
        self.assertRegex(refused.stderr, "^coilwright: killed: holds the archive of another run "
                                         r"\(set/dataset.json with another content \(SHA-256 .*\)\): --force replaces")


class KilledCommands(WritingCommands):
    def kill(self, name, draw):
        """Kills it at a random moment before it ends; whether it was not faster."""
        self.undisturbed(name)
        self.lay_out()
        with subprocess.Popen([PROGRAM, *COMMANDS[name]], cwd=self.place, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            time.sleep(draw.uniform(0, self.durations[name]))
            process.kill()
        return process.returncode == -9

    def test_nothing_is_half_written_and_the_command_said_again_ends_well(self):
        draw = random.Random(13)
        names = [name for name in COMMANDS if name not in SMALL]
        kills = dict.fromkeys(names, 0)
        for turn in range(3 * KILLS):
            name = names[turn % len(names)]
            if sum(kills.values()) == KILLS or (name in SLOW and turn // len(names) % 10 > 0):
                continue
            with self.subTest(f"{name}, turn {turn}"):
                kills[name] += self.kill(name, draw)
                self.assert_nothing_is_wrong(name, turn)
                self.assert_ends_well(name, turn)
        print(f"{sum(kills.values())} kills of {len(names)} commands:", ", ".join(f"{name} {kills[name]}" for name in names))
        self.assertGreater(sum(kills.values()), KILLS // 3)


if __name__ == "__main__":
    unittest.main()
