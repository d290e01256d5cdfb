"""The archive of a run of size, sweep or pareto: when a folder is taken, gone on with or refused; signals, full disks, reuse."""

import contextlib
import os
import random
import resource
import shutil
import signal
import sqlite3
import subprocess
import time
import unittest

from archived_runs import ARCHIVE, designs_of, end, forge, results_of, start, stop_with_designs
from program import HANGS, PROGRAM, ProgramTest, run
from study import FRONT, GRID, write_study

OTHERS = "other_choices"
ENDLESS = {"max_evaluations": 1000000, "algorithm": "isres"}


class ArchivedStudy(ProgramTest):
    def run_well(self, command, *arguments, out="out", study="study.json"):
        result = run(command, study, "--out", out, *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def runs(self, out="out"):
        """evaluated, answered, reused of each run."""
        with contextlib.closing(sqlite3.connect(self.folder / out / ARCHIVE)) as database:
            return database.execute("SELECT evaluated, answered, reused FROM runs").fetchall()

    def change(self, sql, out="out"):
        forge(self.folder / out, sql)

    def begun(self, command="pareto", out="out", designs=5, **changes):
        """A run with designs recorded, stopped on its way."""
        write_study(self, **{"objectives": FRONT, "search": ENDLESS, **changes})
        process = start(command, "study.json", "--out", out, cwd=self.folder)
        self.addCleanup(end, process)
        stop_with_designs(self, process, self.folder / out, designs)
        return process

    def killed(self, **options):
        process = self.begun(**options)
        process.kill()
        process.communicate(timeout=HANGS)


class Folders(ArchivedStudy):
    def test_the_same_command_again_is_answered_from_the_archive(self):
        for command, changes in (("size", {}), ("pareto", {"objectives": FRONT}), ("sweep", {"variables": GRID})):
            with self.subTest(command):
                write_study(self, **changes)
                first = self.run_well(command, out=command)
                results = results_of(self.folder / command)
                self.assertEqual(self.run_well(command, "--threads", "1", out=command), first)
                self.assertEqual(results_of(self.folder / command), results)
                (made, _, _), (again, known, _) = self.runs(command)
                self.assertEqual((again, known), (0, made))
                self.assertEqual(len(designs_of(self.folder / command)), made)

    def test_what_is_looked_at_under_other_modelling_choices_is_gone_on_with_too(self):
        write_study(self, search={"max_evaluations": 40, "seed": 5})
        whole = self.run_well("size", out="whole")
        every = designs_of(self.folder / "whole", OTHERS)
        self.assertGreater(len(every), 100)
        process = start("size", "study.json", "--out", "out", cwd=self.folder)
        self.addCleanup(end, process)
        stop_with_designs(self, process, self.folder / "out", len(every) // 2, OTHERS)
        process.kill()
        process.communicate(timeout=HANGS)
        recorded = designs_of(self.folder / "out", OTHERS)
        self.assertEqual(self.run_well("size", "--resume"), whole)
        self.assertEqual(results_of(self.folder / "out"), results_of(self.folder / "whole"))
        now = designs_of(self.folder / "out", OTHERS)
        self.assertEqual(now[:len(recorded)], recorded)
        self.assertEqual(len(now), len(every))
        # A larger budget goes on from both.
        before = len(designs_of(self.folder / "out"))
        larger = self.run_well("size", "--resume", "--max-evaluations", "60")
        self.assertEqual(larger, self.run_well("size", "--max-evaluations", "60", out="larger"))
        for table, known in (("designs", before), (OTHERS, len(every))):
            evaluated = len(designs_of(self.folder / "larger", table))
            self.assertLess(len(designs_of(self.folder / "out", table)) - known, evaluated * 2 / 3, table)

    def test_resume_in_a_new_folder_begins(self):
        write_study(self, search={"max_evaluations": 20})
        self.run_well("size", "--resume")
        self.assertTrue((self.folder / "out/actuator.json").exists())

    def test_a_run_that_has_not_ended_wants_resume_or_force(self):
        self.killed()
        count = len(designs_of(self.folder / "out"))
        before = designs_of(self.folder / "out")
        result = run("pareto", "study.json", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, f"coilwright: out: holds a run of this study that has not ended ({count} designs "
                                        "recorded): --resume goes on with it, --force starts anew\n")
        self.assertEqual(designs_of(self.folder / "out"), before)

    def leave_half_changed(self, out="out"):
        """As a kill leaves the archive in the middle of a change that the write-ahead log does not take."""
        archive = self.folder / out / ARCHIVE
        with contextlib.closing(sqlite3.connect(archive, isolation_level=None)) as database:
            for line in ("PRAGMA journal_mode = DELETE", "PRAGMA cache_size = 1", "BEGIN", "UPDATE designs SET mass_g = -1"):
                database.execute(line)
            left = {path: path.read_bytes() for path in archive.parent.glob(ARCHIVE + "*")}
            database.execute("ROLLBACK")
        for path, content in left.items():
            path.write_bytes(content)
        self.assertEqual(sorted(path.name for path in left), [ARCHIVE, ARCHIVE + "-journal"])
        return archive

    def test_what_a_kill_left_half_changed_is_taken_back(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 300, "seed": 5})
        answer = self.run_well("pareto")
        recorded = designs_of(self.folder / "out")
        for option in ("--resume", "--force"):
            with self.subTest(option):
                self.leave_half_changed()
                self.assertEqual(self.run_well("pareto", option), answer)
                self.assertEqual(len(designs_of(self.folder / "out")), len(recorded))
                self.assertNotIn(-1, [value for row in designs_of(self.folder / "out") for value in row])
        self.leave_half_changed()
        self.run_well("pareto", "--reuse", "out", out="reused")

    @unittest.skipUnless(os.geteuid() == 0, "only the superuser can become one who may not write")
    def test_what_a_kill_left_half_changed_needs_a_folder_that_may_be_written(self):
        write_study(self, search={"max_evaluations": 300})
        self.run_well("size")
        archive = self.leave_half_changed()
        for path in (self.folder, archive.parent):
            path.chmod(0o755)
        try:
            result = subprocess.run([PROGRAM, "archive", "list", "out"], cwd=self.folder, user="nobody", capture_output=True,
                                    encoding="utf-8", timeout=HANGS, check=False)
        except PermissionError:
            self.skipTest("the program lies where others may not go")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertEqual(result.stderr, "coilwright: out/archive.sqlite: was left half-changed by a run that was killed, and "
                                        "is put right only where it may be written: copy it there with "
                                        "archive.sqlite-journal\n")
        self.assertNotIn(-1, [value for row in designs_of(self.folder / "out") for value in row])

    def test_another_run_s_archive_is_refused_and_says_what_differs(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 20, "seed": 5})
        self.run_well("pareto")
        tail = "): --force replaces it, another --out keeps it"
        head = "out: holds the archive of another run ("
        reusable = tail + ", and --reuse out takes its designs over"
        for option in ([], ["--resume"]):
            self.assert_refused(["pareto", "study.json", "--out", "out", "--seed", "6", *option],
                                head + "seed 5, not seed 6" + reusable)
        self.assert_refused(["pareto", "study.json", "--out", "out", "--algorithm", "cobyla"],
                            head + "algorithm automatic, not cobyla" + reusable)
        self.assert_refused(["pareto", "study.json", "--out", "out", "--set", "front_length_mm=9"],
                            head + "no --set, not --set front_length_mm=9" + tail)
        self.write("finger.json", (self.folder / "finger.json").read_text() + "\n")
        result = run("pareto", "study.json", "--out", "out", cwd=self.folder)
        self.assertRegex(result.stderr, r"^coilwright: out: holds the archive of another run \(finger\.json with another "
                                        r"content \(SHA-256 [0-9a-f]{8}, not [0-9a-f]{8}\)\): --force replaces it, ")
        write_study(self, search={"max_evaluations": 20, "seed": 5})
        result = run("size", "study.json", "--out", "out", cwd=self.folder)
        self.assertIn("(command pareto, not size; study.json with another content", result.stderr)

    def test_another_program_s_designs_are_gone_on_with_where_three_feasible_ones_are_the_same(self):
        write_study(self, variables=GRID)
        answer = self.run_well("sweep")
        self.change("UPDATE study SET version = '0.0.9', commit_hash = 'abcdef0123', build_sha256 = ''")
        with contextlib.closing(sqlite3.connect(self.folder / "out" / ARCHIVE)) as database:
            rows = [row for (row,) in database.execute("SELECT id FROM designs WHERE status = 'ok' ORDER BY id")]
        first, middle, last = rows[0], rows[(len(rows) - 1) // 2], rows[-1]
        same = (rf"^coilwright: out: holds a run of this study by coilwright 0\.0\.9 \(commit abcdef0\), whose rows {first}, "
                rf"{middle} and {last} have the same numbers by 0\.1\.0 \(commit .*\): ")
        result = run("sweep", "study.json", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertRegex(result.stderr, same + r"--resume goes on with its designs, --force starts anew\n$")
        result = run("sweep", "study.json", "--out", "out", "--resume", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (0, answer))
        self.assertRegex(result.stderr, same + r"the run goes on with its designs\n$")
        self.assertEqual(self.runs()[-1][0], 0)
        self.change(f"UPDATE designs SET mass_g = mass_g + 1e-9 WHERE id = {middle}")
        result = run("sweep", "study.json", "--out", "out", "--resume", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertRegex(result.stderr, r"\(coilwright 0\.0\.9 \(commit abcdef0\), not 0\.1\.0 \(commit .*\), whose numbers "
                                        rf"may differ; row {middle} has other numbers now\): --force replaces it")

    def test_numbers_that_this_machine_does_not_give_are_refused(self):
        write_study(self, search={"max_evaluations": 20})
        self.run_well("size")
        self.change("UPDATE designs SET mass_g = mass_g + 1e-9 WHERE id = 1")
        self.assert_refused(["size", "study.json", "--out", "out"],
                            "out/archive.sqlite: the design of row 1 gives other numbers on this machine than were "
                            "recorded: --force starts anew")

    def test_a_sweep_that_goes_on_never_writes_other_results_wherever_a_byte_of_its_archive_was_changed(self):
        write_study(self, variables=GRID)
        self.run_well("sweep")
        archive, results = self.folder / "out" / ARCHIVE, results_of(self.folder / "out")
        whole, draw, refused = archive.read_bytes(), random.Random(17), 0
        for _ in range(25):
            damaged = bytearray(whole)
            place = draw.randrange(len(whole))
            damaged[place] ^= draw.randrange(1, 256)
            archive.write_bytes(damaged)
            result = run("sweep", "study.json", "--out", "out", "--resume", "--quiet", cwd=self.folder)
            self.assertIn(result.returncode, (0, 2), (place, result.stderr))
            if result.returncode:
                self.assertEqual(len(result.stderr.splitlines()), 1)
                self.assertIn("out/archive.sqlite: ", result.stderr)
                refused += 1
            self.assertEqual(results_of(self.folder / "out"), results, place)
        self.assertGreater(refused, 5)

    def test_damaged_designs_are_evaluated_anew_and_mended_or_taken_out(self):
        write_study(self, variables=GRID)
        answer = self.run_well("sweep")
        results = results_of(self.folder / "out")
        with contextlib.closing(sqlite3.connect(self.folder / "out" / ARCHIVE)) as database, database:
            database.execute("UPDATE designs SET mass_g = mass_g + 1e-9 WHERE id IN (3, 8)")
            database.execute("UPDATE designs SET gap_mm = gap_mm + 0.2 WHERE id = 5")
        damaged = ("out/archive.sqlite: is damaged (row 3 of designs is not what was written, nor are 2 more): coilwright "
                   "archive check DIR --repair evaluates such designs anew, or the command that made it makes it anew "
                   "with --force")
        for command in (["sweep", "study.json", "--out", "out", "--resume"], ["archive", "check", "out"],
                        ["archive", "top", "out", "--most", "mass_g"]):
            self.assert_refused(command, damaged)
        repaired = run("archive", "check", "out", "--repair", cwd=self.folder)
        self.assertEqual((repaired.returncode, repaired.stderr), (0, ""))
        self.assertEqual(repaired.stdout.splitlines()[1], "Damaged designs evaluated anew: 2 are as they were written again, 1 "
                                                          "were taken out (rows 5; --resume evaluates them).")
        self.assertEqual(self.run_well("sweep", "--resume"), answer)
        self.assertEqual(results_of(self.folder / "out"), results)
        self.assertEqual(self.runs()[-1][0], 1)

    def test_designs_that_are_gone_are_missed_and_evaluated_again(self):
        write_study(self, variables=GRID)
        answer = self.run_well("sweep")
        results = results_of(self.folder / "out")
        with contextlib.closing(sqlite3.connect(self.folder / "out" / ARCHIVE)) as database, database:
            database.execute("DELETE FROM designs WHERE id > 20")
        result = run("archive", "check", "out", cwd=self.folder)
        self.assertRegex(result.stderr, r"^coilwright: out/archive\.sqlite: is damaged \(designs has 20 rows, and \d+ were written\): "
                                        r"coilwright archive check DIR --repair ")
        repaired = run("archive", "check", "out", "--repair", cwd=self.folder)
        self.assertRegex(repaired.stdout, r"\n\d+ designs that were written are gone; --resume evaluates them\.\n$")
        self.assertEqual(self.run_well("sweep", "--resume"), answer)
        self.assertEqual(results_of(self.folder / "out"), results)

    def test_a_repair_that_is_interrupted_keeps_what_it_has_mended(self):
        write_study(self, search={"max_evaluations": 200, "seed": 5})
        answer = self.run_well("size", "--answer-only")
        whole = designs_of(self.folder / "out")
        with contextlib.closing(sqlite3.connect(self.folder / "out" / ARCHIVE)) as database, database:
            database.execute("UPDATE designs SET mass_g = -1")
        process = start("archive", "check", "out", "--repair", cwd=self.folder)
        self.addCleanup(end, process)
        mended = 0
        deadline = time.monotonic() + HANGS
        process.send_signal(signal.SIGSTOP)
        while mended == 0:
            self.assertLess(time.monotonic(), deadline)
            process.send_signal(signal.SIGCONT)
            time.sleep(0.005)
            process.send_signal(signal.SIGSTOP)
            mended = sum(row in whole for row in designs_of(self.folder / "out"))
        process.send_signal(signal.SIGINT)
        process.send_signal(signal.SIGCONT)
        output, errors = process.communicate(timeout=HANGS)
        mended = sum(row in whole for row in designs_of(self.folder / "out"))
        self.assertEqual((process.returncode, errors),
                         (130, f"coilwright: interrupted: {len(whole) - mended} damaged designs are left; the same command goes on\n"))
        self.assertGreater(mended, 0)
        self.assertEqual(output, f"Damaged designs evaluated anew: {mended} are as they were written again, 0 were taken out.\n")
        again = run("archive", "check", "out", "--repair", cwd=self.folder)
        self.assertIn(f"Damaged designs evaluated anew: {len(whole) - mended} are as they were written again, 0 were", again.stdout)
        self.assertEqual(designs_of(self.folder / "out"), whole)
        self.assertEqual(self.run_well("size", "--answer-only"), answer)

    def test_a_budget_that_was_changed_in_the_study_is_told_by_its_option(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 40, "seed": 5})
        self.run_well("pareto")
        write_study(self, objectives=FRONT, search={"max_evaluations": 90, "seed": 5})
        for option in ([], ["--resume"]):
            self.assert_refused(["pareto", "study.json", "--out", "out", *option],
                                "study.json: has another max_evaluations than when the run in out began, and is else the "
                                "same: put it back as it was, and give --max-evaluations 90 --resume")
        write_study(self, objectives=FRONT, search={"max_evaluations": 90, "seed": 6})
        self.assertIn("holds the archive of another run", run("pareto", "study.json", "--out", "out", "--resume",
                                                              cwd=self.folder).stderr)

    def test_a_larger_budget_goes_on_and_ends_as_if_it_had_been_so_from_the_start(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 40, "seed": 5})
        self.run_well("pareto")
        recorded = len(designs_of(self.folder / "out"))
        self.assert_refused(["pareto", "study.json", "--out", "out", "--max-evaluations", "90"],
                            f"out: holds a run of this study with max_evaluations 40, not 90: --resume goes on from its "
                            f"{recorded} designs, --force starts anew")
        resumed = self.run_well("pareto", "--max-evaluations", "90", "--resume")
        self.assertEqual(resumed, self.run_well("pareto", "--max-evaluations", "90", out="whole"))
        self.assertEqual(results_of(self.folder / "out"), results_of(self.folder / "whole"))
        evaluated, known, _ = self.runs()[1]
        self.assertGreater(known, 0)
        self.assertEqual(evaluated + known, 90)

    def test_results_without_an_archive_are_refused_and_replaced_by_force(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 20})
        self.run_well("pareto")
        (self.folder / "out" / ARCHIVE).unlink()
        write_study(self, search={"max_evaluations": 20})
        for option in ([], ["--resume"]):
            self.assert_refused(["size", "study.json", "--out", "out", *option],
                                "out: holds results without an archive: --force replaces them, another --out keeps them")
        self.write("out/notes.txt", "mine")
        self.run_well("size", "--force")
        names = sorted(path.name for path in (self.folder / "out").iterdir())
        self.assertEqual(names, ["actuator.json", ARCHIVE, "convergence.csv", "evaluations.csv", "notes.txt",
                                 "provenance.json", "result.json"])

    def test_what_a_killed_run_had_not_finished_is_cleared_away(self):
        self.killed(command="sweep", variables={"gap_mm": {"lower": 0.7, "upper": 1.6, "step": 1e-6}}, search={})
        self.assertEqual(len(list((self.folder / "out").glob(".designs.csv.part-*"))), 1)
        self.write("out/.trial.part-4711", "")  # a kill at the moment when the folder is tried
        write_study(self, variables=GRID)
        self.run_well("sweep", "--force")
        self.assertEqual(list((self.folder / "out").glob(".*")), [])

    def test_a_folder_in_use_is_refused(self):
        process = self.begun()
        process.send_signal(signal.SIGCONT)
        for option in ("--resume", "--force"):
            result = run("pareto", "study.json", "--out", "out", option, cwd=self.folder)
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertEqual(result.stderr, "coilwright: out: cannot be written: another run of coilwright is writing to it; "
                                            "wait for its end, or give another --out\n")
        self.assertIsNone(process.poll())
        # It may be looked at, though.
        result = run("archive", "top", "out", "--least", "mass_g", "--count", "1", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_no_result_takes_the_place_of_what_the_study_is_made_of(self):
        write_study(self, actuator="actuator.json", search={"max_evaluations": 20})
        (self.folder / "finger.json").rename(self.folder / "actuator.json")
        for option in ([], ["--force"]):
            self.assert_refused(["size", "study.json", "--out", ".", *option],
                                "./actuator.json: cannot be written: it is an input of this command")

    def test_files_that_are_no_archive_or_of_a_later_version_are_left_alone(self):
        write_study(self, search={"max_evaluations": 20})
        self.run_well("size")
        self.change("PRAGMA user_version = 4")
        self.assert_refused(["size", "study.json", "--out", "out", "--resume"],
                            "out/archive.sqlite: was written by a later coilwright: it is an archive of version 4, and "
                            "this program reads up to version 3")
        self.write("out/" + ARCHIVE, "notes")
        self.assert_refused(["size", "study.json", "--out", "out"],
                            "out/archive.sqlite: is no archive of a study, or a torn one: file is not a database; the command that "
                            "made it makes it anew with --force")

    def test_files_in_the_place_of_its_logs_are_left_alone(self):
        write_study(self, search={"max_evaluations": 20})
        for suffix in ("-wal", "-shm", "-journal"):
            shutil.rmtree(self.folder / "out", ignore_errors=True)
            log = f"out/{ARCHIVE}{suffix}"
            rule = f"{log}: stands where a log of {ARCHIVE} goes, and is none of an archive here: move it away"
            (self.folder / "out").mkdir()
            self.write(log, "mine")
            for option in ([], ["--force"]):
                self.assert_refused(["size", "study.json", "--out", "out", *option], rule)
            (self.folder / log).unlink()
            self.run_well("size")
            self.write(log, "mine")
            for option in ([], ["--resume"], ["--force"]):
                self.assert_refused(["size", "study.json", "--out", "out", *option], rule)

    def test_resume_and_force_exclude_each_other(self):
        write_study(self)
        result = run("size", "study.json", "--out", "out", "--resume", "--force", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertFalse((self.folder / "out").exists())


class Signals(ArchivedStudy):
    def test_a_signal_ends_the_run_well_and_resume_goes_on(self):
        # No shell between: a terminal that closes sends SIGHUP to the program itself.
        study = {"objectives": FRONT, "search": {"max_evaluations": 400, "seed": 5}}
        write_study(self, **study)
        whole = self.run_well("pareto", out="whole")
        for sent in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(sent.name):
                out = sent.name
                process = self.begun(out=out, **study)
                process.send_signal(sent)
                process.send_signal(signal.SIGCONT)
                if sent != signal.SIGINT:  # `timeout` and shells send another one soon
                    time.sleep(0.002)
                    process.send_signal(sent)
                output, errors = process.communicate(timeout=HANGS)
                self.assertEqual((process.returncode, errors),
                                 (130, f"coilwright: interrupted: what was evaluated is in {out}/archive.sqlite; --resume "
                                       "goes on from there\n"))
                self.assertIn("it was interrupted", output)
                recorded = len(designs_of(self.folder / out))
                self.assertEqual(recorded, len(self.table(f"{out}/evaluations.csv")))
                self.assertEqual(self.run_well("pareto", "--resume", out=out), whole)
                self.assertEqual(results_of(self.folder / out), results_of(self.folder / "whole"))
                self.assertEqual(self.runs(out)[1][1], recorded)


class Disks(ArchivedStudy):
    def mounted(self, options):
        folder = self.folder / "disk"
        folder.mkdir(exist_ok=True)
        done = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder], capture_output=True, check=False)
        if done.returncode != 0:
            self.skipTest("only root can mount a small disk")
        self.addCleanup(lambda: subprocess.run(["umount", "-l", folder], check=False))
        return folder

    def test_a_full_disk_loses_no_answer_and_resume_ends_the_run(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 400, "seed": 5})
        whole = self.run_well("pareto", out="whole")
        folder = self.mounted("size=300k")
        result = run("pareto", "study.json", "--out", "disk/out", cwd=self.folder)
        self.assertEqual(result.returncode, 1)
        self.assertEqual(result.stdout, whole)
        first, last = result.stderr.splitlines()
        self.assertRegex(first, r"^coilwright: disk/out/archive\.sqlite: cannot be written: .*; the run goes on, and what "
                                r"waits to be recorded is tried again$")
        self.assertRegex(last, r"^coilwright: disk/out/[a-z]+\.csv: cannot be written: No space left on device; "
                               r"disk/out/archive\.sqlite: cannot be written: .*; designs that are not recorded: \d+$")
        self.assertEqual([path.name for path in (folder / "out").iterdir() if not path.name.startswith(ARCHIVE)], [])
        recorded = len(designs_of(folder / "out"))
        self.assertGreater(recorded, 20)
        subprocess.run(["mount", "-o", "remount,size=20m", folder], check=True)
        self.assertEqual(self.run_well("pareto", "--resume", out="disk/out"), whole)
        self.assertEqual(results_of(folder / "out"), results_of(self.folder / "whole"))
        self.assertEqual(self.runs("disk/out")[1][1], recorded)

    def test_a_disk_that_was_full_for_a_moment_loses_nothing(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 1500, "seed": 5})
        whole = self.run_well("pareto", out="whole")
        folder = self.mounted("size=300k")
        process = start("pareto", "study.json", "--out", "disk/out", "--quiet", cwd=self.folder)
        self.addCleanup(end, process)
        first = process.stderr.readline()
        process.send_signal(signal.SIGSTOP)
        subprocess.run(["mount", "-o", "remount,size=20m", folder], check=True)
        process.send_signal(signal.SIGCONT)
        output, errors = process.communicate(timeout=HANGS)
        self.assertRegex(first, r"^coilwright: disk/out/archive\.sqlite: cannot be written: .* is tried again\n$")
        self.assertEqual((process.returncode, output), (0, whole))
        self.assertEqual(errors, "coilwright: disk/out/archive.sqlite: is written again, with all that waited\n")
        self.assertEqual(results_of(folder / "out"), results_of(self.folder / "whole"))
        self.assertEqual(len(designs_of(folder / "out")), len(designs_of(self.folder / "whole")))

    def test_a_sweep_on_a_full_disk_prints_its_best_designs(self):
        write_study(self, variables={**GRID, "gap_mm": {"lower": 0.7, "upper": 1.6, "step": 0.01}})
        whole = self.run_well("sweep", out="whole")

        def limit_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (250_000, 250_000))

        process = start("sweep", "study.json", "--out", "out", cwd=self.folder, preexec_fn=limit_files)
        output, errors = process.communicate(timeout=HANGS)
        self.assertEqual((process.returncode, output), (1, whole))
        self.assertRegex(errors, r"coilwright: out/designs\.csv: cannot be written: File too large(; "
                                 r"out/archive\.sqlite: cannot be written: .*; designs that are not recorded: \d+)?\n$")
        self.run_well("sweep", "--resume")
        self.assertEqual(results_of(self.folder / "out"), results_of(self.folder / "whole"))
        self.assertGreater(self.runs()[1][1], 0)

    def test_an_answer_is_printed_where_the_folder_or_the_archive_is_gone(self):
        for command, changes in (("size", {"objectives": [FRONT[0]], "search": {"max_evaluations": 150, "seed": 5}}), ("pareto", {}),
                                 ("sweep", {"variables": {**GRID, "gap_mm": {"lower": 0.7, "upper": 1.6, "step": 0.01}}})):
            changes = {"objectives": FRONT, "search": {"max_evaluations": 600, "seed": 5}, **changes}
            write_study(self, **changes)
            whole = self.run_well(command, out=command)
            for gone in ("folder", "archive"):
                with self.subTest(f"{command}, {gone}"):
                    process = self.begun(command, out=gone, **changes)
                    if gone == "folder":
                        shutil.rmtree(self.folder / gone)
                    else:
                        for path in (self.folder / gone).glob(ARCHIVE + "*"):
                            path.unlink()
                    process.send_signal(signal.SIGCONT)
                    output, errors = process.communicate(timeout=HANGS)
                    self.assertEqual((process.returncode, output), (1, whole))
                    self.assertRegex(errors.splitlines()[-1], rf"^coilwright: {gone}/\S+: cannot be (read|written): ")
                shutil.rmtree(self.folder / gone, ignore_errors=True)

    def test_a_folder_that_only_reads_is_refused(self):
        write_study(self, search={"max_evaluations": 20})
        folder = self.mounted("size=20m")
        self.run_well("size", out="disk/out")
        subprocess.run(["mount", "-o", "remount,ro", folder], check=True)
        self.assert_refused(["size", "study.json", "--out", "disk/out", "--resume"],
                            "disk/out: cannot be written: Read-only file system")
        # And read it is.
        result = run("archive", "list", "disk/out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))


class Reuse(ArchivedStudy):
    def test_a_front_is_found_from_a_sweep_and_the_reverse(self):
        variables = {"turns_radial": {"lower": 12, "upper": 15}, "gap_mm": {"lower": 0.7, "upper": 1.5, "step": 0.1}}
        write_study(self, variables=variables, objectives=FRONT)
        shutil.copy(self.folder / "study.json", self.folder / "sweep.json")
        # Other goals, another range and order of the same variables.
        write_study(self, variables={"gap_mm": {"lower": 0.9, "upper": 1.7, "step": 0.1}, "turns_radial": {"values": [13, 15, 16]}},
                    objectives=[{"minimise": "cost_USD"}, {"maximise": "peak_bending_speed_deg_s"}],
                    constraints=[{"quantity": "mass_g", "at_most": 67}], search={"max_evaluations": 20, "seed": 3})
        sweep = self.run_well("sweep", out="sweep", study="sweep.json")
        front = self.run_well("pareto", out="front")
        self.assertEqual(self.run_well("pareto", "--reuse", "sweep", out="front_from_sweep"), front)
        self.assertEqual(results_of(self.folder / "front_from_sweep"), results_of(self.folder / "front"))
        ((evaluated, answered, reused),) = self.runs("front_from_sweep")
        self.assertGreater(reused, 3)
        self.assertGreater(evaluated, 3)
        self.assertEqual((evaluated + reused, answered), (20, 0))
        self.assertEqual(self.run_well("sweep", "--reuse", "front", out="sweep_from_front", study="sweep.json"), sweep)
        self.assertEqual(results_of(self.folder / "sweep_from_front"), results_of(self.folder / "sweep"))
        self.assertGreater(self.runs("sweep_from_front")[0][2], 3)

    def test_what_does_not_match_is_refused(self):
        write_study(self, variables=GRID)
        self.run_well("sweep", out="sweep")
        grid = {**GRID, "gap_mm": {"lower": 0.7, "upper": 1.1, "step": 0.2}}
        for changes, arguments, reason in (
                ({"operating_point": {"share_of_current_limit": 0.8, "duty": 0.5}}, [], "another operating point"),
                ({}, ["--set", "front_length_mm=9"], "another actuator"),
                ({"variables": {key: grid[key] for key in ("gap_mm", "turns_radial")}}, [],
                 "variables configuration, gap_mm, turns_radial, not gap_mm, turns_radial"),
                ({"objectives": [{"maximise": "grasp_force_N / mass_g", "name": "grip", "unit": "N/g"}],
                  "operating_point": {"share_of_current_limit": 0.9, "duty": 0.5, "cases": "free"}}, [],
                 "no quantity grip_N_g as this study has it")):
            with self.subTest(reason):
                write_study(self, **{"variables": grid, **changes})
                self.assert_refused(["sweep", "study.json", "--out", "out", "--reuse", "sweep", *arguments],
                                    f"sweep: cannot answer designs of this study ({reason})")
        self.assert_refused(["sweep", "study.json", "--out", "out", "--reuse", "none"],
                            "--reuse: must name the folder of a run of size, pareto or sweep: "
                            "none/archive.sqlite: cannot be read: there is no such file")


if __name__ == "__main__":
    unittest.main()
