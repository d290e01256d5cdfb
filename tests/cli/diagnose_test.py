"""`coilwright diagnose`: what is written and where, the same bytes on any number of threads, and data that are bad."""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

from program import DATA, PROGRAM, ProgramTest, run

# A pendulum of 0.5 kg on 0.2 m, with damping and no spring: quick to simulate.
ROD = {"format": "lumped-model/1", "name": "rod", "gravity_m_s2": 9.81, "magnetics": None,
       "links": [{"length_m": 0.2, "com_along_m": 0.2, "com_offset_m": 0, "mass_kg": 0.5, "inertia_kgm2": 0}],
       "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 0.005}]}


def swing(name, role, torque, frequency):
    return {"file": name, "role": role, "duration_s": 2, "drive": "torque",
            "input": {"sine": {"amplitude_Nmm": torque, "frequency_Hz": frequency}}}


PLAN = {"format": "experiment/1", "name": "rod", "sampling_rate_Hz": 100, "noise": {"angle_deg": 0.2},
        "measure": ["theta1_deg"],
        "runs": [swing("slow.csv", "fit", 300, 0.5), swing("quick.csv", "fit", 150, 1.5),
                 swing("other.csv", "validate", 250, 0.8)]}
# A second of it.
QUICK_PLAN = {**PLAN, "sampling_rate_Hz": 40, "runs": [{**PLAN["runs"][i], "duration_s": 1} for i in (0, 2)]}


class Diagnose(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """A set that hides dry friction, in `set`, and its diagnosis by one thread, in `out`, which several tests look at."""
        temporary = tempfile.TemporaryDirectory()
        cls.addClassCleanup(temporary.cleanup)
        cls.friction = pathlib.Path(temporary.name)
        (cls.friction / "rod.json").write_text(json.dumps(ROD))
        (cls.friction / "plan.json").write_text(json.dumps(PLAN))
        run("twin", "rod.json", "--experiment", "plan.json", "--out", "set", "--effect", "dry_friction:torque_Nmm=25",
            cwd=cls.friction)
        cls.diagnosed = run("diagnose", "set", "--out", "out", "--threads", "1", cwd=cls.friction)

    def take_friction(self):
        """That set and its diagnosis, in the folder of this test."""
        self.assertEqual(self.diagnosed.returncode, 0, self.diagnosed.stderr)
        shutil.copytree(self.friction, self.folder, dirs_exist_ok=True)
        return self.diagnosed

    def setUp(self):
        super().setUp()
        self.write("rod.json", json.dumps(ROD))
        self.write("plan.json", json.dumps(PLAN))

    def make_quick(self):
        self.write("plan.json", json.dumps(QUICK_PLAN))

    def declare(self, **changes):
        """In the data set."""
        self.write("set/dataset.json", json.dumps({**self.result("set/dataset.json"), **changes}))

    def twin(self, *arguments):
        result = run("twin", "--force", "rod.json", "--experiment", "plan.json", "--out", "set", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def diagnose(self, out, *arguments):
        result = run("diagnose", "set", "--out", out, *arguments, cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result

    def test_the_hidden_effect_is_found_and_everything_is_written(self):
        result = self.take_friction()
        self.assertEqual({path.name for path in (self.folder / "out").iterdir()},
                         {"diagnosis.json", "actuator.json", "residuals.csv", "summary.txt", "provenance.json"})
        self.assertEqual(result.stdout, (self.folder / "out" / "summary.txt").read_text())
        self.assertIn("the most probable so far: dry_friction", result.stderr)  # progress
        time = r", (about \d+ (s|min)|less than a second)"
        self.assertRegex(result.stderr, r"\d+ effects fitted alone" + time)
        self.assertRegex(result.stderr, r"8 of \d+ effects compared" + time + " to go")
        found = self.result("out/diagnosis.json")
        self.assertEqual((found["format"], found["verdict"]), ("diagnosis/1", "explained"))
        self.assertEqual([effect["id"] for effect in found["effects"]], ["dry_friction"])
        torque = found["effects"][0]["parameters"]["torque_Nmm"]
        self.assertLess(abs(torque["value"] - 25), 2)
        self.assertLess(torque["ci95"][0], torque["value"])
        self.assertEqual((found["updated_actuator"], found["refused"]), ("actuator.json", []))
        errors = found["error"]["validate"]
        self.assertLess(errors["after"]["rmse_deg"], errors["before"]["rmse_deg"])
        self.assertLessEqual(errors["after"]["rmse_deg"], 1.1 * errors["noise_floor_rmse_deg"])
        self.assertEqual(set(found["error"]["fit"]), set(errors))
        rows = self.table("out/residuals.csv")
        self.assertEqual(len(rows), 3 * 201)
        self.assertEqual({row["run"]: row["role"] for row in rows},
                         {"slow.csv": "fit", "quick.csv": "fit", "other.csv": "validate"})
        # Its errors are those of the report: a second route to them.
        held_out = [float(row["measured"]) - float(row["after"]) for row in rows if row["role"] == "validate"]
        rmse = (sum(error * error for error in held_out) / len(held_out)) ** 0.5
        self.assertAlmostEqual(rmse, errors["after"]["rmse_deg"], places=9)

    def test_the_proposed_experiment_is_taken_by_twin_and_plan_as_it_is(self):
        self.twin("--effect", "base_tilt:angle_deg=3")
        self.diagnose("out", "--quiet")
        found = self.result("out/diagnosis.json")
        self.assertIn(["base_tilt", "angle_offset"], found["indistinguishable"])
        self.assertEqual(found["next_experiment"]["file"], "next_experiment.json")
        proposed = self.result("out/next_experiment.json")
        self.assertEqual(proposed["format"], "experiment/1")
        self.assertIn(found["next_experiment"]["input"], proposed["description"])
        self.assertAlmostEqual(proposed["noise"]["angle_deg"], 0.2, delta=0.02)  # 400 samples: 4 % a deviation
        files = [each["file"] for each in proposed["runs"]]
        self.assertEqual(files[:3], ["slow.csv", "quick.csv", "next_still.csv"])
        self.assertGreater(len(files), 3)
        self.assertLess(found["next_experiment"]["remaining_bits"], 0.9 * found["next_experiment"]["open_bits"])
        expected = self.table("out/next_experiment.csv")
        self.assertEqual(list(expected[0])[:5], ["run", "channel", "time_s", "angle_deg", "noise"])
        self.assertEqual(set(list(expected[0])[5:]), {"base_tilt", "angle_offset"})
        self.assertIn(expected[0]["run"], files)
        result = run("twin", "out/actuator.json", "--experiment", "out/next_experiment.json", "--out", "again",
                     cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertEqual({path.name for path in (self.folder / "again").glob("*.csv")}, set(files))
        # On the rig it tells what it promises.
        for hidden in ("base_tilt:angle_deg=3", "angle_offset:angle_deg=-2.4"):
            run("twin", "rod.json", "--experiment", "out/next_experiment.json", "--out", "set", "--force", "--effect", hidden,
                cwd=self.folder)
            self.diagnose("told", "--quiet", "--force")
            odds = self.result("told/diagnosis.json")["odds"]["effects"]
            self.assertGreater(odds[hidden.split(":")[0]], 0.95)
        result = run("plan", "out/next_experiment.json", "--actuator", "rod.json", "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue(any(each["visible"] for each in json.loads(result.stdout)["effects"]))
        # Nothing to decide: no file, and none is named.
        shutil.rmtree(self.folder / "out")
        shutil.rmtree(self.folder / "set")
        self.take_friction()
        self.assertIsNone(self.result("out/diagnosis.json")["next_experiment"])
        self.assertFalse((self.folder / "out" / "next_experiment.json").exists())
        self.assertFalse((self.folder / "out" / "next_experiment.csv").exists())

    def test_simulating_a_run_of_the_updated_actuator_gives_the_column_after(self):
        # A rod that a coil pushes, whose coil warms up in seconds and fades, under a camera that is late and askew. Damped
        # beyond ringing: otherwise the steps' errors, 1e-6 in diagnose and 1e-7 in simulate, add up to 1e-5.
        rod = {**ROD, "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 0.4}], "magnetics": [{"angle_deg": [-90, -45, 0, 45, 90], "torque_Nmm_A": [200, 260, 300, 260, 200]}],
               "effects": [{"id": "measurement_delay", "parameters": {"delay_ms": 13}},
                           {"id": "angle_offset", "parameters": {"angle_deg": 0.7}}]}

        def held(name, role, current):
            return {"file": name, "role": role, "duration_s": 6, "input": {"sine": {
                "amplitude_A": 0.3 * current, "offset_A": current, "frequency_Hz": 0.4}}}

        self.write("rod.json", json.dumps(rod))
        self.write("plan.json", json.dumps({**PLAN, "noise": {"angle_deg": 0.02}, "runs": [
            held("a.csv", "fit", 1), held("b.csv", "fit", 0.6), held("c.csv", "validate", 0.9)]}))
        self.twin("--effect", "coil_heating:fade_1_A2=0.3,time_constant_s=2.5,warm_start=0")
        self.declare(calibrate=[], tolerances="exact")
        self.diagnose("out")
        self.assertEqual([effect["id"] for effect in self.result("out/diagnosis.json")["effects"]], ["coil_heating"])
        rows = self.table("out/residuals.csv")
        for name in ("a.csv", "b.csv", "c.csv"):
            result = run("simulate", "out/actuator.json", "--input", f"set/{name}", "--out", "moved.csv",
                         cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            moved = [float(row["bending_angle_deg"]) for row in self.table("moved.csv")]
            after = [float(row["after"]) for row in rows if row["run"] == name]
            self.assertEqual(len(moved), len(after))
            for ours, theirs in zip(moved, after):
                self.assertAlmostEqual(ours, theirs, delta=1e-6 * abs(theirs))

    def test_the_updated_actuator_is_taken_by_the_other_commands_and_lacks_nothing(self):
        self.take_friction()
        self.write("push.csv", "time_s,torque1_Nm\n0,0\n0.1,0.3\n1,0.3\n")
        moved = {}
        for actuator in ("rod.json", "out/actuator.json"):
            result = run("simulate", actuator, "--input", "push.csv", "--interval-s", "0.05", "--out", "moved.csv",
                         cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            moved[actuator] = float(self.table("moved.csv")[-1]["theta1_deg"])
        self.assertNotAlmostEqual(moved["rod.json"], moved["out/actuator.json"], places=1)
        self.diagnose("again", "--actuator", "out/actuator.json")
        self.assertEqual(self.result("again/diagnosis.json")["verdict"], "no_missing_effect")

    def test_any_number_of_threads_gives_the_same_bytes(self):
        self.take_friction()
        # More than there are cores, of which TBB would tell.
        self.assertEqual(self.diagnose("two", "--threads", "1024", "--quiet").stderr, "")
        for name in ("diagnosis.json", "actuator.json", "residuals.csv", "summary.txt"):
            self.assertEqual(self.files()[f"out/{name}"], self.files()[f"two/{name}"], name)

    def test_where_the_time_went_ends_the_progress_and_is_in_no_file(self):
        result = self.take_friction()
        head, *phases = result.stderr[result.stderr.index("  phase "):].splitlines()
        self.assertEqual(head.split(), ["phase", "s", "simulated", "runs"])
        rows = [line.rsplit(maxsplit=2) for line in phases]
        runs = {name.strip(): int(simulated) for name, _, simulated in rows}
        self.assertEqual(list(runs)[-1], "total")
        self.assertGreater(runs["comparison"], 0)
        self.assertEqual(runs.pop("total"), sum(runs.values()))
        for name, content in self.files().items():
            if name.startswith("out/"):
                self.assertNotIn(b"simulated runs", content, name)

    def test_bad_data_is_refused_and_leaves_nothing(self):
        self.twin()
        good = self.result("set/dataset.json")

        def refused(message, *arguments, **changes):
            self.write("set/dataset.json", json.dumps({**good, **changes}))
            self.assert_refused(["diagnose", "set", "--out", "out", *arguments], message)

        refused('set/dataset.json: /format: must be "measured-data/1"; got text "measured-data/2"',
                format="measured-data/2")
        refused('set/dataset.json: names no "actuator"; one must be given with --actuator', actuator=None)
        refused("nowhere.json: cannot be opened: No such file or directory", "--actuator", "nowhere.json")
        self.write("set/dataset.json", json.dumps(good))
        self.assert_refused(["diagnose", "set", "--out", "set"],
                            "set: cannot be written: it is the folder of the data set")
        refused("diagnose: --threads: must be from 0 to 1024; got \"-1\" (see coilwright diagnose --help)",
                "--threads", "-1")
        self.write("set/slow.csv", "time_s,torque1_Nm,theta1_deg\n0,0,1\n0.01,0,x\n")
        refused('set/slow.csv: line 3: column theta1_deg: must be a finite number (delete the line if it is damaged); got "x"')

    def test_a_set_that_does_not_fit_its_model_is_bad_data(self):
        self.twin()
        self.write("set/slow.csv", "time_s,current_A,theta1_deg\n" + "".join(
            f"{i / 100},{i % 7},{i % 5}\n" for i in range(50)))
        data = self.result("set/dataset.json")
        data["runs"][0]["drive"] = "current"
        self.write("set/dataset.json", json.dumps(data))
        self.assert_refused(["diagnose", "set", "--out", "out"],
                            "set/dataset.json: slow.csv: drives coils, and the model has none")

    def test_a_result_that_other_commands_refuse_is_written_and_says_so(self):
        def wound(turns):
            return {**ROD, "joints": [{"stiffness_Nm_rad": 0.0125, "damping_Nms_rad": 5e-4}],
                    "links": [{"length_m": 0.019, "com_along_m": 0.011, "com_offset_m": 0.004, "mass_kg": 0.017,
                               "inertia_kgm2": 0}],
                    "magnetics": [{"coil": {"inner_radius_mm": 3, "outer_radius_mm": 9.5, "length_mm": 12,
                                            "turns_radial": turns, "turns_axial": 30},
                                   "magnet": {"radius_mm": 10, "length_mm": 6, "remanence_T": 1.4},
                                   "coil_offset_mm": 6.4, "magnet_offset_mm": 3.4, "axis_offset_mm": 11.5}]}

        def swung(name, role, frequency):
            return {"file": name, "role": role, "duration_s": 2, "input": {
                "sine": {"amplitude_A": 0.6, "offset_A": 0.3, "frequency_Hz": frequency}}}

        # A coil of 16 layers where 4 are declared: only a magnet four times as strong explains its torque.
        self.write("rod.json", json.dumps(wound(16)))
        self.write("declared.json", json.dumps(wound(4)))
        self.write("plan.json", json.dumps({**PLAN, "noise": {"angle_deg": 0.1}, "runs": [
            swung("a.csv", "fit", 0.7), swung("b.csv", "fit", 2), swung("c.csv", "validate", 1.1)]}))
        self.twin()
        self.declare(calibrate=["joint_damping", "/magnetics/0/magnet/remanence_T"])
        result = self.diagnose("out", "--actuator", "declared.json", "--quiet")
        found = self.result("out/diagnosis.json")
        remanence = found["calibration"]["/magnetics/0/magnet/remanence_T"]["value"]
        self.assertAlmostEqual(remanence, 4 * 1.4, delta=0.1)
        self.assertEqual(len(found["refused"]), 1)
        self.assertIn("needs a number that no actuator has, and the other commands refuse the file: "
                      f"{found['refused'][0]}.\n", result.stdout)
        self.assertIn("\nWhat to do next\n  Do not build on actuator.json.", result.stdout)
        self.assertNotIn("take it", result.stdout)
        self.assert_refused(["evaluate", "out/actuator.json", "--current-A", "1"], "out/" + found["refused"][0])
        self.assertIn("/magnetics/0/magnet/remanence_T: must be > 0 and <= 5; got", found["refused"][0])

    def test_an_actuator_that_is_an_input_is_never_overwritten(self):
        self.twin()
        (self.folder / "out").mkdir()
        self.write("out/actuator.json", json.dumps(ROD))
        self.assert_refused(["diagnose", "set", "--actuator", "out/actuator.json", "--out", "out"],
                            "out/actuator.json: cannot be written: it is an input of this command")

    def test_a_measured_file_is_never_overwritten(self):
        self.twin()
        data = self.result("set/dataset.json")
        data["runs"][0]["file"] = "../out/residuals.csv"
        (self.folder / "out").mkdir()
        measured = (self.folder / "set" / "slow.csv").read_bytes()
        self.write("out/residuals.csv", measured)
        self.write("set/dataset.json", json.dumps(data))
        result = run("diagnose", "set", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr),
                         (2, "coilwright: out/residuals.csv: cannot be written: it is an input of this command\n"))
        self.assertEqual((self.folder / "out" / "residuals.csv").read_bytes(), measured)

    def test_a_file_that_no_diagnosis_wrote_is_never_overwritten(self):
        self.make_quick()
        self.twin()
        (self.folder / "out").mkdir()
        self.write("out/summary.txt", "mine\n")
        result = run("diagnose", "set", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr),
                         (2, "coilwright: out/summary.txt: cannot be written: it holds something else; --force replaces it, "
                             "another --out keeps it\n"))
        self.assertEqual((self.folder / "out" / "summary.txt").read_text(), "mine\n")
        # A link that leads nowhere is a file of somebody, too; a page is in the way only where one is asked for.
        (self.folder / "linked").mkdir()
        (self.folder / "linked" / "residuals.csv").symlink_to("nowhere.csv")
        self.assert_refused(["diagnose", "set", "--out", "linked"],
                            "linked/residuals.csv: cannot be written: it holds something else; --force replaces it, another --out keeps it")
        (self.folder / "paged").mkdir()
        self.write("paged/report.html", "mine")
        self.assert_refused(["diagnose", "set", "--out", "paged", "--report"],
                            "paged/report.html: cannot be written: it holds something else; --force replaces it, another --out keeps it")
        self.diagnose("paged")
        self.assertEqual((self.folder / "paged" / "report.html").read_text(), "mine")
        self.diagnose("out", "--force")
        first = self.files()
        self.write("out/summary.txt", "of this diagnosis, changed")
        self.diagnose("out")
        self.assertEqual(self.files(), first)
        self.write("out/diagnosis.json", '{"mine": 1}')
        self.assert_refused(["diagnose", "set", "--out", "out"],
                            "out/diagnosis.json: cannot be written: it holds something else; --force replaces it, another --out keeps it")

    def test_nothing_needs_to_be_calibrated(self):
        self.twin("--effect", "dry_friction:torque_Nmm=25")
        self.declare(calibrate=[], tolerances="exact")
        self.diagnose("out")
        found = self.result("out/diagnosis.json")
        self.assertEqual([effect["id"] for effect in found["effects"]], ["dry_friction"])
        self.assertEqual(found["calibration"], {})
        self.assertEqual(found["error"]["validate"]["before"], found["error"]["validate"]["declared"])

    def test_a_declared_effect_with_a_wrong_number_is_pointed_at(self):
        self.make_quick()
        self.twin("--effect", "dry_friction:torque_Nmm=25")
        self.write("declared.json", json.dumps({**ROD, "effects": [
            {"id": "dry_friction", "parameters": {"torque_Nmm": 8}}]}))
        result = self.diagnose("out", "--actuator", "declared.json", "--quiet")
        self.assertIn("/effects/0/parameters/torque_Nmm of dry_friction stays as declared; it is fitted anew if "
                      "calibrate names it", result.stdout)
        self.declare(calibrate=["joint_stiffness", "joint_damping", "/effects/0/parameters/torque_Nmm"])
        result = self.diagnose("again", "--actuator", "declared.json", "--quiet")
        found = self.result("again/diagnosis.json")
        self.assertEqual(found["verdict"], "no_missing_effect")
        self.assertLess(abs(found["calibration"]["/effects/0/parameters/torque_Nmm"]["value"] - 25), 2)
        self.assertNotIn("stays as declared", result.stdout)

    def test_a_finished_model_of_which_nothing_is_free_is_scored(self):
        self.make_quick()
        for effect, verdict in ((), "no_missing_effect"), (("--effect", "dry_friction:torque_Nmm=25"), "explained"):
            self.twin(*effect)
            data = {**self.result("set/dataset.json"), "calibrate": [], "tolerances": "exact"}
            for start in ("at_rest", "measured", "free"):
                for each in data["runs"]:
                    each["start"] = start
                self.write("set/dataset.json", json.dumps(data))
                self.diagnose("scored", "--quiet", "--report", "--force")
                found = self.result("scored/diagnosis.json")
                self.assertEqual((found["verdict"], found["calibration"], found["nominal"]), (verdict, {}, {}), start)
                errors = found["error"]["validate"]
                self.assertEqual(errors["declared"], errors["before"], start)
                self.assertIn("</html>", (self.folder / "scored" / "report.html").read_text())

    def test_a_damping_that_is_declared_as_nothing_takes_no_mass_away(self):
        shutil.copytree(DATA / "measurement" / "swing", self.folder / "set")
        result = run("diagnose", "set", "--out", "out", "--quiet", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        found = json.loads((self.folder / "out" / "diagnosis.json").read_text())
        self.assertEqual((found["verdict"], found["effects"]), ("no_missing_effect", []))
        damping, length = (found["calibration"][key]["ci95"] for key in ("joint_damping_Nmms_rad", "/links/0/com_along_m"))
        self.assertTrue(damping[0] < 0.06 < damping[1], damping)
        self.assertTrue(length[0] < 0.3317 < length[1], length)

    def test_an_answer_that_cannot_be_written_is_printed(self):
        self.take_friction()
        process = subprocess.Popen([PROGRAM, "diagnose", "set", "--out", "late"], cwd=self.folder, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, encoding="utf-8")
        with process:
            while not process.stderr.readline().startswith("recalibrated"):
                self.assertIsNone(process.poll())
            (self.folder / "late" / "summary.txt").mkdir()
            output, errors = process.communicate()
        self.assertEqual((process.returncode, output), (1, self.diagnosed.stdout))
        self.assertEqual(errors.splitlines()[-1], "coilwright: late/summary.txt: cannot be written: Is a directory")

    def test_an_interrupt_ends_with_130_and_leaves_what_is_known(self):
        plan = {**PLAN, "runs": [swing(f"run{i}.csv", "fit", 100 + 40 * i, 0.3 + 0.2 * i) for i in range(8)]}
        self.write("plan.json", json.dumps(plan))
        self.twin("--effect", "dry_friction:torque_Nmm=25", "--effect", "quadratic_drag:drag_Nmms2_rad2=1")
        with subprocess.Popen([PROGRAM, "diagnose", "set", "--out", "out"], cwd=self.folder, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE) as process:
            while not process.stderr.readline().startswith(b"recalibrated"):
                self.assertIsNone(process.poll())
            os.kill(process.pid, signal.SIGINT)
            started = time.monotonic()
            self.assertEqual(process.wait(), 130)
            self.assertLess(time.monotonic() - started, 5)
            summary = process.stdout.read().decode()
            self.assertEqual(process.stderr.read().splitlines()[-1],
                             b"coilwright: interrupted: out has what is known so far, marked as incomplete; --resume goes on from the "
                             b"fits that had ended")
        self.assertEqual({path.name for path in (self.folder / "out").iterdir() if not path.name.startswith("archive.sqlite")},
                         {"diagnosis.json", "actuator.json", "summary.txt", "provenance.json"})
        self.assertEqual(summary, (self.folder / "out" / "summary.txt").read_text())
        self.assertTrue(summary.startswith("rod: incomplete\n\nINTERRUPTED before there was a conclusion."), summary)
        found = self.result("out/diagnosis.json")
        self.assertEqual((found["verdict"], found["effects"]), ("incomplete", []))
        self.assertEqual(self.result("out/actuator.json")["format"], "lumped-model/1")
        page = run("report", "out", cwd=self.folder)
        self.assertEqual(page.returncode, 2)
        self.assertIn("out/diagnosis.json: /verdict: is of a diagnosis that was interrupted: summary.txt has what was "
                      "known then", page.stderr)
        early = run("diagnose", "set", "--out", "early", "--minutes", "1e-6", cwd=self.folder)
        self.assertEqual((early.returncode, early.stdout), (130, ""))
        self.assertEqual(early.stderr.splitlines()[-1], "coilwright: stopped after 1e-06 minutes: nothing is known yet; --resume goes "
                                                        "on from the fits that had ended")
        self.assertEqual({path.name.split("-")[0] for path in (self.folder / "early").iterdir()}, {"archive.sqlite"})


if __name__ == "__main__":
    unittest.main()
