"""provenance.json: which program, files and seed a folder of results is from; and --set of a study."""

import hashlib
import json
import unittest

from program import CONFIGS, ProgramTest, run
from study import FRONT, write_study


def digest(content):
    return hashlib.sha256(content).hexdigest()


class StudyProvenance(ProgramTest):
    def run_study(self, command, *arguments, code=0):
        result = run(command, "study.json", "--out", "out", "--force", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (code, ""))
        return self.result("out/provenance.json")

    def test_it_names_program_files_and_seed(self):
        write_study(self, objectives=FRONT)
        told = self.run_study("pareto", "--seed", "11")
        program = json.loads(run("version", "--json").stdout)
        self.assertEqual({key: told[key] for key in ("program", "version", "commit", "changed_since_commit")},
                         {key: program[key] for key in ("program", "version", "commit", "changed_since_commit")})
        self.assertEqual((told["format"], told["command"], told["seed"], told["set"]), ("provenance/1", "pareto", 11, []))
        files = self.files()
        self.assertEqual(told["inputs"], [{"file": "study.json", "sha256": digest(files["study.json"])},
                                          {"file": "finger.json", "sha256": digest(files["finger.json"])}])
        lines = "".join(each["sha256"] + "\n" for each in told["inputs"])
        self.assertEqual(told["question_sha256"], digest(lines.encode()))

    def test_the_question_is_the_study_its_actuator_and_what_is_set(self):
        write_study(self, objectives=FRONT)
        plain = self.run_study("pareto")
        self.assertEqual(self.run_study("pareto", "--seed", "8", "--threads", "1")["question_sha256"],
                         plain["question_sha256"])
        changed = self.run_study("pareto", "--set", "front_length_mm=9")
        self.assertEqual(changed["set"], ["front_length_mm=9"])
        lines = "".join(each["sha256"] + "\n" for each in changed["inputs"]) + "front_length_mm=9\n"
        self.assertEqual(changed["question_sha256"], digest(lines.encode()))
        self.assertNotEqual(changed["question_sha256"], plain["question_sha256"])
        self.write("finger.json", (self.folder / "finger.json").read_text() + "\n")
        self.assertNotEqual(self.run_study("pareto")["question_sha256"], plain["question_sha256"])

    def test_other_results_have_no_trace_of_the_program(self):
        # Or the references of a study would differ at every commit.
        write_study(self, objectives=FRONT)
        told = self.run_study("pareto")
        for name, content in self.files().items():
            if name.startswith("out/") and name not in ("out/provenance.json", "out/archive.sqlite"):
                self.assertNotIn((told["commit"] or "no commit").encode(), content, name)

    def test_answers_and_sweeps_have_one_too(self):
        write_study(self, search={"max_evaluations": 5, "seed": 3})
        run("size", "study.json", "--out", "out", cwd=self.folder)
        told = self.result("out/provenance.json")
        self.assertEqual((told["command"], told["seed"]), ("size", 3))
        write_study(self, variables={"gap_mm": {"values": [0.8, 1]}}, constraints=[])
        told = self.run_study("sweep")
        self.assertEqual((told["command"], told["seed"]), ("sweep", None))

    def test_a_front_carries_every_quantity_as_evaluate_gives_it(self):
        write_study(self, objectives=FRONT)
        self.run_study("pareto")
        front, rows = self.table("out/front.csv"), self.table("out/evaluations.csv")
        self.assertLessEqual(set(rows[0]) - {"evaluation", "proposed_by", "status", "reason"}, set(front[0]))
        # The same numbers by evaluating the row's design as another command does.
        row = front[len(front) // 2]
        design = [f"--set={name}={row[name]}" for name in ("turns_radial", "wire_gauge_AWG", "gap_mm")]
        result = run("evaluate", "finger.json", "--current-A", row["current_A"], "--duty", "0.5", "--json", *design,
                     cwd=self.folder)
        figures = json.loads(result.stdout)
        # Of a study that asks for no grasp, heat is that of the free finger; evaluate takes both poses.
        for key in ("mass_g", "cost_USD", "steady_angle_cold_deg", "grasp_force_cold_N",
                    "peak_bending_speed_cold_deg_s", "current_over_limit"):
            self.assertAlmostEqual(float(row[key]), figures[key], delta=1e-9 * max(1, abs(figures[key])), msg=key)

    def test_a_comma_in_a_reason_breaks_no_row(self):
        # The paper's magnets have no grade: "... with its coefficient, or the current is ..."
        write_study(self, objectives=FRONT, constraints=[{"quantity": "demagnetisation_margin", "at_least": 0}])
        run("pareto", "study.json", "--out", "out", cwd=self.folder)
        lines = (self.folder / "out/evaluations.csv").read_text()
        rows = self.table("out/evaluations.csv")
        reasons = [row["reason"] for row in rows if "," in row["reason"]]
        self.assertGreater(len(reasons), 0)
        for row in rows:
            self.assertNotIn(None, row)  # a cell beyond the header
            self.assertIn(row["status"], ("ok", "infeasible", "failed"))
        self.assertIn('"' + reasons[0].replace('"', '""') + '"', lines)


class SetOfAStudy(ProgramTest):
    def search(self, *arguments, command="pareto"):
        result = run(command, "study.json", "--out", "out", "--force", *arguments, cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        files = self.files()
        return {name: files[name] for name in files if name.startswith("out/") and name not in ("out/provenance.json", "out/archive.sqlite")}

    def test_by_a_pointer_it_is_the_study_with_that_number_in_its_file(self):
        study = write_study(self, objectives=FRONT)
        changed = self.search("--set", "/constraints/0/at_most=68", "--set", "/operating_point/duty=0.4", "--set",
                              "/operating_point/wiring=series", "--set", "/search/algorithm=cobyla")
        study["constraints"][0]["at_most"] = 68
        study["operating_point"].update(duty=0.4, wiring="series")
        study["search"]["algorithm"] = "cobyla"
        self.write("study.json", json.dumps(study))
        again = self.search()
        self.assertTrue(again == changed)  # assertEqual would spend minutes on telling how they differ

    def test_by_a_name_it_is_the_actuator_as_evaluate_sets_it(self):
        write_study(self, objectives=FRONT, constraints=[])
        self.search("--set", "front_length_mm=12")
        row = self.table("out/front.csv")[0]
        design = [f"--set={name}={row[name]}" for name in ("turns_radial", "wire_gauge_AWG", "gap_mm")]
        figures = json.loads(run("evaluate", "finger.json", "--current-A", "1", "--json", "--set=front_length_mm=12", *design,
                                 cwd=self.folder).stdout)
        self.assertAlmostEqual(float(row["mass_g"]), figures["mass_g"], places=9)

    def test_what_varies_cannot_be_set(self):
        write_study(self)
        self.assert_refused(["size", "study.json", "--out", "out", "--set", "gap_mm=1"],
                            "gap_mm=1: must not set gap_mm, which is a variable of this study")

    def test_a_name_or_a_place_that_does_not_exist_is_refused(self):
        write_study(self)
        for argument, message in (
                ("gap=1", 'gap=1: is not a number of a design; did you mean "gap_mm"?'),
                ("/search/sed=1", 'study.json: /search/sed: unknown key; the keys here are "algorithm", '
                 '"max_evaluations", "seed"'),
                ("/constraints/7/at_most=1", "/constraints/7/at_most=1: must lead to a number, a word, or true or false "
                 "of the study, as /search/seed does; lists count from 0"),
                ("/variables=1", "/variables=1: must lead to a number, a word, or true or false of the study, as "
                 "/search/seed does; lists count from 0"),
                ("/operating_point/wiring=serial",
                 'study.json: /operating_point/wiring: must be one of "parallel", "series"; did you mean "series"?; got text '
                 '"serial"'),
                ("/actuator=other.json",
                 "/actuator=other.json: must not be changed: a study of another actuator is another file"),
                ("/constraints/0/at_most=x", "/constraints/0/at_most=x: must be a finite number"),
                ("duty=0.4", "duty=0.4: is not a number of a design but of the study's file: --set /operating_point/duty=VALUE"),
                ("driver_voltage_V=8", 'driver_voltage_V=8: must be of a block that the study has: it has no "driver"; '
                 "write that block into it (coilwright schema study)"),
                ("front_length_mm=0", "front_length_mm=0: must be from 0.05 to 1000")):
            with self.subTest(argument):
                self.assert_refused(["size", "study.json", "--out", "out", "--set", argument], message)
        self.assert_refused(["size", "study.json", "--out", "out", "--set", "front_length_mm=9", "--set",
                             "front_length_mm=8"],
                            "front_length_mm=8: must not be there twice: front_length_mm=9 sets it too")

    def test_a_number_of_a_block_is_set_by_its_pointer(self):
        write_study(self, driver={"kind": "h_bridge", "voltage_V": 24})
        self.assert_refused(["size", "study.json", "--out", "out", "--set", "driver_voltage_V=8"],
                            "driver_voltage_V=8: is not a number of a design but of the study's file: --set /driver/voltage_V=VALUE")

    def test_the_study_s_own_actuator_keeps_the_limits_where_a_current_does(self):
        # Faster with every ampere, and half of the 1.4 A that its wire of AWG 28 bears is all that this study allows.
        write_study(self, variables={"current_A": {"lower": 0.2, "upper": 1.2, "step": 0.05},
                                     "gap_mm": {"lower": 0.7, "upper": 1.6}}, operating_point={"duty": 0.5},
                    constraints=[{"quantity": "current_over_limit", "at_most": 0.501}],
                    search={"max_evaluations": 5, "seed": 1})
        self.search(command="size")
        base = self.result("out/result.json")["base"]
        self.assertEqual(base["current_A"], 0.7)


class DatasetProvenance(ProgramTest):
    def test_twin_tells_the_files_and_nothing_of_the_answer(self):
        result = run("twin", CONFIGS / "actuators/paper_finger.json", "--experiment",
                     CONFIGS / "experiments/paper.json", "--effect", "dry_friction:torque_Nmm=0.6", "--seed", "7",
                     "--out", "set", "--json", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        told = self.result("set/provenance.json")
        self.assertEqual((told["command"], told["seed"], told["set"], len(told["inputs"])), ("twin", None, [], 2))
        self.assertNotIn("friction", (self.folder / "set/provenance.json").read_text())
        printed = json.loads(result.stdout)
        self.assertEqual((printed["folder"], printed["answer"]), ("set", "set.answer.json"))


if __name__ == "__main__":
    unittest.main()
