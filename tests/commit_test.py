#!/usr/bin/env python3
"""What a build knows of its commit: cmake/WriteCommit.cmake on repositories made for the purpose."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
SCRIPT, TEMPLATE = ROOT / "cmake/WriteCommit.cmake", ROOT / "src/results/commit.cpp.in"
NOBODY = {"GIT_AUTHOR_NAME": "a", "GIT_AUTHOR_EMAIL": "a@example.org", "GIT_COMMITTER_NAME": "a",
          "GIT_COMMITTER_EMAIL": "a@example.org", "GIT_CONFIG_GLOBAL": os.devnull, "GIT_CONFIG_NOSYSTEM": "1"}


def git(folder, *arguments):
    return subprocess.run(["git", "-C", folder, *arguments], check=True, capture_output=True, encoding="utf-8",
                          env={**os.environ, **NOBODY}).stdout.strip()


def repository(folder):
    """With one commit of one source, whose hash is returned."""
    for name in ("src", "include", "cmake", "configs", "docs"):
        (folder / name).mkdir()
        (folder / name / "file").write_text("one\n")
    git(folder, "init", "--quiet")
    git(folder, "add", ".")
    git(folder, "commit", "--quiet", "--message", "one")
    return git(folder, "rev-parse", "HEAD")


class Commit(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name) / "sources"
        self.folder.mkdir()
        self.output = pathlib.Path(temporary.name) / "commit.cpp"

    def written(self, sources=None, stated="", program="git"):
        """Hash and "changed" as the source has them."""
        subprocess.run(["cmake", f"-Dgit={program}", f"-Dsources={sources or self.folder}", f"-Dstated={stated}",
                        f"-Dtemplate={TEMPLATE}", f"-Doutput={self.output}", "-P", SCRIPT], check=True)
        return re.search(r'\.hash = "(.*)", \.changed = (\w+)', self.output.read_text()).groups()

    def test_it_is_the_head_of_the_repository(self):
        head = repository(self.folder)
        self.assertEqual(self.written(), (head, "false"))

    def test_what_is_built_and_differs_is_told(self):
        head = repository(self.folder)
        (self.folder / "docs/file").write_text("two\n")
        self.assertEqual(self.written(), (head, "false"))
        (self.folder / "src/file").write_text("two\n")
        self.assertEqual(self.written(), (head, "true"))

    def test_outside_of_a_repository_it_is_unknown(self):
        self.assertEqual(self.written(), ("", "false"))
        repository(self.folder)
        self.assertEqual(self.written(program=""), ("", "false"))  # no git on this machine

    def test_the_repository_around_is_another_one(self):
        repository(self.folder)
        (self.folder / "vendor").mkdir()
        self.assertEqual(self.written(sources=self.folder / "vendor"), ("", "false"))

    def test_a_packager_may_state_it(self):
        self.assertEqual(self.written(stated="v0.1.0-debian"), ("v0.1.0-debian", "false"))

    def test_the_source_is_left_alone_while_nothing_changes(self):
        repository(self.folder)
        self.written()
        os.utime(self.output, (1, 1))
        self.written()
        self.assertEqual(self.output.stat().st_mtime, 1)


if __name__ == "__main__":
    unittest.main()
