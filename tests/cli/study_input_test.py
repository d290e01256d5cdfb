"""Every way to get a study wrong: one line, exit code 2, and every file as it was."""

import json
import unittest

from program import ProgramTest, run
from study import FRONT, write_study

QUANTITY_RULE = "must be a quantity that evaluate prints"


class StudyInput(ProgramTest):
    def refused(self, message, command="size"):
        # What stands in the output folder from an earlier run must stay.
        out = self.folder / "out"
        out.mkdir(exist_ok=True)
        (out / "result.json").write_text("precious")
        self.assert_refused([command, "study.json", "--out", "out"], "study.json: " + message)

    def test_bad_values_and_keys(self):
        variables = {"gap_mm": {"lower": 0.7, "upper": 1.6}}

        def variable(name, **content):
            return {"variables": {name: content}}

        def constraints(*limits):
            return {"constraints": list(limits)}

        share = {"current_share_2": {"lower": 0, "upper": 1}}
        for changes, message in (
            ({"variables": {"current_share_3": {"lower": 0, "upper": 1}}},
             "/variables/current_share_3: must be of a coil that there is: the actuator has 2"),
            ({"variables": {"current_share_2": {"lower": 0, "upper": 1.5}}}, "/variables/current_share_2/upper: must be from -1 to 1; got 1.5"),
            ({"variables": share, "operating_point": {"current_A": 1, "wiring": "series"}},
             "/operating_point/wiring: must be parallel where coils have shares of the current: in series there is one"),
            ({"objective": FRONT[0]}, '/objective: unknown key; the keys here are "actuator", "columns", '
             '"constraints", "crawler", "description", "driver", "format", "gripper", "name", "objectives", "operating_point", "search", '
             '"spread", "variables"'),
            ({"objectives": None, "objective": FRONT},
             '/objectives: is missing; is "objective" meant to be it?'),
            ({"variables": None}, "/variables: is missing"),
            ({"variables": {}}, "/variables: needs at least one variable"),
            ({"objectives": []}, "/objectives: must have 1 to 3 elements; got an array of 0"),
            ({"objectives": FRONT * 2}, "/objectives: must have 1 to 3 elements; got an array of 4"),
            ({"objectives": [FRONT[0], {"minimise": "peak_bending_speed_deg_s"}]},
             "/objectives/1: asks for a quantity twice"),
            ({"objectives": [{"maximise": "peak_speed"}]}, "/objectives/0/maximise: " + QUANTITY_RULE +
             '; did you mean "peak_speed_time_s"?; got text "peak_speed"'),
            ({"objectives": [{"maximise": "mass_kg"}]}, "/objectives/0/maximise: " + QUANTITY_RULE +
             '; did you mean "mass_g"?; got text "mass_kg"'),
            ({"objectives": [{"maximise": "mass"}]}, "/objectives/0/maximise: " + QUANTITY_RULE +
             '; did you mean "mass_g"?; got text "mass"'),
            (variable("turns", lower=10, upper=12), '/variables/turns: is not a variable of a design; did you mean '
             '"turns_radial" or "turns_axial"?'),
            ({"search": {"max": 3}}, '/search/max: unknown key; did you mean "max_evaluations"?'),
            ({"objectives": [{"maximum": "mass_g"}]},
             '/objectives/0: needs one of "maximise", "minimise", "maximize", "minimize"'),
            ({"objectives": [{"maximise": "mass_g", "minimize": "mass_g"}]},
             '/objectives/0/minimize: cannot stand beside "maximise"'),
            ({"objectives": [{"maximise": 3}]}, "/objectives/0/maximise: must be a text; got 3"),
            (variable("gap_m", lower=1, upper=2), '/variables/gap_m: is not a variable of a design; did you mean '
             '"gap_mm"?'),
            (variable("gap_mm", lower=2, upper=1.5), "/variables/gap_mm/upper: must not be below lower (2); got 1.5"),
            (variable("gap_mm", lower=-1, upper=1), "/variables/gap_mm/lower: must be from 0.05 to 1000; got -1"),
            (variable("gap_mm", lower="1", upper=2), '/variables/gap_mm/lower: must be a number; got text "1"'),
            (variable("gap_mm", lower=1), "/variables/gap_mm/upper: is missing"),
            (variable("gap_mm"), '/variables/gap_mm: needs one of "lower", "values"'),
            (variable("gap_mm", values=[1], upper=2), '/variables/gap_mm/upper: unknown key; the keys here are '
             '"lower", "values"'),
            (variable("gap_mm", lower=1, upper=2, values=[1]), '/variables/gap_mm/values: cannot stand beside "lower"'),
            (variable("gap_mm", lower=1, upper=2, step=0), "/variables/gap_mm/step: must be > 0; got 0"),
            (variable("gap_mm", lower=1, upper=2, step=1.5),
             "/variables/gap_mm/step: must not exceed upper - lower (1); got 1.5"),
            (variable("gap_mm", lower=1, upper=2, step=1e-9),
             "/variables/gap_mm/step: must make at most 1000000 values; got 1e-09"),
            (variable("gap_mm", values=[]), "/variables/gap_mm/values: must have 1 to 1000000 elements; got an array of 0"),
            (variable("gap_mm", values=[1, 2, 2]),
             "/variables/gap_mm/values/2: must exceed the value before it (2); got 2"),
            (variable("turns_radial", lower=8.5, upper=12),
             "/variables/turns_radial/lower: must be a whole number; got 8.5"),
            (variable("turns_radial", lower=8, upper=12, step=0.5),
             "/variables/turns_radial/step: must be a whole number; got 0.5"),
            (variable("turns_radial", lower=0, upper=12),
             "/variables/turns_radial/lower: must be from 1 to 10000; got 0"),
            (variable("wire_gauge_AWG", values=[28, 51]),
             "/variables/wire_gauge_AWG/values/1: must be from 10 to 50; got 51"),
            (variable("wire_gauge_AWG", lower=9, upper=30),
             "/variables/wire_gauge_AWG/lower: must be from 10 to 50; got 9"),
            (variable("configuration", values=["A", "E"]),
             '/variables/configuration/values/1: must be one of "A", "B", "C", "D"; got text "E"'),
            (variable("configuration", values=["A", "A"]),
             '/variables/configuration/values/1: must not be there twice; got text "A"'),
            (variable("configuration", lower="A", upper="C"), "/variables/configuration/values: is missing"),
            (variable("current_A", lower=0.1, upper=1), "/operating_point/share_of_current_limit: sets the current, "
             "which is a variable of this study too"),
            ({"operating_point": None}, "/operating_point: is missing"),
            ({"operating_point": {"duty": 0.5}}, '/operating_point: needs one of "current_A", "share_of_current_limit"'),
            ({"operating_point": {"current_A": 1, "share_of_current_limit": 1}},
             '/operating_point/share_of_current_limit: cannot stand beside "current_A"'),
            ({"operating_point": {"current_mA": 900}},
             '/operating_point/current_mA: unknown key; did you mean "current_A"?'),
            ({"operating_point": {"current_A": 1, "duty": 1.2}}, "/operating_point/duty: must be from 0 to 1; got 1.2"),
            ({"operating_point": {"share_of_current_limit": 0}},
             "/operating_point/share_of_current_limit: must be > 0 and <= 1000; got 0"),
            ({"objectives": [{"maximise": "grasp_forc_N / mass_g", "name": "grip", "unit": "N/g"}]},
             '/objectives/0/maximise: names "grasp_forc_N", which is no quantity; did you mean "grasp_force_N"?; '
             'got text "grasp_forc_N / mass_g"'),
            ({"objectives": [{"maximise": "grasp_force_N / mass_g", "name": "grip"}]}, "/objectives/0/unit: is missing"),
            ({"objectives": [{"maximise": "grasp_force_N / mass_g", "name": "grip", "unit": "N g"}]},
             '/objectives/0: unit: must be written in letters, digits and "/", "N/g", or be 1 for a plain number; got "N g"'),
            ({"objectives": [{"maximise": "grasp_force_N / (mass_g", "name": "grip", "unit": "N/g"}]},
             "/objectives/0/maximise: must be an expression of quantities: Missing parenthesis; "
             'got text "grasp_force_N / (mass_g"'),
            (constraints({"quantity": "2 * 3", "name": "six", "unit": "1", "at_most": 7}),
             "/constraints/0/quantity: must contain a quantity: this is the same number for every design; "
             'got text "2 * 3"'),
            (constraints({"quantity": "mass_g"}), '/constraints/0: needs one of "at_most", "at_least"'),
            (constraints({"quantity": "mass_g", "at_most": 60, "at_least": 50}),
             '/constraints/0/at_least: cannot stand beside "at_most"'),
            (constraints({"at_most": 60}), "/constraints/0/quantity: is missing"),
            (constraints({"quantity": "weight_g", "at_most": 60}), "/constraints/0/quantity: " + QUANTITY_RULE +
             '; coilwright list quantities has them all; got text "weight_g"'),
            (constraints({"quantity": "mass_g", "at_most": 60}, {"quantity": "mass_g", "at_most": 70}),
             "/constraints/1: limits the same side of a quantity twice"),
            (constraints({"quantity": "mass_g", "at_most": 60}, {"quantity": "mass_g", "at_least": 61}),
             "/constraints/1: contradicts an earlier limit: mass_g cannot be >= 61 and <= 60"),
            ({"search": {"algorithm": "magic"}}, None),
            ({"search": {"max_evaluations": 0}}, "/search/max_evaluations: must be from 1 to 1000000000; got 0"),
            ({"search": {"seed": -1}}, "/search/seed: must be >= 0; got -1"),
            ({"search": {"threads": 2}}, '/search/threads: unknown key; the keys here are "algorithm", '
             '"max_evaluations", "seed"'),
            ({"name": 3}, "/name: must be a text; got 3"),
            ({"name": "\x1b[31mred"}, '/name: must be one line without control characters; got text "\\x1b[31mred"'),
            *(({"objectives": [{"maximise": "grasp_force_N / mass_g", "name": name, "unit": unit}]},
               f'/objectives/0/name: makes a name that is taken ("{made}"); got text "{name}"')
              for name, unit, made in (("status", "1", "status"), ("took", "s", "took_s"), ("gap", "mm", "gap_mm"),
                                       ("mass_max_margin", "g", "mass_max_margin_g"))),
            ({"format": "study/2"}, '/format: must be "study/1"; got text "study/2"'),
            ({"actuator": ""}, '/actuator: must be a path; got text ""'),
        ):
            write_study(self, **{"variables": variables, **changes})
            with self.subTest(message):
                if message:
                    self.refused(message)
                else:
                    result = run("size", "study.json", "--out", "out", "--force", cwd=self.folder)
                    self.assertEqual(result.returncode, 2)
                    self.assertRegex(result.stderr, r"^coilwright: study\.json: /search/algorithm: .*cobyla.*\n$")

    def test_every_command_refuses_alike(self):
        write_study(self, variables={})
        for command in ("size", "sweep", "pareto"):
            self.refused("/variables: needs at least one variable", command)

    def test_a_study_that_is_no_json(self):
        text = json.dumps(write_study(self))
        with_nan = text.replace("0.7", "NaN")
        for damaged, message in (
            (text.replace('"gap_mm"', '"gap_mm": 1, "gap_mm"'), "/variables/gap_mm: duplicate key"),
            (with_nan, f"line 1, column {with_nan.index('NaN') + 1}: must be a finite number: JSON has no NaN and no "
             "Infinity"),
            (text.replace("0.7", "1e999"),
             "/variables/gap_mm/lower: must be a finite number (at most 1.8e308); got 1e999"),
            (text[:-7], f"line 1, column {len(text) - 6}: ends before its JSON value is complete"),
            ("", "line 1, column 1: is empty: it must hold a JSON value"),
            ("[]", "/: must be an object; got an array of 0"),
            ("study: 1", "line 1, column 1: is not JSON: syntax error while parsing value - invalid literal"),
        ):
            self.write("study.json", damaged)
            with self.subTest(message):
                self.refused(message)

    def test_a_study_of_100_mb_is_refused_at_once(self):
        with open(self.folder / "large.json", "wb") as file:
            file.truncate(100_000_000)
        result = run("size", "large.json", "--out", "out", cwd=self.folder)
        self.assertEqual((result.returncode, result.stderr),
                         (2, "coilwright: large.json: must not be larger than 16 MB\n"))
        self.assertFalse((self.folder / "out").exists())

    def test_an_actuator_that_cannot_be_used_is_named_by_its_own_file(self):
        write_study(self, actuator="absent.json")
        self.assert_refused(["size", "study.json", "--out", "out"],
                            'study.json: /actuator: must name the file of an actuator, and there is no absent.json; got text '
                            '"absent.json"')
        write_study(self)
        actuator = json.loads((self.folder / "finger.json").read_text())
        actuator["body"]["gap_mm"] = -1
        self.write("finger.json", json.dumps(actuator))
        self.assert_refused(["size", "study.json", "--out", "out"],
                            "finger.json: /body/gap_mm: must be from 0.05 to 1000; got -1")
        self.write("finger.json", json.dumps(
            {"format": "lumped-model/1", "joints": [{"stiffness_Nm_rad": 0.01, "damping_Nms_rad": 1e-4}],
             "links": [{"length_m": 0.02, "com_along_m": 0.01, "com_offset_m": 0.004, "mass_kg": 0.02,
                        "inertia_kgm2": 0}]}))
        self.refused('/actuator: must be a design (actuator/1): a lumped model has no geometry to vary; got text '
                     '"finger.json"')

    def test_an_actuator_s_path_counts_from_the_study(self):
        write_study(self)
        result = run("size", self.folder / "study.json", "--out", self.folder / "out", "--max-evaluations", "2", cwd="/")
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def test_a_folder_that_cannot_be_written_is_refused_before_the_work(self):
        write_study(self, search={"max_evaluations": 100000000}, objectives=FRONT)
        self.write("file", "precious")
        for out in ("file", "file/out"):
            self.assert_refused(["pareto", "study.json", "--out", out], f"{out}: cannot be written: Not a directory")
        result = run("pareto", "study.json", "--out", "/proc/out", cwd=self.folder)
        self.assertEqual(result.returncode, 2)
        self.assertRegex(result.stderr, r"^coilwright: /proc/out: cannot be written: .+\n$")


if __name__ == "__main__":
    unittest.main()
