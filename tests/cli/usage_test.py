"""The frame of the program: commands, options, help and exit codes."""

import unittest

from program import ProgramTest, run


class Usage(ProgramTest):
    def test_a_mistyped_command_is_named_with_the_one_that_was_meant(self):
        self.assert_refused(["forse", "x.json"],
                            'unknown command "forse"; did you mean "force"? (see coilwright --help)')
        self.assert_refused(["banana"], 'unknown command "banana" (see coilwright --help)')
        self.assert_refused(["a\nb"], 'unknown command "a\\nb" (see coilwright --help)')
        self.assert_refused([""], 'unknown command "" (see coilwright --help)')

    def test_a_mistyped_option_is_named_with_the_one_that_was_meant(self):
        self.assert_refused(["force", "x.json", "--jsno"],
                            'force: unknown option "--jsno"; did you mean "--json"? (see coilwright force --help)')
        self.assert_refused(["--verison"],
                            'unknown option "--verison"; did you mean "--version"? (see coilwright --help)')

    def test_missing_and_superfluous_arguments_are_refused(self):
        self.assert_refused(["force"], "force: PAIR.json is required (see coilwright force --help)")
        self.assert_refused(["force", "a.json", "b.json"],
                            'force: unexpected argument "b.json" (see coilwright force --help)')

    def test_no_command_at_all_is_refused(self):
        result = run()
        self.assertEqual(result.returncode, 2)
        self.assertTrue(result.stderr.startswith("coilwright: a command is needed: evaluate, "))
        self.assertEqual(result.stderr.count("\n"), 1)

    def test_help_and_version_are_no_errors(self):
        for arguments in (["--help"], ["-h"], ["force", "--help"], ["--version"]):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)
        self.assertRegex(run("--version").stdout, r"^coilwright \d+\.\d+\.\d+\n$")

    def test_the_help_of_every_command_shows_an_example(self):
        text = run("--help").stdout
        commands = [line.split()[0] for line in text.split("Subcommands:\n")[1].split("\n\n")[0].splitlines()]
        self.assertIn("force", commands)
        for command in commands:
            self.assertIn(f"coilwright {command}", run(command, "--help").stdout.split("Example")[1])

    def test_results_that_cannot_be_printed_are_a_failure(self):
        self.write("pair.json", '{"magnets": [{"radius_mm": 4, "length_mm": 6, "remanence_T": 1.3},'
                                '{"radius_mm": 5, "length_mm": 3, "remanence_T": 1.1}],'
                                '"poses": [{"position_mm": [0.5, 0, 14], "axis": [0, 0.1, 1]}]}')
        with open("/dev/full", "w") as full:
            result = run("force", "pair.json", cwd=self.folder, stdout=full)
        self.assertEqual((result.returncode, result.stderr), (1, "coilwright: standard output cannot be written\n"))


if __name__ == "__main__":
    unittest.main()
