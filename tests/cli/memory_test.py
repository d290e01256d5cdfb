"""Memory fails at random in every command that writes: the answer, or one line and exit 1; nothing wrong is recorded, and the
command said again gives the same bytes."""

import os
import random
import resource
import signal
import subprocess
import unittest

from program import PROGRAM, THOROUGH
from writing_commands import COMMANDS, SLOW, WritingCommands, files_of

FAULTS = 4 * THOROUGH  # of each command
LIBRARY = os.environ["COILWRIGHT_FAILING_MEMORY"]
HANGS = 120  # s; each takes a few undisturbed
MB = 1_000_000


class Memory(WritingCommands):
    def start(self, arguments, env=None, preexec=None):
        return subprocess.run([PROGRAM, *arguments], cwd=self.place, capture_output=True, encoding="utf-8", timeout=HANGS,
                              check=False, env={**os.environ, **(env or {})}, preexec_fn=preexec)

    def allocations_of(self, arguments):
        self.lay_out()
        count = self.folder / "count"
        self.start(arguments, {"LD_PRELOAD": LIBRARY, "COILWRIGHT_COUNT": str(count)})
        return int(count.read_text())

    def assert_told_or_done(self, name, how, result):
        said, whole = self.undisturbed(name)
        self.assertIn(result.returncode, (0, 1), f"{name}, {how}: {result.stderr}")
        if result.returncode == 0:
            self.assertEqual(result.stdout, said, f"{name}, {how}")
            self.assertEqual(files_of(self.place), whole, f"{name}, {how}")
            return
        lines = result.stderr.splitlines()
        self.assertRegex(lines[-1] if lines else "", r"^coilwright: [^\n]+$", f"{name}, {how}: {result.stderr}")
        told = [line for line in lines if line.startswith("coilwright: ") or name != "diagnose"]
        self.assertEqual(len(told), 1, f"{name}, {how}: {result.stderr}")
        self.assert_nothing_is_wrong(name, how)
        self.assert_ends_well(name, how)

    def test_an_allocation_that_fails_ends_the_run_in_one_line(self):
        start = self.allocations_of(["--version"])
        draw = random.Random(7)
        ends = {0: 0, 1: 0}
        for name in COMMANDS:
            self.undisturbed(name)
            count = self.allocations_of(COMMANDS[name])
            for _ in range(max(1, FAULTS // (6 if name in SLOW else 1))):
                at, on = draw.randint(int(0.95 * min(start, count)), count), draw.random() < 0.5
                how = f"allocation {at} of {count}{' and all after it' if on else ''}"
                with self.subTest(f"{name}: {how}"):
                    self.lay_out()
                    result = self.start(COMMANDS[name], {"LD_PRELOAD": LIBRARY, "COILWRIGHT_FAIL_AT": str(at),
                                                         **({"COILWRIGHT_FAIL_ON": "1"} if on else {})})
                    self.assert_told_or_done(name, how, result)
                    ends[result.returncode] += 1
        print(f"{ends[1]} runs told of their end, {ends[0]} gave the answer")
        self.assertGreater(ends[1], ends[0])

    def test_a_program_that_memory_does_not_take_is_told_of_in_one_line(self):
        """Each program needs other amounts. Of a stack for which the system has no address left no program can tell: few."""
        ends = {0: 0, 1: 0, -signal.SIGSEGV: 0}
        for name, arguments in COMMANDS.items():
            for space in range(36 * MB, 50 * MB, 2 * MB if name in ("merge", "diagnose", "size", "report") else 7 * MB):
                if name in SLOW:
                    continue
                with self.subTest(f"{name}: {space // MB} MB"):
                    self.lay_out()
                    result = self.start(arguments,
                                        preexec=lambda bytes=space: resource.setrlimit(resource.RLIMIT_AS, (bytes, bytes)))
                    self.assertIn(result.returncode, ends, result.stderr)
                    if result.returncode == 1:
                        self.assertRegex(result.stderr, r"^coilwright: [^\n]+\n$")
                    ends[result.returncode] += 1
        print(f"{ends[1]} runs told of their end, {ends[0]} gave the answer")
        self.assertLessEqual(ends[-signal.SIGSEGV], ends[1] // 20)

    def test_a_run_with_little_memory_ends(self):
        for name in ("diagnose", "size", "pareto", "sweep", "yield --part"):
            for space in (60 * MB, 80 * MB, 100 * MB, 120 * MB, 150 * MB, 200 * MB, 300 * MB):
                how = f"{space // MB} MB"
                with self.subTest(f"{name}: {how}"):
                    self.lay_out()
                    result = self.start(COMMANDS[name],
                                        preexec=lambda bytes=space: resource.setrlimit(resource.RLIMIT_AS, (bytes, bytes)))
                    if result.returncode == 127:
                        continue  # too little to load the program
                    self.assert_told_or_done(name, how, result)
                if result.returncode == 0:
                    break  # more memory changes nothing


if __name__ == "__main__":
    unittest.main()
