"""What shells and man read: completion scripts and manual pages, from the program's own commands and options."""

import re
import shutil
import subprocess
import unittest

from program import ProgramTest, run


def commands():
    return [line.split()[0] for line in run("--help").stdout.split("Subcommands:\n")[1].split("\n\n")[0].splitlines()]


def options(*command):
    named = re.findall(r"^ +(?:-\w,)?(--[\w-]+(?:,--[\w-]+)*)", run(*command, "--help").stdout, re.M)
    return {name for names in named for name in names.split(",")}


class Completion(ProgramTest):
    def complete(self, *words):
        """What bash offers for the last of the words."""
        quoted = " ".join(f"'{word}'" for word in ("coilwright", *words))
        script = f"source ./script; COMP_WORDS=({quoted}); COMP_CWORD={len(words)}; _coilwright; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        self.write("script", run("completion", "bash").stdout)
        result = subprocess.run(["bash", "--norc", "-c", script], cwd=self.folder, capture_output=True, encoding="utf-8",
                                check=True)
        self.assertEqual(result.stderr, "")
        return set(result.stdout.split())

    def test_offers_commands_options_words_and_files(self):
        self.assertEqual(self.complete(""), set(commands()))
        self.assertEqual(self.complete("ev"), {"evaluate"})
        self.assertEqual(self.complete("rig", ""), {"torque-bench", "stiffness-gauge", "grasp-bench", "camera"})
        self.assertEqual(self.complete("list", "ma"), {"magnets"})
        self.assertEqual(self.complete("help", "si"), {"simulate", "size"})
        self.assertEqual(self.complete("size", "--max"), {"--max-evaluations"})
        self.assertIn("isres", self.complete("size", "x.json", "--algorithm", ""))
        self.write("study.json", "{}")
        self.assertEqual(self.complete("size", "stu"), {"study.json"})
        self.assertEqual(self.complete("size", "study.json", "--out", "stu"), {"study.json"})

    def test_offers_values(self):
        self.assertIn("workshop", self.complete("export", "a.json", "--as", ""))
        self.assertEqual(self.complete("export", "a.json", "--as", "mo"), {"mould"})
        self.assertIn("gap_mm=", self.complete("evaluate", "a.json", "--set", "gap"))
        # Words as bash takes them apart: what is offered takes the place of what stands behind the = or the :.
        self.assertEqual(self.complete("evaluate", "a.json", "--set", "configuration", "="), set("ABCD"))
        self.assertLessEqual({"N42", "N42SH"}, self.complete("size", "a.json", "--set", "magnet_grade", "=", "N42"))
        self.assertEqual(self.complete("size", "--set", "=", "configuration", "=", "A"), {"A"})
        self.assertEqual(self.complete("twin", "a.json", "--effect", "dry_friction", ":"), {"torque_Nmm="})
        self.write("study.json", "{}")
        self.assertEqual(self.complete("size", "--out", "=", "stu"), {"study.json"})

    def test_offers_every_option_that_the_help_has(self):
        for command in (["evaluate"], ["simulate"], ["drive"], ["rig", "camera"]):
            offered = self.complete(*command, "--")
            self.assertEqual(offered, options(*command), command)

    @unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
    def test_zsh_reads_its_script(self):
        self.write("script", run("completion", "zsh").stdout)
        subprocess.run(["zsh", "-n", "script"], cwd=self.folder, check=True)

    def test_the_script_of_zsh_has_the_same_words(self):
        bash, zsh = run("completion", "bash").stdout, run("completion", "zsh").stdout
        self.assertTrue(zsh.startswith("#compdef coilwright\n"))
        tables = [text[text.index("_coilwright_words() {"):text.index("\n_coilwright() {")] for text in (bash, zsh)]
        self.assertEqual(tables[0], tables[1])
        self.assert_refused(["completion", "fish"], 'completion: SHELL: must be one of "bash", "zsh"; got "fish" (see '
                            'coilwright completion --help)')


class Manual(ProgramTest):
    def setUp(self):
        super().setUp()
        result = run("man", "--out", "man1", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))

    def page(self, name):
        return (self.folder / "man1" / f"coilwright{name}.1").read_text()

    def test_there_is_a_page_for_every_command(self):
        names = {path.stem for path in (self.folder / "man1").iterdir()}
        self.assertLessEqual({"coilwright", *(f"coilwright-{name}" for name in commands())}, names)
        self.assertIn("coilwright-rig-camera", names)

    def test_a_page_that_was_changed_is_kept(self):
        page = self.page("-size")
        self.write("man1/coilwright-size.1", "mine")
        self.assert_refused(["man", "--out", "man1"], "man1/coilwright-size.1: cannot be written: it holds something else; "
                                                      "--force replaces it, another --out keeps it")
        self.assertEqual(run("man", "--out", "man1", "--force", cwd=self.folder).returncode, 0)
        self.assertEqual(self.page("-size"), page)

    def test_a_page_says_what_the_help_says(self):
        for command in (["size"], ["rig", "camera"], ["drive"]):
            text = self.page("-" + "-".join(command)).replace("\\-", "-")
            named = "\n".join(re.findall(r"^\\fB-.*", text, re.M))  # "\fB--steps-A\fR, \fB--steps\fR"
            self.assertEqual(set(re.findall(r"\\fB(--[\w-]+)", named)), options(*command))
            for line in run(*command, "--help").stdout.split("Example")[1].splitlines()[1:]:
                self.assertIn(line.strip().rstrip("\\").strip(), text)
        self.assertIn("Exit codes: 0 done;", self.page(""))

    @unittest.skipUnless(shutil.which("groff"), "groff is not installed")
    def test_troff_has_nothing_to_complain_of(self):
        for path in sorted((self.folder / "man1").iterdir()):
            result = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z", path], capture_output=True, encoding="utf-8",
                                    check=True)
            self.assertEqual(result.stderr, "", path.name)


if __name__ == "__main__":
    unittest.main()
