"""One program that has all commands: it says what the programs say that have some each, also where a command calls another."""

import os
import re
import subprocess
import unittest

from program import CONFIGS, PROGRAM, ProgramTest
from study import GRID, write_study

IN_ONE = os.environ["COILWRIGHT_IN_ONE"]
COMMANDS = re.findall(r"^COMMAND\((\w+),", (CONFIGS.parent / "src/cli/commands.def").read_text(), re.M)


class InOne(ProgramTest):
    def both(self, *arguments):
        """What both say."""
        said = [subprocess.run([program, *arguments], cwd=self.folder, capture_output=True, encoding="utf-8", check=False)
                for program in (PROGRAM, IN_ONE)]
        self.assertEqual(*((each.returncode, each.stdout, each.stderr) for each in said))
        return said[1]

    def test_every_command_explains_itself(self):
        self.assertGreater(len(COMMANDS), 20)
        for command in COMMANDS:
            with self.subTest(command):
                self.assertEqual(self.both(command, "--help").returncode, 0)
        for arguments in ((), ("--help",), ("--version",), ("completion", "bash"), ("man", "--out", "man", "--force"), ("siz",)):
            self.both(*arguments)

    def test_a_command_that_calls_another_calls_itself(self):
        write_study(self, search={"max_evaluations": 10, "seed": 5})
        self.assertEqual(self.both("size", "study.json", "--out", "out", "--quiet", "--force").returncode, 0)
        self.both("report", "out")  # a build without Vega refuses it
        write_study(self, variables=GRID)
        work = ("distribute", "study.json", "--parts", "2", "--options", "--sample 8", "--out", "work", "--force")
        self.assertEqual(self.both(*work).returncode, 0)


if __name__ == "__main__":
    unittest.main()
