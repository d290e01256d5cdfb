"""Runs the built program the way a user does."""

import csv
import json
import os
import pathlib
import random
import resource
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["COILWRIGHT"]
DATA = pathlib.Path(os.environ["COILWRIGHT_TEST_DATA"])
CONFIGS = DATA.parent.parent / "configs"
PAPER_FINGER = CONFIGS / "actuators" / "paper_finger.json"
# A command that takes longer does not end at all, not even on a busy machine.
HANGS = 900  # s
# How much is tried where more could be than anyone waits for: 3 in the long tests, 100 for a night.
THOROUGH = int(os.environ.get("COILWRIGHT_THOROUGH", "1"))


def drawn(cases):
    """Of many cases a third, always the same; all from a thoroughness of 3 on."""
    cases = list(cases)
    return random.Random(1).sample(cases, min(len(cases), -(-THOROUGH * len(cases) // 3)))


def run(*arguments, cwd=None, stdout=subprocess.PIPE):
    return subprocess.run([PROGRAM, *map(str, arguments)], cwd=cwd, stdout=stdout, stderr=subprocess.PIPE,
                          encoding="utf-8", timeout=HANGS, check=False)


class ProgramTest(unittest.TestCase):
    """Each test runs in an empty folder of its own."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def write(self, name, content):
        (self.folder / name).write_bytes(content if isinstance(content, bytes) else content.encode())

    def files(self):
        return {str(path.relative_to(self.folder)): path.read_bytes() if path.is_file() else None
                for path in self.folder.rglob("*")}

    def table(self, name):
        """A CSV file as a list of rows by column, text as it stands there."""
        with open(self.folder / name, newline="") as file:
            return list(csv.DictReader(file))

    def result(self, name):
        return json.loads((self.folder / name).read_text())

    def assert_refused(self, arguments, message, code=2):
        """One line on standard error, nothing on standard output, no file written or changed."""
        before = self.files()
        result = run(*arguments, cwd=self.folder)
        self.assertEqual(result.stderr, "coilwright: " + message + "\n")
        self.assertEqual(result.stdout, "")
        self.assertEqual(result.returncode, code)
        self.assertEqual(self.files(), before)


def peak_memory_of_children():
    """Bytes; the largest child so far."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * 1024
