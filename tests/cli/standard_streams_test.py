"""- for standard input and output, and errors as JSON where JSON is asked for."""

import json
import os
import resource
import subprocess
import unittest

from program import CONFIGS, HANGS, PAPER_FINGER, PROGRAM, ProgramTest, run
from study import write_study


def feed(text, *arguments, cwd=None):
    return subprocess.run([PROGRAM, *map(str, arguments)], input=text, cwd=cwd, capture_output=True, encoding="utf-8",
                          timeout=HANGS, check=False)


class StandardInput(ProgramTest):
    def test_it_is_the_file_of_a_command(self):
        finger = PAPER_FINGER.read_text()
        arguments = ["--current-A", "1", "--json"]
        self.assertEqual(feed(finger, "evaluate", "-", *arguments).stdout,
                         run("evaluate", PAPER_FINGER, *arguments).stdout)
        changed = feed(finger, "evaluate", "-", "--set", "gap_mm=1.1", *arguments)
        self.assertEqual(changed.returncode, 0)
        self.assertEqual(changed.stdout, run("evaluate", PAPER_FINGER, "--set", "gap_mm=1.1", *arguments).stdout)

    def test_its_errors_name_it(self):
        result = feed('{"format": "actuator/1", "configuraton": "B"}', "evaluate", "-", "--current-A", "1")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertTrue(result.stderr.startswith("coilwright: standard input: "), result.stderr)
        result = feed("", "evaluate", "-", "--current-A", "1")
        self.assertEqual((result.returncode, result.stdout), (2, ""))

    def test_a_study_s_actuator_counts_from_where_the_command_runs(self):
        write_study(self)
        study = (self.folder / "study.json").read_text()
        result = feed(study, "size", "-", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        piped = self.result("out/result.json")
        self.assertEqual(self.result("out/provenance.json")["inputs"][0]["file"], "standard input")
        run("size", "study.json", "--out", "out", "--force", cwd=self.folder)
        self.assertEqual(self.result("out/result.json"), piped)

    def test_an_input_of_samples_may_come_from_it(self):
        samples = "time_ms,current_A\n# a step\n0,0\n10,1.2\n50,1.2\n"
        self.write("input.csv", "time_s,current_A\n0,0\n0.01,1.2\n0.05,1.2\n")
        piped = feed(samples, "simulate", PAPER_FINGER, "--input", "-", "--out", "a.csv", cwd=self.folder)
        self.assertEqual((piped.returncode, piped.stderr), (0, ""))
        run("simulate", PAPER_FINGER, "--input", "input.csv", "--out", "b.csv", cwd=self.folder)
        self.assertEqual(self.table("a.csv"), self.table("b.csv"))

    def test_what_is_read_twice_must_be_a_file(self):
        for command, option in (
                (["twin", "-", "--experiment", "x.json", "--out", "y"], "ACTUATOR.json"),
                (["twin", "x.json", "--experiment", "-", "--out", "y"], "--experiment"),
                (["rig", "camera", "-", "--out", "y"], "ACTUATOR.json"),
                (["diagnose", "x", "--actuator", "-", "--out", "y"], "--actuator")):
            name = "rig camera" if command[0] == "rig" else command[0]
            self.assert_refused(command, f'{name}: {option}: must be a file, which is read twice; got "-", standard '
                                f'input (see coilwright {name} --help)')


class StandardOutput(ProgramTest):
    def test_it_gets_the_bytes_of_the_file(self):
        for command in (["simulate", PAPER_FINGER, "--step-A", "1.2"],
                        ["linearise", PAPER_FINGER, "--current-A", "1"],
                        ["drive", PAPER_FINGER, "--mean-A", "1", "--motion-s", "0.1"]):
            with self.subTest(command[0]):
                to_file = run(*command, "--out", f"of_{command[0]}", cwd=self.folder)
                self.assertEqual(to_file.returncode, 0, to_file.stderr)
                piped = run(*command, "--out", "-", cwd=self.folder)
                self.assertEqual((piped.returncode, piped.stdout), (0, (self.folder / f"of_{command[0]}").read_text()))
                # What was printed before is still told.
                self.assertEqual(piped.stderr.replace(to_file.stderr, ""), to_file.stdout)
        self.assertEqual(sorted(self.files()), ["of_drive", "of_linearise", "of_simulate"])

    def test_nothing_is_left_where_nobody_reads_it(self):
        with subprocess.Popen([PROGRAM, "simulate", PAPER_FINGER, "--step-A", "1.2", "--out", "-"], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, env={**os.environ, "TMPDIR": str(self.folder)}) as process:
            process.stdout.close()
            process.stdout = None
            process.communicate(timeout=HANGS)
        self.assertNotEqual(process.returncode, 0)
        self.assertEqual(self.files(), {})

    def test_nothing_comes_out_of_a_command_that_fails(self):
        result = run("simulate", PAPER_FINGER, "--step-A", "1.2", "--duration-s", "1e9", "--out", "-")
        self.assertNotEqual(result.returncode, 0)
        self.assertEqual(result.stdout, "")

    def test_a_folder_cannot_be_it(self):
        write_study(self)
        self.assert_refused(["size", "study.json", "--out", "-"],
                            "-: cannot be written: it must be a folder, and - is standard output")


class SizeLimit(ProgramTest):
    def test_a_file_that_may_not_grow_is_a_line_and_leaves_nothing(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))

        result = subprocess.run([PROGRAM, "simulate", PAPER_FINGER, "--step-A", "1", "--out", "step.csv"], cwd=self.folder,
                                capture_output=True, encoding="utf-8", timeout=HANGS, check=False, preexec_fn=limit)
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertEqual(result.stderr, "coilwright: step.csv: cannot be written: File too large\n")
        self.assertEqual(list(self.files()), [])


class JsonErrors(ProgramTest):
    def error(self, *arguments):
        result = run(*arguments, cwd=self.folder)
        self.assertEqual(result.stdout, "")
        told = json.loads(result.stderr)["error"]
        self.assertEqual(told["exit_code"], result.returncode)
        return told

    def test_a_mistake_in_a_file_comes_apart(self):
        self.write("finger.json", PAPER_FINGER.read_text().replace('"gap_mm": 0.9', '"gap_mm": -1'))
        arguments = ["evaluate", "finger.json", "--current-A", "1"]
        told = self.error(*arguments, "--json")
        self.assertEqual(told, {"exit_code": 2, "message": "finger.json: /body/gap_mm: must be from 0.05 to 1000; got -1",
                                "file": "finger.json", "place": "/body/gap_mm", "rule": "must be from 0.05 to 1000",
                                "value": "-1"})
        self.assert_refused(arguments, told["message"])

    def test_so_do_mistakes_in_the_usage_and_in_places_to_write(self):
        told = self.error("evaluate", "x.json", "--curent", "1", "--json")
        self.assertEqual((told["exit_code"], told["file"]), (2, None))
        self.assertEqual(told["message"], 'evaluate: unknown option "--curent"; did you mean "--current"? '
                         '(see coilwright evaluate --help)')
        self.assertIn("unknown command", self.error("evalute", "--json")["message"])
        write_study(self)
        self.write("out", "a file")
        self.assertIn("out: cannot be written: ", self.error("size", "study.json", "--out", "out", "--json")["message"])


if __name__ == "__main__":
    unittest.main()
