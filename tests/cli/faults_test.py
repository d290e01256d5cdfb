"""Every system call that changes the disk fails, or the program is killed at it, in every command that writes: an answer
or one line, nothing half-written, and the command said again gives the same bytes. strace makes the faults."""

import collections
import fcntl
import os
import random
import re
import subprocess
import unittest

from program import HANGS, PROGRAM, THOROUGH, run
from writing_commands import COMMANDS, SLOW, WritingCommands, files_of

FAULTS = 4 * THOROUGH  # of each command
KILL = "KILL"
DISK = ("EIO", "ENOSPC", KILL)
CALLS = {"openat": ("EMFILE", "EIO", "ENOSPC"), "write": DISK, "pwrite64": DISK, "fsync": DISK, "fdatasync": DISK, "rename": DISK,
         "unlink": DISK, "mkdir": DISK, "ftruncate": DISK, "flock": ("ENOLCK", KILL), "fcntl": ("ENOLCK", "EIO", KILL)}
LINE = re.compile(r"^(\d+) +(\w+)\((.*)")


def strace(log, *options, arguments, cwd):
    # Under its filter strace sends no signal.
    quick = [] if any("signal=" in each for each in options) else ["--seccomp-bpf"]
    return subprocess.run(["strace", "-f", *quick, "-qq", "-y", "-o", log, *options, PROGRAM, *arguments], cwd=cwd,
                          capture_output=True, encoding="utf-8", timeout=HANGS, check=False)


class Faults(WritingCommands):
    def setUp(self):
        super().setUp()
        try:
            done = strace(os.devnull, "-e", "trace=openat", arguments=["--version"], cwd=self.folder)
        except FileNotFoundError:
            self.skipTest("there is no strace")
        if done.returncode != 0:
            self.skipTest("no process may be traced here")
        self.random = random.Random(5)
        self.counts = collections.Counter()

    def calls_of(self, name):
        """The calls on files of the test, each as its name and how many of that name its thread made before, and it."""
        self.lay_out()
        log = self.folder / "calls"
        strace(log, "-e", "trace=" + ",".join(CALLS), arguments=COMMANDS[name], cwd=self.place)
        made, found = collections.Counter(), set()
        for line in log.read_text(errors="replace").splitlines():
            if match := LINE.match(line):
                thread, call, rest = match.groups()
                made[thread, call] += 1
                path = re.match(r'[^"]*"([^"]*)"', rest)
                own = call not in ("openat",) or (path and not path[1].startswith("/")) or str(self.folder) in rest.split(" = ")[-1]
                if own and (str(self.folder) in rest or (call == "write" and rest.startswith("1<"))):
                    found.add((call, made[thread, call]))
        return sorted(found)

    def faults_of(self, name):
        every = [(call, place, fault, then) for call, place in self.calls_of(name) for fault in CALLS[call]
                 for then in ("", "+") if fault != KILL or not then]
        return self.random.sample(every, min(len(every), -(-FAULTS // 10) if name in SLOW else FAULTS))

    def break_once(self, name, call, place, fault, then):
        how = f"{call} {place}{then} {fault}"
        said, whole = self.undisturbed(name)
        self.lay_out()
        injected = f"signal=SIGKILL:when={place}" if fault == KILL else f"error={fault}:when={place}{then}"
        log = self.folder / "calls"
        result = strace(log, "-e", f"trace={call}", "-e", f"inject={call}:{injected}", arguments=COMMANDS[name], cwd=self.place)
        if result.returncode >= 0 and "(INJECTED)" not in log.read_text(errors="replace"):
            return  # its threads went another way
        self.counts[fault] += 1
        self.counts["answered" if result.returncode == 0 else "told"] += 1
        allowed = (0, -9, 137) if fault == KILL else (0, 1, 2)
        self.assertIn(result.returncode, allowed, f"{name}, {how}: {result.stderr}")
        if fault != KILL:
            self.assert_told(name, how, result, is_mute=call == "write" and then == "+")
        if result.returncode == 0:
            self.assertEqual(result.stdout, said, f"{name}, {how}")
            self.assertEqual(without_parts(files_of(self.place)), whole, f"{name}, {how}")
            return
        self.assert_nothing_is_wrong(name, how)
        self.assert_ends_well(name, how)

    def assert_told(self, name, how, result, is_mute):
        lines = [line for line in result.stderr.splitlines() if name != "diagnose" or line.startswith("coilwright: ")]
        for line in lines:
            self.assertRegex(line, r"^coilwright: [^\n]+$", f"{name}, {how}")
        if result.returncode != 0 and not is_mute:
            self.assertGreater(len(lines), 0, f"{name}, {how}")
        self.assertLess(len(lines), 5, f"{name}, {how}: {result.stderr}")

    def test_an_answer_or_one_line(self):
        for name in COMMANDS:
            for fault in self.faults_of(name):
                with self.subTest(f"{name}: {fault}"):
                    self.break_once(name, *fault)
        made = sum(self.counts[fault] for fault in {fault for faults in CALLS.values() for fault in faults})
        told = ", ".join(f"{count} {what}" for what, count in sorted(self.counts.items()))
        print(f"{made} faults of {len(COMMANDS)} commands: {told}")
        self.assertGreater(made, len(COMMANDS) * min(FAULTS, 12) // 2)
        self.assertGreater(self.counts[KILL], 0)


class TwoAtOnce(WritingCommands):
    def test_no_two_write_to_one_folder(self):
        for name in ("size", "pareto", "sweep", "twin", "diagnose", "rig", "export", "man"):
            with self.subTest(name):
                self.lay_out()
                (self.place / "out").mkdir()
                lock = os.open(self.place / "out", os.O_RDONLY)
                fcntl.flock(lock, fcntl.LOCK_EX)
                result = run(*COMMANDS[name], cwd=self.place)
                os.close(lock)
                self.assertEqual((result.returncode, result.stdout), (2, ""))  # before any work
                self.assertEqual(result.stderr.splitlines()[-1], "coilwright: out: cannot be written: another run of coilwright is "
                                                                 "writing to it; wait for its end, or give another --out")
                self.assertEqual(list((self.place / "out").iterdir()), [])
                self.assert_ends_well(name, "alone")


def without_parts(files):
    """What could not be removed at the end is cleared away by the next who writes there."""
    return {name: content for name, content in files.items() if ".part-" not in name}


if __name__ == "__main__":
    unittest.main()
