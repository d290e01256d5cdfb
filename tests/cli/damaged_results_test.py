"""Every reader on files that were changed at random, `report` on folders of results: an answer, or one line that names a
file; no crash, not 20 s of work, not a gigabyte.

With a program that has the sanitizers (preset asan-ubsan) what they find is a failure, too.
"""

import collections
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import tempfile
import unittest

from diagnose_test import PLAN, QUICK_PLAN, ROD
from program import DATA, PROGRAM, THOROUGH, ProgramTest, run
from study import FRONT, GRID, write_study

MUTATIONS = 10 * THOROUGH  # of each kind of folder and of input
VALUES = [None, True, "", "x", "1", -1, 0, 1e300, 2**60, [], {}, [None], {"a": 1}, ["x"]]
FIELDS = ["", "x", "nan", "-1", "1e999", "0", "1e300", "ok", "failed", "\"a\"\"b\""]


def nodes_of(value, at=()):
    """Every place of a JSON value."""
    yield at
    members = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, member in members:
        yield from nodes_of(member, (*at, key))


def changed_json(text, draw):
    value = json.loads(text)
    *path, last = draw.choice([at for at in nodes_of(value) if at])
    parent = value
    for key in path:
        parent = parent[key]
    how = draw.randrange(4)
    if how == 0:
        del parent[last]
    elif how == 1 and isinstance(parent, dict) and len(parent) > 1:
        other = draw.choice([key for key in parent if key != last])
        parent[last], parent[other] = parent[other], parent[last]
    else:
        parent[last] = draw.choice(VALUES)
    return json.dumps(value, indent=2) + "\n"


def changed_table(text, draw):
    lines = text.splitlines()
    cells = [line.split(",") for line in lines]
    row, column = draw.randrange(len(cells)), draw.randrange(len(cells[0]))
    how = draw.randrange(6)
    if how == 0:
        for each in cells:
            del each[column:column + 1]
    elif how == 1:
        other = draw.randrange(len(cells[0]))
        cells[0][column], cells[0][other] = cells[0][other], cells[0][column]
    elif how == 2:
        del cells[row]
    elif how == 3:
        cells.insert(row, cells[row])
    elif how == 4:
        cells = cells[:1]
    else:
        cells[row][min(column, len(cells[row]) - 1)] = draw.choice(FIELDS)
    return "".join(",".join(each) + "\n" for each in cells)


def change(folder, draw):
    """Changes one file of a folder, and says how."""
    file = draw.choice(sorted(path for path in folder.iterdir() if path.suffix in (".json", ".csv", ".txt")))
    how = draw.randrange(8)
    if how == 0:
        file.unlink()
        return f"{file.name} removed"
    text = file.read_text()
    if how == 1 or file.suffix == ".txt":
        end = draw.randrange(len(text))
        file.write_text(text[:end])
        return f"{file.name} cut at {end}"
    file.write_text((changed_json if file.suffix == ".json" else changed_table)(text, draw))
    return f"{file.name} changed"


def changed_bytes(content, draw):
    """A bit flipped, a piece cut out, doubled or put elsewhere."""
    begin = draw.randrange(len(content))
    end = min(len(content), begin + draw.choice((1, 4, 40, 400)))
    piece = content[begin:end]
    how = draw.randrange(4)
    if how == 0:
        return content[:begin] + bytes([content[begin] ^ 1 << draw.randrange(8)]) + content[begin + 1:]
    if how == 1:
        return content[:begin] + content[end:]
    place = draw.randrange(len(content)) if how == 2 else end
    return content[:place] + piece + content[place:]


# The file that is changed, and a command that reads it.
READERS = {
    "actuator.json": ["evaluate", "actuator.json", "--current-A", "1"],
    "lumped_model.json": ["linearise", "lumped_model.json", "--current-A", "1"],
    "pair.json": ["force", "pair.json"],
    "bodies.json": ["force", "bodies.json"],
    "plan.json": ["twin", "rod.json", "--experiment", "plan.json", "--out", "new"],
    "input.csv": ["simulate", "actuator.json", "--input", "input.csv", "--out", "new.csv"],
    "study.json": ["size", "study.json", "--out", "new", "--max-evaluations", "1", "--answer-only", "--quiet"],
    "set/dataset.json": ["diagnose", "set", "--out", "new"],
    "set/slow.csv": ["diagnose", "set", "--out", "new"],
    "done/archive.sqlite": ["archive", "csv", "done"],
}


class DamagedInputs(ProgramTest):
    def setUp(self):
        super().setUp()
        self.place = self.folder / "place"
        self.place.mkdir()
        for path in (DATA / "formats").iterdir():
            if path.is_file():
                shutil.copy(path, self.place)
        for name, content in (("rod.json", ROD), ("plan.json", QUICK_PLAN)):
            (self.place / name).write_text(json.dumps(content))
        folder, self.folder = self.folder, self.place
        write_study(self, search={"max_evaluations": 5})
        self.folder = folder
        for arguments in (["size", "study.json", "--out", "done", "--answer-only"],
                          ["twin", "rod.json", "--experiment", "plan.json", "--out", "set"]):
            self.assertEqual(run(*arguments, cwd=self.place).returncode, 0)

    def bounded(self, arguments):
        """Its exit code, what it says, and the largest memory it had."""
        seconds = 2 if arguments[0] == "diagnose" else 20  # of work, however busy the machine is

        def bound():
            resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))

        with tempfile.TemporaryFile() as errors:
            process = subprocess.Popen([PROGRAM, *arguments], cwd=self.place, stdout=subprocess.DEVNULL, stderr=errors,
                                       preexec_fn=bound)
            _, status, used = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            errors.seek(0)
            return process.returncode, errors.read().decode(), used.ru_maxrss * 1024

    def test_every_reader_answers_or_says_why_not(self):
        codes = collections.Counter()
        for name, arguments in READERS.items():
            file = self.place / name
            whole = file.read_bytes()
            for seed in range(MUTATIONS // 3 if arguments[0] == "diagnose" else MUTATIONS):  # of which each takes seconds
                draw = random.Random(f"{name} {seed}")
                if file.suffix == ".sqlite" or draw.randrange(3) == 0:
                    content = changed_bytes(whole, draw)
                else:
                    content = (changed_json if file.suffix == ".json" else changed_table)(whole.decode(), draw).encode()
                file.write_bytes(content)
                with self.subTest(f"{name}, seed {seed}"):
                    code, errors, memory = self.bounded(arguments)
                    codes[code] += 1
                    if code == -signal.SIGKILL and arguments[0] == "diagnose" and errors:
                        continue  # what it says of its work it says when all is read
                    self.assertIn(code, (0, 1, 2, 3), errors)  # 1: numbers that are read, and no motion follows from
                    self.assertLess(memory, 1e9)
                    if code in (1, 2):
                        self.assertRegex(errors.splitlines()[-1], r"^coilwright: [^\n]+$")
                for new in self.place.glob("new*"):
                    shutil.rmtree(new) if new.is_dir() else new.unlink()
            file.write_bytes(whole)
        print(f"{sum(codes.values())} changed inputs of {len(READERS)} readers: {codes[0] + codes[3]} "
              f"answered, {codes[1] + codes[2]} refused")


class DamagedResults(ProgramTest):
    def setUp(self):
        super().setUp()
        (self.folder / "none").mkdir()
        if "built without Vega" in run("report", "none", cwd=self.folder).stderr:
            self.skipTest("the program was built without Vega")

    def assert_every_damage_is_told(self):
        whole = self.folder / "whole"
        (self.folder / "out").rename(whole)
        (whole / "archive.sqlite").unlink(missing_ok=True)
        told = 0
        for seed in range(MUTATIONS):
            shutil.copytree(whole, self.folder / "out")
            how = f"seed {seed}: {change(self.folder / 'out', random.Random(seed))}"
            result = run("report", "out", "--pictures", "2", "--out", "page.html", cwd=self.folder)
            written = (self.folder / "page.html").exists()
            self.assertIn(result.returncode, (0, 2), f"{how}: {result.stderr}")
            self.assertEqual(written, result.returncode == 0, how)
            if result.returncode:
                # One line, of a file or of the folder as a whole.
                self.assertRegex(result.stderr, r"^coilwright: out[/:][^\n]*\n$", how)
                told += 1
            (self.folder / "page.html").unlink(missing_ok=True)
            shutil.rmtree(self.folder / "out")
        self.assertGreater(told, MUTATIONS // 4)

    def assert_objectives_are_read_by_their_rules(self, told):
        """A stranger's result.json: objectives, and what is said of them."""
        result = self.result("out/result.json")
        for objectives, message in told:
            self.write("out/result.json", json.dumps({**result, "objectives": objectives}))
            self.assert_refused(["report", "out", "--out", "page.html"], "out/result.json: /objectives" + message)
        self.write("out/result.json", json.dumps(result))

    def test_of_size(self):
        write_study(self, search={"max_evaluations": 20, "seed": 5})
        self.assertEqual(run("size", "study.json", "--out", "out", "--quiet", cwd=self.folder).returncode, 0)
        mass = {"minimise": "mass_g"}
        self.assert_objectives_are_read_by_their_rules(
            ([[], ": must have 1 element; got an array of 0"], [[mass] * 5, ": must have 1 element; got an array of 5"],
             [[{}], "/0: must have exactly one member (docs/formats.md)"],
             [[{"least": "mass_g"}], '/0: must have "maximise" or "minimise" (docs/formats.md)']))
        self.assert_every_damage_is_told()

    def test_of_pareto(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 40, "seed": 5})
        self.assertEqual(run("pareto", "study.json", "--out", "out", "--quiet", cwd=self.folder).returncode, 0)
        mass = {"minimise": "mass_g"}
        self.assert_objectives_are_read_by_their_rules(
            [[[mass] * count, f": must have 2 to 3 elements; got an array of {count}"] for count in (0, 1, 5)])
        self.assert_every_damage_is_told()

    def test_of_sweep(self):
        write_study(self, variables=GRID, objectives=FRONT)
        self.assertEqual(run("sweep", "study.json", "--out", "out", "--quiet", cwd=self.folder).returncode, 0)
        self.assert_every_damage_is_told()

    def test_of_diagnose(self):
        self.write("rod.json", json.dumps(ROD))
        self.write("plan.json", json.dumps(PLAN))
        self.assertEqual(run("twin", "rod.json", "--experiment", "plan.json", "--effect", "dry_friction:torque_Nmm=25",
                             "--out", "set", cwd=self.folder).returncode, 0)
        self.assertEqual(run("diagnose", "set", "--out", "out", cwd=self.folder).returncode, 0)
        self.assert_every_damage_is_told()


if __name__ == "__main__":
    unittest.main()
