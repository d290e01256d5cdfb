"""What `merge` takes from the folder of a part: every file as the part wrote it, and no number that nothing guards; and
that it never writes where its parts are. The files and numbers are those that the parts have, whatever they are called."""

import json
import os
import shutil
import subprocess
import unittest

from program import PROGRAM, drawn, run
from writing_commands import WritingCommands

SECONDS = 20  # which no merge of these parts takes, on however busy a machine
KINDS = {
    "sweep": ["sweep", "sweep.json"],
    "sweep without rows": ["sweep", "sweep.json", "--keep", "best"],
    "size": ["size", "size.json", "--answer-only"],
    "pareto": ["pareto", "pareto.json"],
    "yield": ["yield", "spread.json", "finger.json", "--builds", "20"],
    "diagnose": ["diagnose", "set"],
}


def replace_by_link(file, target):
    file.unlink()
    file.symlink_to(target)


def make_pipe(file):
    file.unlink()
    os.mkfifo(file)


def make_folder(file):
    file.unlink()
    file.mkdir()


def change_a_byte(file):
    """The first from the middle on that says something: the last digit of a number may be rounding."""
    content = file.read_bytes()
    for place in range(len(content) // 2, len(content)):
        changed = content[:place] + bytes([content[place] ^ 1]) + content[place + 1:]
        try:
            if file.suffix != ".json" or json.loads(changed) != json.loads(content):
                break
        except ValueError:
            break
    file.write_bytes(changed)


DAMAGES = {
    "missing": lambda file: file.unlink(),
    "torn": lambda file: file.write_bytes(file.read_bytes()[:-9]),
    "longer": lambda file: file.write_bytes(file.read_bytes() + b"\n"),
    "changed": change_a_byte,
    "empty": lambda file: file.write_bytes(b""),
    "a link to a file of the system": lambda file: replace_by_link(file, "/etc/passwd"),
    "a link that leads to the same bytes": lambda file: (shutil.copy(file, file.parent.parent / "copy"), replace_by_link(file, "../copy")),
    "a link to a device without an end": lambda file: replace_by_link(file, "/dev/zero"),
    "a link that leads nowhere": lambda file: replace_by_link(file, "nowhere"),
    "a pipe": make_pipe,
    "a folder": make_folder,
}


def places_of(value, at=()):
    """Each kind of place that a value without parts has in a JSON value, once: of a list its last element."""
    if isinstance(value, dict):
        for key, member in value.items():
            yield from places_of(member, (*at, key))
    elif isinstance(value, list):
        if value:
            yield from places_of(value[-1], (*at, -1))
    else:
        yield at


def changed(value, at):
    value = json.loads(json.dumps(value))
    parent = value
    for key in at[:-1]:
        parent = parent[key]
    old = parent[at[-1]]
    parent[at[-1]] = (not old if isinstance(old, bool) else old + 1 if isinstance(old, (int, float)) else
                      "1" if old is None else old + "1")
    return value


class Parts(WritingCommands):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for kind, arguments in KINDS.items():
            folder = cls.inputs / kind
            folder.mkdir()
            for number in (1, 2):
                part = [*arguments, "--quiet", "--part", f"{number}/2", "--out", f"{kind}/part{number}"]
                result = run(*part, cwd=cls.inputs)
                assert result.returncode == 0, (part, result.stderr)

    def lay(self, kind):
        """The parts of a kind alone, in a folder of their own."""
        shutil.rmtree(self.place, ignore_errors=True)
        shutil.copytree(self.inputs / kind, self.place)
        return self.place / "part1"

    def merge(self, *arguments):
        return subprocess.run([PROGRAM, "merge", *arguments], cwd=self.place, capture_output=True, encoding="utf-8",
                              timeout=SECONDS, check=False)

    def state(self):
        """Whatever lies there, without opening what never ends."""
        return {str(path.relative_to(self.place)): (path.lstat().st_mode, path.read_bytes() if path.is_file() and not path.is_symlink() else b"")
                for path in self.place.rglob("*")}

    def assert_refused_as_it_is(self, how, *arguments, names="part"):
        before = self.state()
        result = self.merge(*arguments)
        self.assertIn(result.returncode, (1, 2), (how, result.stderr))
        self.assertRegex(result.stderr, r"^coilwright: [^\n]+\n$", how)
        self.assertIn(names, result.stderr, how)
        self.assertEqual(result.stdout, "", how)
        self.assertEqual(self.state(), before, how)

    def test_a_part_names_every_file_that_it_has(self):
        for kind in KINDS:
            part = self.lay(kind)
            listed = [file["file"] for file in json.loads((part / "part.json").read_text())["files"]]
            there = {path.name for path in part.iterdir()} - {"part.json"}
            self.assertEqual(sorted(listed), sorted(name for name in there if not name.startswith("archive.sqlite")), kind)

    def test_a_file_that_is_not_as_the_part_wrote_it_is_refused(self):
        merges = 0
        for kind in KINDS:
            part = self.lay(kind)
            names = ["part.json", *(file["file"] for file in json.loads((part / "part.json").read_text())["files"])]
            for name, how in drawn((name, how) for name in names for how in DAMAGES):
                with self.subTest(kind=kind, file=name, damage=how):
                    part = self.lay(kind)
                    if name == "part.json" and how == "longer":
                        continue  # a line's end behind a JSON is nothing
                    DAMAGES[how](part / name)
                    self.assert_refused_as_it_is((kind, name, how), "merged", "part1", "part2")
                    merges += 1
        print(f"{merges} damaged parts")

    def whole(self, kind):
        """What the parts of a kind give as they are, and what is printed of it."""
        self.lay(kind)
        result = self.merge("merged", "part1", "part2")
        self.assertIn(result.returncode, (0, 3), result.stderr)
        return result.stdout, {path.name: path.read_bytes() for path in (self.place / "merged").iterdir()}

    def assert_refused_or(self, expected):
        result = self.merge("merged", "part1", "part2")
        if result.returncode in (1, 2):
            self.assertRegex(result.stderr, r"^coilwright: [^\n]+\n$")
            self.assertFalse((self.place / "merged").exists())
        else:
            found = {path.name: path.read_bytes() for path in (self.place / "merged").iterdir()}
            self.assertTrue((result.stdout, found) == expected, "the result is another one")

    def test_no_number_of_a_part_is_believed(self):
        """One value of each kind is changed, in one part or in all alike: refused, or of no consequence."""
        count = 0
        for kind in KINDS:
            expected = self.whole(kind)
            for name in ("part.json", "found.json", "diagnosis.json"):
                if not (self.inputs / kind / "part1" / name).exists():
                    continue
                places = places_of(json.loads((self.inputs / kind / "part1" / name).read_text()))
                for at, numbers in drawn((at, numbers) for at in places for numbers in ([1], [1, 2])):
                    with self.subTest(kind=kind, file=name, place=at, parts=numbers):
                        self.lay(kind)
                        for number in numbers:
                            path = self.place / f"part{number}" / name
                            path.write_text(json.dumps(changed(json.loads(path.read_text()), at), indent=2) + "\n")
                        self.assert_refused_or(expected)
                        count += 1
        print(f"{count} changed values")
        self.assertGreater(count, 100)

    def test_exchanged_files_of_parts_are_refused(self):
        for kind in set(KINDS) - {"diagnose"}:  # whose number is but a place in the table
            expected = self.whole(kind)
            for names in (["part.json"], ["found.json"], ["part.json", "found.json"]):
                with self.subTest(kind=kind, exchanged=names):
                    part = self.lay(kind)
                    for name in names:
                        other = self.place / "part2" / name
                        mine = (part / name).read_bytes()
                        (part / name).write_bytes(other.read_bytes())
                        other.write_bytes(mine)
                    self.assert_refused_or(expected)  # where that is all, the parts are exchanged

    def test_a_list_of_files_is_not_believed_either(self):
        for kind in KINDS:
            expected = self.whole(kind)
            content = json.loads((self.inputs / kind / "part1" / "part.json").read_text())
            for i, file in enumerate(content["files"]):
                with self.subTest(kind=kind, file=file["file"]):
                    part = self.lay(kind)
                    less = {**content, "files": content["files"][:i] + content["files"][i + 1:]}
                    (part / "part.json").write_text(json.dumps(less))
                    self.assert_refused_or(expected)
            part = self.lay(kind)
            for name in ("../part2/part.json", "..", "", "/etc/hostname"):
                (part / "part.json").write_text(json.dumps({**content, "files": [*content["files"], {"file": name, "bytes": 1, "sha256": "0"}]}))
                self.assert_refused_as_it_is((kind, name), "merged", "part1", "part2")

    def test_the_result_never_comes_where_a_part_is(self):
        for kind in KINDS:
            for how, out in (("a part", "part1"), ("a part by another path", "part2/../part1/."), ("a link to a part", "link"),
                             ("in a part", "part1/merged"), ("deep in a part", "link/new/merged")):
                for options in ([], ["--force"]):
                    with self.subTest(kind=kind, out=how, options=options):
                        self.lay(kind)
                        (self.place / "link").symlink_to("part1")
                        self.assert_refused_as_it_is((kind, how), out, "part1", "part2", *options)
            for how, second in (("twice", "part1"), ("by another path", "part2/../part1"), ("by a link", "link"), ("by a copy", "copy"),
                                ("by hard links", "hard")):
                with self.subTest(kind=kind, again=how):
                    self.lay(kind)
                    (self.place / "link").symlink_to("part1")
                    shutil.copytree(self.place / "part1", self.place / "copy")
                    shutil.copytree(self.place / "part1", self.place / "hard", copy_function=os.link)
                    self.assert_refused_as_it_is((kind, how), "merged", "part1", second, "part2", "--force", names="is part 1 of 2")

    def test_a_file_of_a_part_is_not_replaced_through_a_link_in_the_folder_of_the_result(self):
        for kind in KINDS:
            for how, link in (("a link", os.symlink), ("a hard link", os.link)):
                part = self.lay(kind)
                for file in json.loads((part / "part.json").read_text())["files"]:
                    with self.subTest(kind=kind, file=file["file"], link=how):
                        part = self.lay(kind)
                        (self.place / "merged").mkdir()
                        link(part / file["file"], self.place / "merged" / file["file"])
                        self.assert_refused_as_it_is((kind, file), "merged", "part1", "part2", "--force")

    def test_a_part_that_was_damaged_can_be_made_again(self):
        for kind in ("sweep", "size", "yield", "diagnose"):
            with self.subTest(kind=kind):
                self.lay_out()
                out = self.place / kind / "part1"
                for name in ("found.json", "part.json"):
                    (out / name).write_bytes(b"")
                result = run(*KINDS[kind], "--quiet", "--part", "1/2", "--out", out, "--force", cwd=self.place)
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                self.assertEqual(sorted(path.name for path in out.iterdir()),
                                 sorted(path.name for path in (self.inputs / kind / "part1").iterdir()))
                self.assertIn(run("merge", "merged", f"{kind}/part1", f"{kind}/part2", cwd=self.place).returncode, (0, 3))


if __name__ == "__main__":
    unittest.main()
