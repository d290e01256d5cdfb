"""`--part`, `merge` and `distribute`: the results of a run in parts are those of the run on one machine, byte for byte,
also under the real engine with its workers and its master killed."""

import fcntl
import json
import os
import random
import shutil
import subprocess
import sys
import unittest

import engine
from archived_runs import end, results_of, start, stop_with_designs
from diagnose_test import PLAN, ROD
from program import THOROUGH, ProgramTest, run
from study import FRONT, GRID, write_study

KILLS = THOROUGH  # workflows in which processes are killed
SPREAD = {"parts": "usual"}


class InParts(ProgramTest):
    def ok(self, *arguments, code=0):
        result = run(*arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (code, ""), arguments)
        return result.stdout

    def parts(self, count, *arguments, prefix="part"):
        """Made in any order."""
        numbers = list(range(1, count + 1))
        random.Random(4).shuffle(numbers)
        for number in numbers:
            self.ok(*arguments, "--quiet", "--part", f"{number}/{count}", "--out", f"{prefix}{number}")
        return [f"{prefix}{number}" for number in numbers]

    def merge_error(self, parts, message, code=2):
        self.assert_refused(["merge", "merged", *parts], message, code)


class Sweeps(InParts):
    def check(self, count, *options, code=0):
        whole = self.ok("sweep", "study.json", "--out", "whole", "--quiet", "--force", *options, code=code)
        parts = self.parts(count, "sweep", "study.json", "--force", *options)
        self.assertEqual(self.ok("merge", "merged", *parts, "--force", code=code), whole)
        merged, expected = results_of(self.folder / "merged"), results_of(self.folder / "whole")
        self.assertEqual(sorted(merged), sorted(expected))
        for name, content in expected.items():
            self.assertTrue(merged[name] == content, name)
        shutil.rmtree(self.folder / "merged")

    def test_merged_parts_are_the_sweep_of_one_machine(self):
        write_study(self, variables=GRID, objectives=FRONT)
        self.check(5)
        self.check(40)  # of which eight have no design
        for keep in ("feasible", "front", "best"):
            self.check(3, "--keep", keep)
        self.check(4, "--sample", "50", "--keep", "front")
        self.check(2, "--set", "ambient_degC=30")

    def test_a_sweep_without_a_feasible_design_says_so_when_it_is_merged(self):
        write_study(self, variables=GRID, constraints=[{"quantity": "mass_g", "at_most": 1}])
        self.check(3, code=3)

    def test_kept_rows_are_those_of_the_whole_table(self):
        write_study(self, variables=GRID, objectives=FRONT)
        self.ok("sweep", "study.json", "--out", "all", "--quiet")
        self.ok("sweep", "study.json", "--out", "feasible", "--quiet", "--keep", "feasible")
        rows = self.table("all/designs.csv")
        feasible = [row for row in rows if row["status"] == "ok"]
        self.assertTrue(0 < len(feasible) < len(rows))
        self.assertEqual(self.table("feasible/designs.csv"), feasible)
        result = self.result("feasible/result.json")
        masses = [float(row["mass_g"]) for row in rows if row["mass_g"]]
        told = result["quantities"]["mass_g"]
        self.assertEqual((told["designs"], told["least"], told["greatest"]), (len(masses), min(masses), max(masses)))
        self.assertAlmostEqual(told["mean"], sum(masses) / len(masses), delta=1e-13 * told["mean"])  # of rounded sums

    def test_what_cannot_be_merged_is_named_in_one_line(self):
        write_study(self, variables=GRID)
        parts = sorted(self.parts(6, "sweep", "study.json"))
        self.merge_error(parts[:1] + parts[3:4], "merged: cannot be made: parts 2 to 3, 5 to 6 of 6 are missing; make them and merge again")
        self.merge_error(parts[:3] + parts[4:], "merged: cannot be made: part 4 of 6 is missing; make it and merge again")
        shutil.copytree(self.folder / "part3", self.folder / "again")
        self.merge_error([*parts, "again"], "again: is part 3 of 6, as part3 is: name one of them")
        (self.folder / "empty").mkdir()
        self.merge_error([*parts, "empty"], "empty: holds no finished part (part.json is not there): make it again with --resume")
        self.ok("sweep", "study.json", "--quiet", "--part", "3/7", "--out", "of7")
        self.merge_error(parts[:2] + ["of7"], "of7: is a part of another run than part1 (of 7 parts, not 6): merge each run by itself")
        self.ok("sweep", "study.json", "--quiet", "--part", "3/6", "--out", "other", "--keep", "best")
        self.merge_error(parts[:2] + ["other"], "other: is a part of another run than part1 (algorithm the grid, --keep "
                         "best, not the grid, --keep all): merge each run by itself")
        table = self.folder / "part5" / "designs.csv"
        table.write_bytes(table.read_bytes()[:-9])
        self.merge_error(parts, "part5/designs.csv: is not there, or not what the part wrote (SHA-256): make the part again")

    def test_parts_of_another_study_program_or_processor_are_named(self):
        write_study(self, variables=GRID)
        self.parts(2, "sweep", "study.json")
        path = self.folder / "part2" / "part.json"
        part = json.loads(path.read_text())

        def forged(change):
            forged = json.loads(path.read_text())
            change(forged)
            (self.folder / "forged").mkdir(exist_ok=True)
            (self.folder / "forged" / "part.json").write_text(json.dumps(forged))
            return ["part1", "forged"]

        mine = run("version", "--json").stdout
        self.assertIn(part["whole"]["version"], mine)
        result = run("merge", "merged", *forged(lambda p: p["whole"].update(version="9.9.9")), cwd=self.folder)
        self.assertRegex(result.stderr, r"^coilwright: forged: is a part of another run than part1 \(coilwright 9\.9\.9 .*, not .*, whose "
                                        r"numbers may differ\): merge each run by itself\n$")
        self.assertEqual(result.returncode, 2)
        result = run("merge", "merged", *forged(lambda p: p["whole"]["inputs"][0].update(sha256="0" * 64)), cwd=self.folder)
        self.assertIn("study.json with another content (SHA-256 00000000, not ", result.stderr)
        machine = part["machine"]

        def another(p):
            p["machine"].update(host="desk7", processor="Another", figures=[[0.5, *machine["figures"][0][1:]], *machine["figures"][1:]])

        result = run("merge", "merged", *forged(another), cwd=self.folder)
        self.assertEqual(result.stderr, f"coilwright: three designs have other numbers on {machine['host']} ({machine['processor']}) "
                         "(parts 2 on desk7 (Another)): results of different processors must not be mixed; make these parts on "
                         "processors of one kind\n")
        self.assertEqual(result.returncode, 1)
        self.assertFalse((self.folder / "merged").exists())

    def test_a_part_ends_at_once_where_the_processor_gives_other_numbers_than_the_head(self):
        write_study(self, variables=GRID)
        self.ok("distribute", "study.json", "--parts", "2", "--out", "work")
        head = json.loads((self.folder / "work" / "head.json").read_text())
        arguments = ("sweep", "study.json", "--quiet", "--part", "1/2", "--head", "head.json", "--out", "part1")
        self.write("head.json", json.dumps(head))
        self.ok(*arguments)
        head["machine"]["figures"][0][0] += 1
        head["machine"]["host"] = "head"
        self.write("head.json", json.dumps(head))
        result = run(*arguments, "--force", cwd=self.folder)
        self.assertRegex(result.stderr, r"^coilwright: .* gives three designs other numbers than head \(.*\), where the parts are gathered: "
                                        r"their results must not be mixed; make the parts on processors of one kind\n$")
        self.assertEqual(result.returncode, 4)

    def test_a_killed_part_goes_on(self):
        write_study(self, variables={**GRID, "gap_mm": {"lower": 0.7, "upper": 1.6, "step": 0.002}})  # seconds: it must not end before it is killed
        self.ok("sweep", "study.json", "--out", "whole", "--quiet")
        process = start("sweep", "study.json", "--part", "2/2", "--out", "part2", "--resume", cwd=self.folder)
        self.addCleanup(end, process)
        stop_with_designs(self, process, self.folder / "part2", 10)
        process.kill()
        process.communicate()
        self.merge_error(["part2"], "part2: holds no finished part (part.json is not there): make it again with --resume")
        for number in (1, 2):
            self.ok("sweep", "study.json", "--quiet", "--part", f"{number}/2", "--out", f"part{number}", "--resume")
        self.ok("merge", "merged", "part1", "part2")
        self.assertEqual(results_of(self.folder / "merged"), results_of(self.folder / "whole"))

    def test_a_part_that_is_none_is_refused(self):
        write_study(self, variables=GRID)
        for text in ("0/3", "4/3", "1", "1/", "a/3", "1/3x", "-1/3", "1/1000001"):
            self.assert_refused(["sweep", "study.json", "--out", "out", f"--part={text}"], "sweep: --part: must be K/N with 1 <= K <= N <= "
                                f"1000000, as in 3/40; got {text} (see coilwright sweep --help)")


class OtherRuns(InParts):
    def test_the_best_seed_is_the_answer_of_size(self):
        write_study(self, search={"max_evaluations": 40, "seed": 7})
        parts = self.parts(3, "size", "study.json", "--answer-only")
        self.ok("merge", "merged", *parts)
        seeds = self.result("merged/seeds.json")["seeds"]
        self.assertEqual([each["seed"] for each in seeds], [7, 8, 9])
        speeds = [each["objectives"]["peak_bending_speed_deg_s"] for each in seeds]
        best = max(range(3), key=lambda i: (seeds[i]["feasible"], speeds[i]))
        self.assertEqual([each["in_answer"] for each in seeds], [int(i == best) for i in range(3)])
        self.ok("size", "study.json", "--out", "alone", "--quiet", "--answer-only", "--seed", 7 + best)
        alone = results_of(self.folder / "alone")
        merged = results_of(self.folder / "merged")
        merged.pop("seeds.json")
        self.assertEqual(merged, alone)

    def test_the_front_of_fronts_has_what_no_seed_beats(self):
        write_study(self, objectives=FRONT, search={"max_evaluations": 60, "seed": 7})
        parts = self.parts(3, "pareto", "study.json")
        self.ok("merge", "merged", *parts)
        rows = [row for part in sorted(parts) for row in self.table(f"{part}/front.csv")]
        value = lambda row: (-float(row["peak_bending_speed_deg_s"]), float(row["mass_g"]))
        best = [row for row in rows if not any(a != value(row) and a[0] <= value(row)[0] and a[1] <= value(row)[1] for a in map(value, rows))]
        merged = self.table("merged/front.csv")
        self.assertEqual(sorted(set(map(value, best))), list(map(value, merged)))
        self.assertTrue(all(row in best for row in merged))

    def test_merged_builds_are_the_yield_of_one_machine(self):
        write_study(self, spread=SPREAD)
        self.ok("size", "study.json", "--out", "best", "--quiet", "--answer-only")
        asked = ("yield", "study.json", "best/actuator.json", "--builds", "40", "--worth", "16", "--seed", "3", "--quiet")
        text, result = self.ok(*asked), self.ok(*asked, "--json")
        parts = self.parts(3, *asked)
        self.assertEqual(self.ok("merge", "merged", *parts), text)
        self.assertEqual((self.folder / "merged" / "result.json").read_text(), result)

    def test_diagnoses_of_many_sets_are_a_workflow_and_become_a_table(self):
        self.write("rod.json", json.dumps(ROD))
        self.write("plan.json", json.dumps(PLAN))
        for name, effect in (("sticky", "dry_friction:torque_Nmm=25"), ("plain", None)):
            self.ok("twin", "rod.json", "--experiment", "plan.json", "--out", name, *(["--effect", effect] if effect else []))
        self.ok("distribute", "sticky", "plain", "--as", "diagnose", "--out", "work")
        work = self.folder / "work"
        for number in (2, 1):
            subprocess.run(["sh", "part.sh", str(number)], cwd=work, check=True, capture_output=True)
        subprocess.run(["sh", "merge.sh"], cwd=work, check=True, stdout=subprocess.DEVNULL)
        rows = self.table("work/result/diagnoses.csv")
        self.assertEqual([(row["set"], row["verdict"], row["effects"]) for row in rows],
                         [("inputs/sticky", "explained", "dry_friction"), ("inputs/plain", "no_missing_effect", "")])
        alone = run("diagnose", "inputs/sticky", "--out", "alone", "--quiet", "--threads", "1", cwd=work)
        self.assertEqual(alone.returncode, 0)
        part = results_of(work / "parts" / "0001")
        part.pop("part.json")
        self.assertEqual(part, results_of(work / "alone"))


    def test_a_link_keeps_its_name_and_what_lies_beside_what_it_leads_to_is_found(self):
        self.write("plan.json", json.dumps(PLAN))
        (self.folder / "store" / "runs").mkdir(parents=True)
        self.write("store/rod.json", json.dumps(ROD))
        self.ok("twin", "store/rod.json", "--experiment", "plan.json", "--out", "store/raw")
        (self.folder / "store" / "raw" / "slow.csv").rename(self.folder / "store" / "runs" / "slow.csv")
        (self.folder / "store" / "raw" / "slow.csv").symlink_to("../runs/slow.csv")
        declared = self.result("store/raw/dataset.json")
        self.write("store/raw/dataset.json", json.dumps({**declared, "actuator": "../rod.json"}))
        for name in ("monday", "tuesday"):
            (self.folder / name).symlink_to("store/raw")
        self.ok("distribute", "monday", "tuesday/", "--as", "diagnose", "--out", "work")
        told = (self.folder / "work" / "arguments.txt").read_text().splitlines()
        self.assertEqual([line.split()[1] for line in told], ["inputs/monday", "inputs/tuesday"])
        self.assertEqual(set(os.listdir(self.folder / "work" / "inputs")), {"monday", "tuesday", "rod.json"})
        self.assertEqual(run("diagnose", "inputs/monday", "--out", "x", "--minutes", "0.001", cwd=self.folder / "work").returncode, 130)
        (self.folder / "store" / "monday").mkdir()
        for file in (self.folder / "store" / "raw").iterdir():
            shutil.copy(file, self.folder / "store" / "monday")
        self.assert_refused(["distribute", "monday", "store/monday", "--as", "diagnose", "--out", "other"], "store/monday/dataset.json: would be "
                            "copied to one place with monday/dataset.json: give sets other names")
        (self.folder / "sub").mkdir()
        write_study(self, variables=GRID)
        (self.folder / "sub" / "mine.json").symlink_to("../study.json")
        (self.folder / "finger.json").rename(self.folder / "sub" / "finger.json")
        self.ok("distribute", "sub/mine.json", "--parts", "2", "--out", "grid")
        self.assertEqual(sorted(os.listdir(self.folder / "grid" / "inputs")), ["finger.json", "mine.json"])


class Workflows(InParts):
    def setUp(self):
        super().setUp()
        write_study(self, variables={**GRID, "gap_mm": {"lower": 0.7, "upper": 1.6, "step": 0.01}})

    def test_what_cannot_be_distributed_is_refused(self):
        out = ("--out", "work")
        self.assert_refused(["distribute", "study.json", *out], "--parts: must be given: how many parts the study has")
        self.assert_refused(["distribute", "study.json", "--parts", "3", *out, "--options", "--kep all"], "--options: sweep has no option --kep")
        self.assert_refused(["distribute", "study.json", "--parts", "3", *out, "--options", "--out x"],
                            "--options: must not have --out, which distribute sets or parts cannot have")
        self.assert_refused(["distribute", "study.json", "--parts", "3", *out, "--options", "--keep $(ls)"],
                            "$(ls): must have only letters, digits and any of ._/+-=:,@% to be given to parts")
        self.assert_refused(["distribute", "study.json", "finger.json", "--parts", "3", *out], "--as sweep: needs one STUDY.json")
        (self.folder / "work").mkdir()
        self.write("work/x", "")
        self.assert_refused(["distribute", "study.json", "--parts", "3", *out], "work: cannot be written: it is not empty; --force writes into "
                            "it, another --out keeps it")

    def test_what_no_part_can_run_with_is_refused_before_it_is_given_away(self):
        """Whatever it is: a part is tried. The folder is not begun."""
        write_study(self, objectives=FRONT)
        (self.folder / "study.json").rename(self.folder / "front.json")
        write_study(self, variables=GRID, spread=SPREAD)
        for arguments, reason in ((["study.json", "--options", "--keep foo"], "sweep: --keep: must be one of"),
                                  (["study.json", "--options", "--sample x"], "sweep: --sample: "),
                                  (["front.json", "--as", "size"], "front.json: "),
                                  (["study.json", "--as", "size", "--options", "--algorithm none"], "size: --algorithm: ")):
            with self.subTest(" ".join(arguments)):
                result = run("distribute", *arguments, "--parts", "2", "--out", "work", cwd=self.folder)
                self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
                self.assertRegex(result.stderr, r"^coilwright: no part can run: .*\n$")
                self.assertIn(reason, result.stderr)
                self.assertFalse((self.folder / "work").exists())

    def test_slurm_gets_the_options_of_the_cluster(self):
        options = "--time=2:00:00 --mem=2G --account=lab --partition=short"
        self.ok("distribute", "study.json", "--parts", "2", "--out", "work", "--slurm", options)
        lines = (self.folder / "work" / "slurm.sh").read_text().splitlines()
        told = [line.removeprefix("#SBATCH ") for line in lines if line.startswith("#SBATCH --")]
        self.assertEqual(told[-4:], options.split())
        self.assert_refused(["distribute", "study.json", "--parts", "2", "--out", "other", "--slurm", "-t 5"],
                            "--slurm: must have options of sbatch such as --time=2:00:00 --mem=2G --account=lab "
                            "--partition=short; got -t")

    def test_the_password_is_made_and_told(self):
        told = self.ok("distribute", "study.json", "--parts", "2", "--out", "work")
        self.assertIn("sh makeflow.sh -T wq -p 9123 -r 3 --password password\n", told)
        self.assertIn("work_queue_worker --password password HOST_OF_THIS_MACHINE 9123\n", told)
        password = self.folder / "work" / "password"
        self.assertEqual(password.stat().st_mode & 0o777, 0o600)
        self.assertRegex(password.read_text(), r"^[0-9a-f]{32}$")

    def test_progress_says_how_many_parts_are_made_and_how_long_the_rest_takes(self):
        work, _ = self.distributed(3)
        watch = subprocess.Popen(["sh", "progress.sh"], cwd=work, stdout=subprocess.PIPE, text=True)
        self.addCleanup(watch.kill)
        self.assertEqual(watch.stdout.readline(), "0 of 3 parts are made\n")
        subprocess.run(["sh", "part.sh", "2"], cwd=work, check=True, stdout=subprocess.DEVNULL)
        self.assertRegex(watch.stdout.readline(), r"^1 of 3 parts are made, about \d+ s left\n$")
        for number in ("1", "3"):
            subprocess.run(["sh", "part.sh", number], cwd=work, check=True, stdout=subprocess.DEVNULL)
        self.assertEqual(watch.stdout.read().splitlines()[-1], "3 of 3 parts are made")
        self.assertEqual(watch.wait(), 0)
        watch.stdout.close()

    def test_a_worker_whose_processor_rounds_otherwise_leaves_and_uses_up_no_repetition(self):
        if not engine.is_installed():
            self.skipTest("makeflow is not installed")
        work, whole = self.distributed(8)
        # A processor of which a part is told by the variable of a worker: the program in front of the real one.
        (work / "coilwright").rename(work / "real")
        self.write("work/coilwright", '#!/bin/sh\ntest -z "$ROUNDS_OTHERWISE" || { sleep 0.2; exit 4; }\nexec ./real "$@"\n')
        (work / "coilwright").chmod(0o755)
        flow = work / "workflow.makeflow"
        flow.write_text(flow.read_text().replace("SHARED=", "SHARED=real "))
        with engine.Engine(work, workers=0) as workflow:
            bad = workflow.start_worker(9, ROUNDS_OTHERWISE="1")
            bad.wait(timeout=60)  # it leaves by itself
            self.assertIsNone(workflow.master.poll())
            workflow.workers.append(workflow.start_worker(0))
            self.assertEqual(workflow.wait(), 0, (work / "engine.log").read_text()[-2000:])
        self.assertEqual(results_of(work / "result"), whole)
        log = (work / "engine.log").read_text()
        self.assertIn("part.sh: this machine gives other numbers than the one that gathers the parts: its worker ends", log)
        self.assertIn("8 of 8 parts are made", log)

    def test_makeflow_without_a_result_fails(self):
        if not engine.is_installed():
            self.skipTest("makeflow is not installed")
        work, _ = self.distributed(2)
        (work / "part.sh").write_text("exit 1\n")
        result = subprocess.run(["sh", "makeflow.sh", "-T", "local", "-j", "1"], cwd=work, capture_output=True, text=True)
        self.assertEqual(result.returncode, 1, result.stderr)
        self.assertIn("makeflow.sh: there is no result: 0 of 2 parts are made, and what stopped the rest stands above", result.stderr)

    def test_of_two_masters_in_one_folder_the_second_says_so_and_ends(self):
        work, _ = self.distributed(1)
        with open(work / "parts.lock", "a") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)  # as the first holds it
            scripts = ("makeflow.sh", "parallel.sh")
            second = [subprocess.Popen(["sh", script], cwd=work, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) for script in scripts]
            for script, process in zip(scripts, second):
                self.assertEqual(process.communicate(), ("", f"{script}: another run gives out the parts of this folder: wait for its end\n"))
                self.assertEqual(process.returncode, 1)
        self.assertFalse((work / "parts").exists())

    def distributed(self, parts):
        """A folder of a workflow, and the results of the same run on one machine."""
        self.ok("distribute", "study.json", "--parts", parts, "--out", "work", "--force")
        work = self.folder / "work"
        whole = run("sweep", "inputs/study.json", "--out", "whole", "--quiet", "--threads", "1", "--force", cwd=work)
        self.assertEqual((whole.returncode, whole.stderr), (0, ""))
        return work, results_of(work / "whole")

    def test_the_scripts_make_the_whole_by_themselves(self):
        work, whole = self.distributed(3)
        for number in (2, 3, 1):
            subprocess.run(["sh", "part.sh", str(number)], cwd=work, check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["sh", "merge.sh"], cwd=work, check=True, stdout=subprocess.DEVNULL)
        self.assertEqual(results_of(work / "result"), whole)
        if shutil.which("parallel"):
            shutil.rmtree(work / "parts")
            shutil.rmtree(work / "result")
            subprocess.run(["sh", "parallel.sh"], cwd=work, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.assertEqual(results_of(work / "result"), whole)

    def test_every_file_of_a_part_comes_back_from_the_machine_that_made_it(self):
        """Where nothing is shared, an engine brings what the workflow names, and merge misses whatever it does not."""
        if not engine.is_installed():
            self.skipTest("makeflow is not installed")
        write_study(self, variables=GRID, search={"max_evaluations": 10, "seed": 5}, spread=SPREAD)
        (self.folder / "study.json").rename(self.folder / "spread.json")
        write_study(self, objectives=FRONT, search={"max_evaluations": 20, "seed": 5})
        (self.folder / "study.json").rename(self.folder / "front.json")
        write_study(self, variables=GRID, search={"max_evaluations": 10, "seed": 5})
        self.write("rod.json", json.dumps(ROD))
        self.write("plan.json", json.dumps({**PLAN, "sampling_rate_Hz": 40}))
        self.ok("twin", "rod.json", "--experiment", "plan.json", "--out", "sticky", "--effect", "dry_friction:torque_Nmm=25")
        for kind, arguments, result in (("sweep", ["study.json", "--parts", "2"], "result.json"),
                                        ("size", ["study.json", "--parts", "2", "--options", "--answer-only"], "seeds.json"),
                                        ("pareto", ["front.json", "--parts", "2"], "seeds.json"),
                                        ("yield", ["spread.json", "finger.json", "--parts", "2", "--options", "--builds 20"], "result.json"),
                                        ("diagnose", ["sticky"], "diagnoses.csv")):
            with self.subTest(kind):
                self.ok("distribute", *arguments, "--as", kind, "--out", kind)
                with engine.Engine(self.folder / kind, workers=1) as workflow:
                    self.assertEqual(workflow.wait(), 0, (self.folder / kind / "engine.log").read_text()[-2000:])
                self.assertTrue((self.folder / kind / "result" / result).exists())

    def test_killed_workers_and_masters_change_no_byte(self):
        if not engine.is_installed():
            print("SKIPPED: makeflow and work_queue_worker are not installed (Debian: coop-computing-tools)", file=sys.stderr)
            self.skipTest("makeflow is not installed")
        work, whole = self.distributed(12)
        killed = []
        for seed in range(KILLS):
            for name in ("parts", "result"):
                shutil.rmtree(work / name, ignore_errors=True)
            for path in work.glob("workflow.makeflow.*"):
                path.unlink()
            killed += engine.run_with_kills(work, 2, duration=4.0, seed=seed)
            result = results_of(work / "result")
            self.assertEqual(sorted(result), sorted(whole))
            for name, content in whole.items():
                self.assertTrue(result[name] == content, f"{name} after kill of {killed[-2:]}")
        print(f"{KILLS} workflows, {len(killed)} kills: " + ", ".join(f"{killed.count(each)} of the {each}" for each in sorted(set(killed))))
        self.assertGreater(len(killed), 0)


if __name__ == "__main__":
    unittest.main()
