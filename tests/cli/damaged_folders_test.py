"""Every command that reads a folder of results, on folders of which one file is not as the run wrote it: the answer of the whole
folder, or a line that names what is wrong. And what such a folder holds of a stranger's text: no terminal obeys it, and no
spreadsheet.

The commands are the examples of the manual pages that read such a folder, so that a new one is tried without a line here.
"""

import csv
import json
import os
import pty
import random
import re
import shlex
import shutil
import subprocess
import unittest

from archived_runs import ARCHIVE, forge
from parts_test import DAMAGES, changed, places_of
from program import PROGRAM, THOROUGH, run
from study import FRONT, GRID, write_study
from writing_commands import WritingCommands

MOST = 8 * THOROUGH  # damages of each kind of folder for each
SECONDS = 60  # which no command takes here, on however busy a machine
STUDIES = {"size": {}, "pareto": {"objectives": FRONT}, "sweep": {"variables": GRID, "objectives": FRONT}}
KINDS = [*STUDIES, "diagnose"]
EVIL = "'-' || char(27) || '[31mred' || char(7, 13, 155) || '2J' || char(8238)"  # in SQL: no file of a study may have such a name
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


def examples(folder):
    """The examples of all manual pages, as words; without the bench, which ends when it is told to (bench_test.py)."""
    assert run("man", "--out", folder / "man1").returncode == 0
    pages = sorted((folder / "man1").iterdir())
    lines = [line.replace("\\-", "-").strip() for page in pages for line in page.read_text().splitlines()]
    words = [shlex.split(line)[1:] for line in lines if re.match(r"coilwright [a-z]+ .*results/", line)]
    return [each for each in words if each[0] != "bench"]


def inputs_of(example):
    """The places of a folder of results that a command reads: a part of a run, or the only one."""
    folders = [i for i, word in enumerate(example) if re.fullmatch(r"results/\w+", word) and example[i - 1] not in ("--out", "--figures")]
    parts = [i for i in folders if "part" in example[i]]
    return parts or folders


class DamagedFolders(WritingCommands):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        if "built without Vega" in run("report", cls.inputs / "set").stderr:
            raise unittest.SkipTest("the program was built without Vega")
        maker = cls()
        for name, seed in (("", 5), ("other ", 6)):
            maker.folder = cls.inputs / f"{name}studies"
            maker.folder.mkdir()
            for kind, changes in STUDIES.items():
                write_study(maker, **{"search": {"max_evaluations": 20, "seed": seed}, "name": f"+{name}1",
                                      **changes, "constraints": [{"quantity": "mass_g", "at_most": 61 + seed}]})
                (maker.folder / "study.json").rename(maker.folder / f"{kind}.json")
                result = run(kind, maker.folder / f"{kind}.json", "--out", cls.inputs / f"{name}{kind}", "--quiet")
                assert result.returncode == 0, result.stderr
            result = run("diagnose", "set", "--seed", seed, "--out", f"{name}diagnose", cwd=cls.inputs)
            assert result.returncode == 0, result.stderr
        cls.commands = [example for example in examples(cls.inputs) if inputs_of(example)]

    def call(self, example, kind, damage=None, file=None):
        """The result of an example on a folder of a kind, of which a file was damaged, and what it wrote."""
        shutil.rmtree(self.place, ignore_errors=True)
        self.place.mkdir()
        words = list(example)
        for i in inputs_of(example):
            name = example[i].split("/")[1]
            source = name if "part" in name else kind
            words[i] = f"results/{name}"
            shutil.copytree(self.inputs / source, self.place / words[i])
        folder = self.place / words[inputs_of(example)[0]]
        before = {path for path in self.place.rglob("*")}
        if damage:
            damage(folder / file)
            before |= {path for path in self.place.rglob("*")}
        result = subprocess.run([PROGRAM, *words], cwd=self.place, capture_output=True, encoding="utf-8", timeout=SECONDS, check=False)
        written = {path.relative_to(self.place): path.read_bytes() for path in self.place.rglob("*")
                   if path not in before and path.is_file() and not path.name.startswith(ARCHIVE)}
        return result, written

    def damages_of(self, kind, example):
        """Each damage of each file of a folder, by name."""
        folder = self.inputs / ("part1" if "part" in example[inputs_of(example)[0]] else kind)
        out = []
        for file in sorted(path.name for path in folder.iterdir() if path.name != "report.html"):
            out += [(file, how, damage) for how, damage in DAMAGES.items()]
            other = self.inputs / f"other {kind}" / file
            if other.exists() and other.read_bytes() != (folder / file).read_bytes():
                out.append((file, "of another run", lambda path, other=other: shutil.copy(other, path)))
            if file.endswith(".json"):
                content = json.loads((folder / file).read_text())
                out += [(file, f"another {'/'.join(map(str, at))}",
                         lambda path, at=at, content=content: path.write_text(json.dumps(changed(content, at), indent=2) + "\n"))
                        for at in places_of(content)]
        return out

    def assert_same_or_told(self, how, file, expected, found):
        (before, wrote_before), (now, wrote) = expected, found
        self.assertIn(now.returncode, (0, 1, 2, 3), f"{how}: {now.stderr}")
        if now.returncode == before.returncode and (now.stdout, wrote) == (before.stdout, wrote_before):
            return 0
        self.assertRegex(now.stderr, r"^coilwright: [^\n]+\n$", how)
        self.assertRegex(now.stderr, rf"results/\w+(/{re.escape(file)}|/archive\.sqlite|/found\.json|: )|^coilwright: \w+\.json: |\(parts \d", how)
        if now.returncode in (1, 2):
            self.assertEqual((now.stdout, wrote), ("", {}), how)
        return 1

    def test_a_damaged_folder_gives_its_answer_or_a_line(self):
        names = {" ".join(example[:2]) for example in self.commands}
        self.assertLessEqual({"archive top", "archive pick", "archive check"}, names)
        self.assertTrue(any(example[0] == "report" for example in self.commands))
        draw = random.Random(73)
        told = tried = pairs = 0
        for example in self.commands:
            for kind in KINDS:
                expected = self.call(example, kind)
                if expected[0].returncode not in (0, 3):
                    self.assertRegex(expected[0].stderr, r"^coilwright: [^\n]+\n$")
                    continue  # no folder of this command
                pairs += 1
                damages = self.damages_of(kind, example)
                for file, how, damage in draw.sample(damages, min(MOST, len(damages))):
                    with self.subTest(command=example, kind=kind, file=file, damage=how):
                        found = self.call(example, kind, damage, file)
                        told += self.assert_same_or_told(f"{example} {kind} {file} {how}", file, expected, found)
                        tried += 1
        print(f"{len(self.commands)} examples, {pairs} with a kind of folder each: of {tried} damages {told} were told, the others "
              "left the answer as it was")

    def test_a_page_shows_no_result_that_is_not_as_it_was_written(self):
        """Each file of each kind of folder; a value that no program writes, and results of another run, too."""
        report = next(example for example in self.commands if example[0] == "report")
        for kind in KINDS:
            whole = self.inputs / kind
            names = {path.name for path in whole.iterdir()} - {ARCHIVE, "report.html"}
            listed = {file["file"] for file in json.loads((whole / "provenance.json").read_text())["files"]}
            self.assertEqual(listed, names - {"provenance.json"}, kind)
            draw = random.Random(kind)
            damages = [each for each in self.damages_of(kind, report) if each[0] in names]
            for file, how, damage in draw.sample(damages, min(2 * MOST, len(damages))):
                with self.subTest(kind=kind, file=file, damage=how):
                    result, wrote = self.call(report, kind, damage, file)
                    if (file, how) == ("provenance.json", "missing"):
                        self.assertIn("provenance.json is not there: nothing tells whether", result.stderr)
                        self.assertIn(b"provenance.json is not there: nothing tells whether", b"".join(wrote.values()).replace(b"<wbr>", b""))
                        continue
                    self.assertEqual((result.returncode, result.stdout, wrote), (2, "", {}), how)
                    self.assertRegex(result.stderr, r"^coilwright: results/\w+[/:][^\n]*\n$")
            for stray in ("actuator.json", "next_experiment.csv", "front.csv"):
                if stray not in names:
                    result, wrote = self.call(report, kind, lambda path: path.write_text("{}"), stray)
                    self.assertEqual((result.returncode, wrote), (2, {}))
                    self.assertRegex(result.stderr, rf"^coilwright: results/\w+/{stray}: ")

    def test_no_terminal_obeys_what_a_folder_holds(self):
        for kind in STUDIES:
            for change in (f"designs SET failure = {EVIL} WHERE id % 2 = 0", f"study SET name = {EVIL}", f"inputs SET file = {EVIL}",
                           f"runs SET stop_reason = {EVIL}"):
                forge(self.copy_of(kind), f"UPDATE {change}")
        calls = [(example, kind) for example in self.commands for kind in STUDIES if "part" not in example[inputs_of(example)[0]]]
        shown = escapes = 0
        for example, kind in calls:
            for options in ([], ["--json"]):
                with self.subTest(command=example, kind=kind, options=options):
                    words = [word if i not in inputs_of(example) else kind for i, word in enumerate(example)]
                    escapes += self.assert_plain([*words, *options])
                    shown += 1
        print(f"{shown} commands on a terminal, {escapes} of which had escapes to show")
        self.assertGreater(escapes, 3)

    def copy_of(self, kind):
        if not (self.place / kind).exists():
            shutil.copytree(self.inputs / kind, self.place / kind)
        return self.place / kind

    def assert_plain(self, words):
        """Whether there were escapes to show in what a command prints on a terminal, which obeys nothing of it."""
        said = self.on_terminal(words).replace("\r\n", "\n")
        self.assertIsNone(CONTROL.search(said), said[:300])
        return "\\x1b" in said

    def on_terminal(self, words):
        outer, inner = pty.openpty()
        with subprocess.Popen([PROGRAM, *words], cwd=self.place, stdout=inner, stderr=inner, stdin=subprocess.DEVNULL):
            os.close(inner)
            said = b""
            while True:
                try:
                    block = os.read(outer, 65536)
                except OSError:  # the last that wrote to it has ended
                    break
                if not block:
                    break
                said += block
        os.close(outer)
        return said.decode()

    def test_no_spreadsheet_runs_what_a_folder_holds(self):
        forge(self.copy_of("size"), "UPDATE designs SET failure = '=HYPERLINK(1)', status = 'failed' WHERE id % 2 = 0")
        result = run("archive", "csv", "size", "--out", "all.csv", cwd=self.place)
        self.assertEqual(result.returncode, 0, result.stderr)
        cells = 0
        for path in [self.place / "all.csv", *self.inputs.glob("*/*.csv")]:
            with open(path, newline="", encoding="utf-8") as file:
                for row in csv.reader(file):
                    for cell in row:
                        if cell[:1] in tuple("=+-@\t\r\n"):
                            float(cell)  # or a spreadsheet would run it
                        cells += 1
        self.assertIn("'=HYPERLINK(1)", (self.place / "all.csv").read_text())
        shown = json.loads(run("archive", "csv", "size", "--json", cwd=self.place).stdout)
        self.assertIn('"=HYPERLINK(1)"', json.dumps(shown))
        print(f"{cells} cells")


if __name__ == "__main__":
    unittest.main()
