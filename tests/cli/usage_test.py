"""The frame of the program: commands, options, help and exit codes."""

import json
import os
import re
import resource
import shutil
import subprocess
import unittest

from program import HANGS, PAPER_FINGER, PROGRAM, ProgramTest, run
from study import write_study


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

    def test_a_command_an_option_or_a_word_is_found_by_its_beginning(self):
        self.assert_refused(["eval"], 'unknown command "eval"; did you mean "evaluate"? (see coilwright --help)')
        self.assert_refused(["size", "--max=3"], 'size: unknown option "--max"; did you mean "--max-evaluations"? '
                            '(see coilwright size --help)')
        self.assert_refused(["drive", "x.json", "--wiring", "par"], 'drive: --wiring: must be one of "parallel", '
                            '"series"; did you mean "parallel"?; got "par" (see coilwright drive --help)')

    def test_a_file_for_another_command_is_named_with_that_command(self):
        write_study(self, constraints=[], search={"max_evaluations": 20})
        for command in (("evaluate",), ("drive", "--duty", "0.5"), ("simulate", "--step-A", "1", "--out", "motion.csv")):
            result = run(*command, "study.json", cwd=self.folder)
            self.assertEqual(result.returncode, 2)
            self.assertIn('this is a study: coilwright size study.json --out results finds its design, results/actuator.json; got '
                          'text "study/1"', result.stderr)
        (cure,) = re.findall(r"coilwright (size .*?) finds", result.stderr)
        self.assertEqual(run(*cure.split(), "--quiet", cwd=self.folder).returncode, 0)
        self.assertEqual(run("evaluate", "results/actuator.json", cwd=self.folder).returncode, 0)
        self.assertIn("this is an actuator: a study that is about it has its name: coilwright init study writes one",
                      run("size", "finger.json", "--out", "out", cwd=self.folder).stderr)
        self.write("old.json", '{"format": "study/0"}')
        self.assert_refused(["size", "old.json", "--out", "out"], 'old.json: /format: must be "study/1"; got text "study/0"')

    def test_a_radius_is_named_where_its_diameter_was_meant(self):
        write_study(self)
        evaluate = ("evaluate", "finger.json", "--current-A", "1", "--set")
        for said, meant in (("magnet_diameter_mm=6", '"magnet_radius_mm", half of the diameter'),
                            ("coil_inner_diameter_mm=6", '"coil_inner_radius_mm", half of the diameter'),
                            ("magnet_diameter=6", '"magnet_radius_mm", half of the diameter'),
                            ("wire_radius_mm=0.2", '"wire_diameter_mm", twice the radius')):
            self.assert_refused([*evaluate, said], f"{said}: is not a number of a design; did you mean {meant}?")
        self.assertEqual(run(*evaluate, "magnet_radius_mm=3", cwd=self.folder).returncode, 0)
        self.write("pair.json", json.dumps({"bodies": [{"magnet": {"diameter_mm": 8, "length_mm": 6, "remanence_T": 1.3}}]}))
        self.assertIn('did you mean "radius_mm", half of the diameter?', run("field", "pair.json", "--at", "0", "0", "9",
                                                                             cwd=self.folder).stderr)

    def test_an_unknown_option_is_named_before_a_missing_one(self):
        self.assert_refused(["size", "x.json", "--otu", "y"],
                            'size: unknown option "--otu"; did you mean "--out"? (see coilwright size --help)')
        self.assert_refused(["rig", "camera", "--fidelty", "exact"], 'rig camera: unknown option "--fidelty"; did you '
                            'mean "--fidelity"? (see coilwright rig camera --help)')

    def test_an_option_that_wants_a_whole_number_says_so(self):
        for command, option, text, rule in (
            ("reach x.json --angle-deg 3", "--pieces", "2.5", "a whole number"),
            ("reach x.json --angle-deg 3", "--pieces", "7", "from 1 to 6"),
            ("size x.json --out y", "--threads", "1.5", "a whole number"),
            ("size x.json --out y", "--threads", "1025", "from 0 to 1024"),
            ("size x.json --out y", "--seed", "0.5", "a whole number"),
            ("size x.json --out y", "--max-evaluations", "many", "a whole number"),
            ("pareto x.json --out y", "--max-evaluations", "0", "from 1 to 1000000000"),
            ("diagnose x --out y", "--seed", "-1", "from 0 to 9007199254740992"),
            ("twin x.json --experiment y --out z", "--seed", "1e-3", "a whole number"),
            ("drive x.json", "--actuators", "1.5", "a whole number"),
            ("crawl x.json", "--periods", "010.5", "a whole number"),
            ("crawl x.json", "--settling-periods", "1e5", "from 0 to 10000"),
            ("rig stiffness-gauge x.json --out y", "--joint", "1.5", "a whole number"),
        ):
            name = " ".join(word for word in command.split()[:2] if not word.startswith("x"))
            self.assert_refused([*command.split(), option + "=" + text],
                                f'{name}: {option}: must be {rule}; got "{text}" (see coilwright {name} --help)')

    def test_what_was_written_can_be_had_as_json(self):
        for command, files in (
            (["export", PAPER_FINGER, "--as", "drawing", "--out", "drawing"], ["drawing/drawing.svg", "drawing/drawing.dxf"]),
            (["simulate", PAPER_FINGER, "--step-A", "1.4", "--out", "step.csv"], ["step.csv"]),
            (["schema", "study", "--out", "schemas"], None),
            (["size", "study.json", "--out", "out"], False),
            (["archive", "csv", "out", "--out", "designs.csv"], ["designs.csv"]),
            (["archive", "pick", "out", "--row", "1", "--out", "one.json"], ["one.json"]),
        ):
            with self.subTest(" ".join(map(str, command))):
                write_study(self, search={"max_evaluations": 20})
                done = run(*command, "--json", cwd=self.folder)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                answer = json.loads(done.stdout)
                if files is not False:
                    self.assertEqual(answer["files"], files or answer["files"])
                    self.assertGreater(len(answer["files"]), 0)
                    for name in answer["files"]:
                        self.assertTrue((self.folder / name).is_file(), name)
        motion = json.loads(run("simulate", PAPER_FINGER, "--step-A", "1.4", "--out", "step.csv", "--json", cwd=self.folder).stdout)
        rows = self.table("step.csv")
        self.assertEqual((motion["samples"], motion["last_bending_angle_deg"]), (len(rows), float(rows[-1]["bending_angle_deg"])))
        self.assertEqual(motion["greatest_bending_speed_deg_s"], max(abs(float(row["bending_speed_deg_s"])) for row in rows))
        designs = json.loads(run("archive", "csv", "out", "--json", cwd=self.folder).stdout)
        self.assertEqual(designs, json.loads(run("archive", "filter", "out", "--where", "1", "--json", cwd=self.folder).stdout))
        self.assertEqual(json.loads(run("archive", "pick", "out", "--row", "1", "--out", "-", "--json", cwd=self.folder).stdout),
                         self.result("one.json"))
        result = run("simulate", PAPER_FINGER, "--step-A", "1.4", "--out", "-", "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(json.loads(result.stderr)["error"]["message"], "simulate: --json: needs a file for --out: standard output has "
                                                                       "the result itself (see coilwright simulate --help)")

    def test_every_command_that_answers_can_answer_in_json(self):
        text = run("--help").stdout
        commands = [line.split()[0] for line in text.splitlines() if line.startswith("  ") and line[2:3].islower()]
        self.assertGreater(len(commands), 20)
        for command in commands:
            further = {"archive": ["list", "filter", "top", "csv", "pick", "replay"],
                       "rig": ["torque-bench", "stiffness-gauge", "grasp-bench", "camera"]}.get(command, [None])
            for each in further:
                words = [command] + ([each] if each else [])
                # What these print is for a terminal, a shell or man, and has a form of its own.
                if command not in ("help", "man", "completion"):
                    self.assertIn("--json", run(*words, "--help").stdout, " ".join(words))

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
        for arguments in (["--help"], ["-h"], ["force", "--help"], ["--version"], ["-V"], ["version"], ["help"]):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stderr), (0, ""), arguments)

    def test_the_version_names_commit_compiler_and_libraries(self):
        text = run("--version").stdout
        self.assertRegex(text, r"^coilwright \d+\.\d+\.\d+\n"
                         r"(Commit [0-9a-f]{40}(, changed since)?|Commit unknown: built outside of its git repository)\.\n"
                         r"Built by \w+ [\d.]+ with NLopt [\d.]+, .*Boost [\d.]+.*Ceres [\d.]+.*\.\n$")
        self.assertNotIn("unknown,", text)
        self.assertEqual([run("-V").stdout, run("version").stdout], [text, text])
        told = json.loads(run("version", "--json").stdout)
        self.assertEqual(text.split("\n")[0], f"{told['program']} {told['version']}")
        self.assertIn(f"Commit {told['commit'] or 'unknown'}", text)
        for library, version in told["libraries"].items():
            self.assertIn(f"{library} {version}", text)

    def test_help_explains_a_command(self):
        self.assertEqual(run("help").stdout, run("--help").stdout)
        self.assertEqual(run("help", "size").stdout, run("size", "--help").stdout)
        self.assertEqual(run("help", "rig", "camera").stdout, run("rig", "camera", "--help").stdout)
        self.assert_refused(["help", "siez"], 'help: unknown command "siez"; did you mean "size"? (see coilwright help '
                            '--help)')
        self.assert_refused(["help", "rig", "cam"], 'help: unknown command "cam"; did you mean "camera"? (see '
                            'coilwright help --help)')

    def test_the_help_of_every_command_shows_an_example(self):
        text = run("--help").stdout
        commands = [line.split()[0] for line in text.split("Subcommands:\n")[1].split("\n\n")[0].splitlines()]
        self.assertIn("force", commands)
        for command in commands:
            self.assertIn(f"coilwright {command}", run(command, "--help").stdout.split("Example")[1])

    def test_a_command_whose_program_is_not_there_says_how_to_get_it(self):
        alone = self.folder / "coilwright"
        shutil.copy(PROGRAM, alone)
        for arguments, program in ((["size", "study.json", "--out", "out"], "search"), (["help", "diagnose"], "records"),
                                   (["init", "dataset", "--from", "x.csv"], "records"), (["man", "--out", "man"], "model")):
            result = subprocess.run([alone, *arguments], cwd=self.folder, capture_output=True, encoding="utf-8", check=False)
            self.assertEqual(result.stderr, f"coilwright: {self.folder.resolve()}/coilwright-{program} is not there: it has this "
                             f"command. Build it (cmake --build --preset release --target coilwright-{program}), or install "
                             "all of Coilwright\n")
            self.assertEqual((result.returncode, result.stdout), (1, ""))
        started = subprocess.run([alone, "init", "study", "--out", "start"], cwd=self.folder, capture_output=True, check=False)
        self.assertEqual(started.returncode, 0)

    def test_any_program_finds_the_commands_of_the_others(self):
        for program in ("search", "page"):
            result = subprocess.run([f"{PROGRAM}-{program}", "help", "plan"], capture_output=True, encoding="utf-8", check=True)
            self.assertEqual(result.stdout, run("plan", "--help").stdout)

    def test_results_that_cannot_be_printed_are_a_failure(self):
        self.write("pair.json", '{"magnets": [{"radius_mm": 4, "length_mm": 6, "remanence_T": 1.3},'
                                '{"radius_mm": 5, "length_mm": 3, "remanence_T": 1.1}],'
                                '"poses": [{"position_mm": [0.5, 0, 14], "axis": [0, 0.1, 1]}]}')
        with open("/dev/full", "w") as full:
            result = run("force", "pair.json", cwd=self.folder, stdout=full)
        self.assertEqual((result.returncode, result.stderr), (1, "coilwright: standard output cannot be written\n"))

    def run_as_nobody(self, *arguments, **options):
        self.folder.chmod(0o755)
        try:
            result = subprocess.run([PROGRAM, *map(str, arguments)], cwd=self.folder, user="nobody", capture_output=True,
                                    encoding="utf-8", timeout=HANGS, check=False, **options)
        except PermissionError:
            self.skipTest("the program lies where others may not go")
        self.assertEqual(result.stdout, "")
        return result.returncode, result.stderr

    @unittest.skipUnless(os.geteuid() == 0, "only the superuser can become one who may not read")
    def test_a_folder_that_cannot_be_looked_into_is_bad_input(self):
        (self.folder / "closed").mkdir(mode=0)
        self.assertEqual(self.run_as_nobody("archive", "list", "closed"),
                         (2, "coilwright: closed/archive.sqlite: cannot be read: Permission denied\n"))
        self.assertEqual(self.run_as_nobody("init", "study", "--out", "closed"),
                         (2, "coilwright: closed/actuator.json: cannot be looked at: Permission denied\n"))
        code, error = self.run_as_nobody("report", "closed")
        self.assertEqual(code, 2)
        self.assertRegex(error, r"^coilwright: closed[^\n]*\n$")

    @unittest.skipUnless(os.geteuid() == 0, "only the superuser can become one who has no other process")
    def test_a_limit_of_threads_is_told_as_one(self):
        self.write("finger.json", PAPER_FINGER.read_bytes())
        self.assertEqual(self.run_as_nobody("simulate", "finger.json", "--step-A", "1", "--out", "-",
                                            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NPROC, (1, 1))),
                         (1, "coilwright: no further thread can be started: the limit of processes (ulimit -u) or of memory "
                             "is reached\n"))


if __name__ == "__main__":
    unittest.main()
