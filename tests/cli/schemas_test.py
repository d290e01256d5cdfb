"""configs/schemas: what ships follows them, what they refuse the program refuses too, and their names and bounds are the
program's."""

import copy
import json
import re
import shutil
import unittest
import warnings

import jsonschema

from program import CONFIGS, DATA, PAPER_FINGER, ProgramTest, run
from study import size_plain_finger

ROOT = CONFIGS.parent
SCHEMAS = {path.name: json.loads(path.read_text()) for path in sorted((CONFIGS / "schemas").glob("*.schema.json"))}
FORMATS = {"actuator/1": "actuator", "lumped-model/1": "lumped-model", "study/1": "study",
           "measured-data/1": "measured-data", "experiment/1": "experiment"}
# An unknown name after --set, and a pose that no file has, are told once the file has been read, and before anything is computed.
READ_ONLY = ["--set", "nothing=1"]
NO_POSE = ["--at", "0", "0", "0", "--pose", "1000000"]
NOTHING_FEASIBLE = 3
WAS_READ = re.compile(r"nothing=1: is not a number of a design|is a lumped model: --set changes designs only|--pose: must be at most ")


# What a study may build from its actuator: every key.
BLOCKS = {"gripper": {"mounting_angle_deg": 30, "spacing_mm": 65, "polarity": "same", "shape": "box", "width_mm": 60,
                      "height_mm": 40, "mass_g": 40, "friction": 0.8, "centre_x_mm": 1, "centre_below_palm_mm": 20,
                      "open_current_A": -0.5, "acceleration_m_s2": 1, "least_current_up_to_A": 1.4},
          "crawler": {"friction_forwards": 0.3, "friction_backwards": 0.6, "frequency_Hz": 10, "duty": 0.5,
                      "cell_voltage_V": 4.2, "cell_capacity_mAh": 150, "cell_limit_A": 3, "lead_resistance_Ohm": 0.12,
                      "payload_mass_g": 23, "payload_length_mm": 30, "step_ms": 0.2, "settling_periods": 1, "periods": 1},
          "driver": {"kind": "h_bridge", "voltage_V": 24, "resistance_Ohm": 0.1, "switch_resistance_Ohm": 0.5, "frequency_Hz": 20000,
                     "most_current_A": 3}}


def validator(name):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # since 4.18, beyond Debian's
        resolver = jsonschema.RefResolver(f"file:///{name}.schema.json", SCHEMAS[f"{name}.schema.json"],
                                          store={f"file:///{file}": schema for file, schema in SCHEMAS.items()})
        return jsonschema.Draft202012Validator(SCHEMAS[f"{name}.schema.json"], resolver=resolver)


VALIDATORS = {file.removesuffix(".schema.json"): validator(file.removesuffix(".schema.json")) for file in SCHEMAS}


def schema_of(document):
    return FORMATS.get(document.get("format"), "pair")


def faults(document, name=None):
    return [f"/{'/'.join(map(str, error.absolute_path))}: {error.message[:200]}"
            for error in VALIDATORS[name or schema_of(document)].iter_errors(document)]


def data_file(name):
    return json.loads((DATA / "formats" / name).read_text())


def changed(document, pointer, value):
    """A copy with another value at a JSON pointer; None removes the key."""
    out = copy.deepcopy(document)
    *parents, last = [int(step) if step.isdigit() else step for step in pointer.split("/")[1:]]
    at = out
    for step in parents:
        at = at[step]
    if value is None:
        del at[last]
    else:
        at[last] = value
    return out


def resolved(schema, file):
    """The schema behind a $ref, and the file that it is in."""
    while "$ref" in schema:
        target, _, pointer = schema["$ref"].partition("#")
        file = target or file
        schema = {**schema, **SCHEMAS[file]}
        del schema["$ref"]
        if pointer:
            schema = SCHEMAS[file]
            for step in pointer.split("/")[1:]:
                schema = schema[step]
    return schema, file


def number_rules(schema, document, file, pointer=""):
    """Pointer and schema of every number of a document."""
    schema, file = resolved(schema, file)
    if isinstance(document, dict):
        for key, value in document.items():
            if key in schema.get("properties", {}):
                yield from number_rules(schema["properties"][key], value, file, f"{pointer}/{key}")
    elif isinstance(document, list):
        for index, value in enumerate(document):
            yield from number_rules(schema.get("items", {}), value, file, f"{pointer}/{index}")
    elif isinstance(document, (int, float)) and not isinstance(document, bool):
        yield pointer, schema


def outside(rule):
    """Numbers next to the bounds that are not allowed."""
    for key, sign in (("minimum", -1), ("maximum", 1)):
        if key in rule:
            yield rule[key] + sign * max(1e-6 * abs(rule[key]), 1e-12)
    for key in ("exclusiveMinimum", "exclusiveMaximum"):
        if key in rule:
            yield rule[key]
    if rule.get("type") == "integer":
        yield rule["minimum"] + 0.5
    if "enum" in rule:
        yield max(rule["enum"]) + 0.5


# Other names of the wire and of a silicone's stiffness, and what a magnet has of its grade: there is none by itself.
OTHER_NAMES = ("wire_diameter_mm", "wire_overall_mm", "shore_hardness_00", "youngs_modulus_MPa")
OF_A_GRADE = ("coercivity_kA_m", "remanence_coefficient_pct_K", "coercivity_coefficient_pct_K", "recoil_permeability")


def defaults(section):
    """What a section of an actuator has where a file says nothing; a reference of its calibration is not made up."""
    return {key: rule["default"] for key, rule in section["properties"].items()
            if key not in ("hinge_reference", "comment", *OTHER_NAMES, *OF_A_GRADE)}


def with_comments(document):
    """A copy each with a comment in one of its objects."""
    def objects(value, pointer=""):
        if isinstance(value, dict):
            yield pointer
            for key, below in value.items():
                yield from objects(below, f"{pointer}/{key}")
        elif isinstance(value, list):
            for index, below in enumerate(value):
                yield from objects(below, f"{pointer}/{index}")

    for pointer in objects(document):
        yield pointer, changed(document, pointer + "/comment", "what this is for")


def inside(rule):
    """The bounds that are allowed."""
    yield from (rule[key] for key in ("minimum", "maximum") if key in rule)
    yield from rule.get("enum", [])


class Schemas(unittest.TestCase):
    def test_are_schemas(self):
        for name, schema in SCHEMAS.items():
            with self.subTest(name):
                jsonschema.Draft202012Validator.check_schema(schema)
                self.assertTrue(schema["title"] and schema["description"])

    def test_describe_every_number(self):
        # Of a number or a choice an editor shows the description.
        def numbers(schema, file, path):
            for key, value in schema.get("properties", {}).items():
                if isinstance(value, dict):
                    yield f"{path}/{key}", value, file
                    yield from numbers(value, file, f"{path}/{key}")
            if isinstance(schema.get("items"), dict):
                yield from numbers(schema["items"], file, path)
            for option in schema.get("oneOf", []):
                yield from numbers(option, file, path)

        for file in ("actuator.schema.json", "effects.schema.json", "lumped-model.schema.json"):
            for path, schema, where in numbers(SCHEMAS[file], file, file):
                target = resolved(schema, where)[0]
                if target.get("type") in ("number", "integer"):
                    self.assertTrue(schema.get("description") or target.get("description"), path)

    def test_accept_all_that_ships(self):
        files = [path for folder in ("configs", "studies", "tests/data", "results/reference")
                 for path in sorted((ROOT / folder).rglob("*.json"))
                 if "schemas" not in path.parts and path.name not in ("answer.json", "result.json", "reference.json")]
        met = set()
        for path in files:
            document = json.loads(path.read_text())
            if document.get("format") not in FORMATS and path.parent != DATA / "formats":
                continue  # a result, or figures to compare with
            with self.subTest(path.relative_to(ROOT)):
                self.assertEqual(faults(document), [])
                met.add(schema_of(document))
        self.assertEqual(met | {"effects", "as-built", "torque-correction"}, set(VALIDATORS))

    def test_accept_the_examples_of_the_documents(self):
        examples = [text for page in sorted((ROOT / "docs").glob("formats*.md"))
                    for text in re.findall(r"```json \w+\n(.*?)```", page.read_text(), re.DOTALL)]
        self.assertGreaterEqual(len(examples), 14)
        for text in examples:
            self.assertEqual(faults(json.loads(text)), [])


class SchemasAndProgram(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(DATA / "formats" / "dataset", self.folder, dirs_exist_ok=True)
        for file in (DATA / "formats" / "actuator.json", DATA / "formats" / "lumped_model.json",
                     DATA / "formats" / "input.csv", CONFIGS / "actuators" / "finger.json"):
            shutil.copy(file, self.folder)

    def refusal(self, schema, document, searches=False):
        """What the program says of a file that it does not take; empty if it takes it. A study is read, and not searched
        but where the test asks for it: keys beside its blocks are looked at only then."""
        command = {"actuator": ["evaluate", "input.json", "--current-A", "0.5", *READ_ONLY],
                   "lumped-model": ["evaluate", "input.json", "--current-A", "0.5", *READ_ONLY],
                   "pair": ["field", "input.json", *NO_POSE],
                   "study": ["pareto", "input.json", "--out", "out", "--force", "--max-evaluations", "3",
                             *([] if searches else READ_ONLY)],
                   "measured-data": ["diagnose", "input.json", "--actuator", "finger.json", "--out", "found"],
                   "experiment": ["twin", "lumped_model.json", "--experiment", "input.json", "--out", "made"]}[schema]
        self.write("input.json", json.dumps(document))
        result = run(*command, cwd=self.folder)
        if result.returncode in (0, NOTHING_FEASIBLE) or WAS_READ.search(result.stderr):
            return ""
        self.assertEqual(result.returncode, 2, result.stderr)
        return result.stderr

    def test_refuse_the_same(self):
        bases = {name: data_file(f"{name}.json") for name in ("actuator", "lumped_model", "pair", "two_coils",
                                                              "two_magnets", "bodies", "study", "experiment")}
        bases["experiment"]["runs"][2]["start_angles_deg"] = [9, 3]  # of the two joints of lumped_model.json
        bases["dataset"] = data_file("dataset/dataset.json")
        table = [
            ("actuator", "/colour", "red"), ("actuator", "/format", "actuator/2"), ("actuator", "/format", 1),
            ("actuator", "/layout", None), ("actuator", "/layout/0", "iron"), ("actuator", "/layout", ["coil"]),
            ("actuator", "/layout", ["coil", "coil"]), ("actuator", "/polarity/1", 2), ("actuator", "/configuration", "B"),
            ("actuator", "/polarity/1", "1"), ("actuator", "/coil", 3), ("actuator", "/coil/turns_radial", 14.5),
            ("actuator", "/coil/radius_mm", 3), ("actuator", "/coil/wire_gauge_AWG", 51), ("actuator", "/coil/wire_diameter_mm", 0.25), ("actuator", "/coil/enamel", "grade_3"), ("actuator", "/body/silicone", "Ecoflex"), ("actuator", "/body/youngs_modulus_MPa", 0.1), ("actuator", "/bottom_layer_silicone", {"gap_mm": 1}), ("actuator", "/bottom_layer_silicone", {"shore_hardness_A": 30, "youngs_modulus_MPa": 1}),
            ("actuator", "/magnet/length_m", 0.006), ("actuator", "/magnet/grade", "N99"), ("actuator", "/magnet/grade", 52), ("actuator", "/body/gap_mm", "0.9"), ("actuator", "/body/gap_mm", 0),
            ("actuator", "/body/shore_hardness_A", 19), ("actuator", "/surroundings/ambient_degC", -300),
            ("actuator", "/model/winding", "shells"), ("actuator", "/measured/mass_g", 3),
            ("actuator", "/calibration", {}), ("actuator", "/name", 3), ("actuator", "/$schema", 3),
            ("actuator", "/as_built", {"joint_stiffness_ratio": 3}), ("actuator", "/as_built", {"ratio": 0.1}),
            ("actuator", "/as_built", {"force_curve": {"from_deg": 0, "to_deg": 60, "coefficients": [0, 0, 0]}}),
            ("actuator", "/torque_correction", {"torque_Nmm": [1, 2, 3]}),
            ("actuator", "/torque_correction", {"angle_deg": [0, 1], "torque_Nmm": [1, 2]}),
            ("actuator", "/torque_correction", {"angle_deg": [0, 1, 2], "linear_below_rad_s": 1, "torque_Nmm": [1, 2, 3]}),
            ("dataset", "/tolerances", "none"), ("dataset", "/tolerances", {"mass": 1}),
            ("dataset", "/tolerances", {"force_curve": -1}),
            ("dataset", "/runs/0/exposure_s", -1), ("dataset", "/runs/0/rig", {"coil": "closed"}),
            ("dataset", "/runs/0/input_hold", "held"), ("experiment", "/outliers", {"share": 2}),
            ("experiment", "/noise_colour", {"angle_deg": {"kind": "low_pass"}}),
            ("actuator", "/effects", {}), ("actuator", "/effects", [{"id": "friction"}]),
            ("actuator", "/effects", [{"id": "dry_friction"}]),
            ("actuator", "/effects", [{"id": "dry_friction", "parameters": {"torque_Nmm": -1}}]),
            ("actuator", "/effects", [{"id": "dry_friction", "parameters": {"torque_Nm": 1}}]),
            ("actuator", "/effects", [{"id": "dry_friction", "parameters": {"torque_Nmm": 1}, "note": ""}]),
            ("actuator", "/effects", [{"parameters": {"torque_Nmm": 1}}]),
            ("lumped_model", "/links", []), ("lumped_model", "/links/0/mass_kg", 0), ("lumped_model", "/links/0/mass_kg", None),
            ("lumped_model", "/links/0/mass_g", 3), ("lumped_model", "/joints", None),
            ("lumped_model", "/joints/0/stiffness_Nm_rad", -1), ("lumped_model", "/joints/0/rotor_inertia_kgm2", -1),  ("lumped_model", "/joints/0/contact/stiffness_Nm_rad", 0),
            ("lumped_model", "/joints/0/contact/closing_angle_deg", None), ("lumped_model", "/gravity_m_s2", -9.81), ("lumped_model", "/gravity_m_s2", 9810),
            ("actuator", "/surroundings", {"gravity_m_s2": 9810}), ("actuator", "/magnet/remanence_T", 14.4),
            ("lumped_model", "/magnetics/1/torque_Nmm_A", None), ("lumped_model", "/magnetics/1/angle_deg", [0, 1, 2]),
            ("lumped_model", "/magnetics/1/angle_rad", [0, 1, 2, 3]), ("lumped_model", "/magnetics/0", {}),
            ("lumped_model", "/magnetics/1/coil", {}),
            ("pair", "/poses", []), ("pair", "/poses", None), ("pair", "/magnet", None), ("pair", "/magnet/remanence_T", 2.1),
            ("pair", "/coil/turns_axial", 0), ("pair", "/currents_A", [1, 2]), ("pair", "/current_A", None),
            ("pair", "/current_A", 2e6), ("pair", "/winding", "round"), ("pair", "/poses/0/axis", [0, 0]),
            ("pair", "/poses/0/position_mm/1", "0"), ("pair", "/magnets", []), ("pair", "/format", "pair/1"),
            ("two_coils", "/current_A", 1), ("two_coils", "/currents_A", [1]), ("two_coils", "/currents_A", None),
            ("two_coils", "/coils/1", None), ("two_magnets", "/current_A", 1), ("two_magnets", "/magnets/0/radius_mm", -4),
            ("bodies", "/bodies", []), ("bodies", "/bodies/0/magnet/length_mm", 5), ("bodies", "/bodies/0/magnet/size_mm", [1, 2]),
            ("bodies", "/bodies/0/current_A", 1), ("bodies", "/bodies/1/current_A", None), ("bodies", "/bodies/1/magnet", {}),
            ("bodies", "/bodies/2/magnet/outer_radius_mm", None), ("bodies", "/bodies/2/magnet/radius_mm", 3),
            ("bodies", "/bodies/0/magnet/magnetised_along", [1, 0]), ("bodies", "/plate/thickness_mm", None),
            ("bodies", "/plate/radius_m", 1), ("bodies", "/current_A", 1), ("bodies", "/bodies/0/name", 3),
            ("study", "/name", None), ("study", "/actuator", 3), ("study", "/variables", {}), ("study", "/variables/gap", {}),
            ("study", "/variables/gap_mm/values", [1]), ("study", "/variables/gap_mm/lower", -1),
            ("study", "/variables/gap_mm/upper", None), ("study", "/variables/gap_mm/step", 0),
            ("study", "/variables/turns_radial/lower", 5.5), ("study", "/variables/wire_gauge_AWG/values", []),
            ("study", "/variables/wire_gauge_AWG/values", [26, 26]), ("study", "/variables/wire_gauge_AWG/values/0", 9), ("study", "/variables/layout", {"values": [["coil"]]}), ("study", "/variables/polarity", {"values": [[1, 2]]}), ("study", "/variables/silicone", {"values": ["rubber"]}), ("study", "/objectives/0/maximise", "joint17_angle_deg"),
            ("study", "/variables/configuration/values", ["E"]), ("study", "/variables/magnet_grade", {"values": ["N99"]}),
            ("study", "/variables/magnet_grade", {"lower": 1, "upper": 3}), ("study", "/variables/magnet_grade", {"values": [3]}), ("study", "/variables/configuration/values", ["A", "A"]),
            ("study", "/variables/current_A", {"lower": 0, "upper": 1}), ("study", "/operating_point", None),
            ("study", "/operating_point/current_A", 1), ("study", "/operating_point/duty", 1.5),
            ("study", "/operating_point/share_of_current_limit", 0), ("study", "/objectives", []),
            ("study", "/objectives/0", {}), ("study", "/objectives/0/maximise", "speed"),
            ("study", "/objectives/0/minimise", "mass_g"), ("study", "/constraints/0/quantity", "mass_kg"),
            ("study", "/constraints/0/at_most", None), ("study", "/constraints/0/at_least", 1),
            ("study", "/constraints/0/at_most", "66"), ("study", "/search/algorithm", "newton"),
            ("study", "/search/seed", -1), ("study", "/search/seed", 1.5), ("study", "/search/max_evaluations", 0),
            ("study", "/gripper", {}), ("study", "/gripper", {"width_mm": 60, "mass_g": 40, "friction": 1, "shape": "box"}),
            ("study", "/gripper", {"width_mm": 60, "mass_g": 40, "friction": 1, "height_mm": 40}),
            ("study", "/gripper", {"width_mm": 60, "mass_g": 40, "friction": 1, "shape": "ball"}),
            ("study", "/crawler", {"friction_forwards": 1}), ("study", "/columns", ["mass_g"]),
            ("study", "/columns", [{"quantity": "mass_kg"}]), ("study", "/operating_point/current_of", "cell"),
            ("experiment", "/name", None), ("experiment", "/runs", []), ("experiment", "/sampling_rate_Hz", None),
            ("experiment", "/sampling_rate_Hz", 0), ("experiment", "/measure", ["angle_deg"]), ("experiment", "/measure", []),
            ("experiment", "/noise/angle_rad", 0.1), ("experiment", "/noise/angle_deg", -0.1),
            ("experiment", "/runs/0/file", "a.txt"), ("experiment", "/runs/0/file", "sub/a.csv"),
            ("experiment", "/runs/0/role", "test"), ("experiment", "/runs/0/kind", "motion"),
            ("experiment", "/runs/0/duration_s", None), ("experiment", "/runs/0/duration_s", 0),
            ("experiment", "/runs/0/input", None), ("experiment", "/runs/0/input/sine", {}),
            ("experiment", "/runs/0/input/step/after_A", None), ("experiment", "/runs/0/input/step/after_V", 1),
            ("experiment", "/runs/0/input", {"levels": {"at_s": [0.1], "level_A": [1]}}),
            ("experiment", "/runs/0/input", {"levels": {"at_s": [0], "level_V": [1]}}),
            ("experiment", "/runs/0/input", {"levels": {"at_s": [0], "level_A": ["1"]}}),
            ("experiment", "/runs/0/input/step/at_s", -1), ("experiment", "/runs/0/drive", "voltage"),
            ("experiment", "/runs/0/coil", 0), ("experiment", "/runs/0/joint", 1), ("experiment", "/runs/1/coil", 1),
            ("experiment", "/runs/0/start_angles_deg", [9]), ("experiment", "/runs/2/start_angles_deg", [200]),
            ("experiment", "/runs/3/currents_A", None), ("experiment", "/runs/3/angles_deg", []),
            ("experiment", "/runs/3/input", {}), ("experiment", "/runs/3/measure", ["theta1_deg"]),
            ("dataset", "/runs", []), ("dataset", "/runs/0/file", ""), ("dataset", "/runs/0/kind", "step"),
            ("dataset", "/runs/0/role", None), ("dataset", "/runs/0/role", "test"), ("dataset", "/runs/0/drive", "pressure"),
            ("dataset", "/runs/0/start", "anywhere"), ("dataset", "/runs/0/window_s", 0), ("dataset", "/runs/0/sigma", 0),
            ("dataset", "/runs/0/note", "x"), ("dataset", "/calibrate", ["stiffness"]),
            ("dataset", "/calibrate", ["joint_stiffness", "joint_stiffness"]), ("dataset", "/description", "x"),
            ("dataset", "/columns", {"Zeit": "time"}), ("dataset", "/columns", {"Zeit": {"as": "time_s", "factor": 0}}),
            ("dataset", "/columns", {"Zeit": {"factor": 2}}), ("dataset", "/columns", {"Zeit": {"as": "time_s", "by": 2}}),
            ("dataset", "/columns", {"W": {"as": "theta1_deg", "wraps_deg": 90}}), ("dataset", "/ignore", "frame"),
            ("dataset", "/ignore", [1]), ("dataset", "/runs/0/ignore", ["a", "a"]), ("dataset", "/sampling_rate_Hz", 0),
            ("dataset", "/runs/0/skip_lines", -1), ("dataset", "/separator", ":"), ("dataset", "/decimal", ";"),
            ("dataset", "/markers", {"bending_angle": {"line": [["x", "y"], [1, 2]]}}),
            ("dataset", "/markers", {"bending_angle_deg": {"line": [["x", "y"]]}}),
            ("dataset", "/markers", {"bending_angle_deg": {"line": [["x", 2], [1, 2]]}}),
            ("dataset", "/runs/0/input_file", {"columns": {}}),
            ("dataset", "/format", None),
        ]
        for name, base in bases.items():
            with self.subTest(name):
                self.assertEqual(faults(base), [])
                if name != "dataset":  # whose diagnosis would take its time
                    self.assertEqual(self.refusal(schema_of(base), base), "")
                    self.assertEqual(self.refusal(schema_of(base), {"$schema": "x.json", **base}), "")
        for name, pointer, value in table:
            with self.subTest(f"{name} {pointer} {value}"):
                schema = schema_of(bases[name])
                document = changed(bases[name], pointer, value)
                self.assertNotEqual(faults(document, schema), [])
                self.assertNotEqual(self.refusal(schema, document), "")

    def test_take_a_comment_in_the_same_objects(self):
        study = {**data_file("study.json"), **BLOCKS}
        friction = {"id": "dry_friction", "parameters": {"torque_Nmm": 0.3}}
        bases = [{**data_file("actuator.json"), "effects": [friction]}, data_file("lumped_model.json"),
                 data_file("pair.json"), data_file("two_coils.json"), data_file("two_magnets.json"), data_file("bodies.json"),
                 study, {**data_file("experiment.json")}]
        bases[-1]["runs"][2]["start_angles_deg"] = [9, 3]
        taken = 0
        for base in bases:
            for pointer, document in with_comments(base):
                with self.subTest(f"{schema_of(base)} {pointer}"):
                    whole = pointer == ""
                    refused = self.refusal(schema_of(base), document, whole)
                    self.assertEqual(bool(faults(document)), bool(refused), refused)
                    taken += not refused
                    # A comment is a text.
                    self.assertNotEqual(faults(changed(document, pointer + "/comment", 3)), [])
                    self.assertNotEqual(self.refusal(schema_of(base), changed(document, pointer + "/comment", 3), whole), "")
        self.assertGreater(taken, 50)

    def assert_same_bounds(self, schema, document, within=""):
        """Every number of a document at and beyond the bounds that its schema gives."""
        self.assertEqual(faults(document, schema), [])
        file = f"{schema}.schema.json"
        for pointer, rule in number_rules(SCHEMAS[file], document, file):
            if not pointer.startswith(within):
                continue
            for value in outside(rule):
                with self.subTest(f"{pointer} {value}"):
                    self.assertNotEqual(faults(changed(document, pointer, value), schema), [])
                    self.assertIn(f" {pointer}: must be ", self.refusal(schema, changed(document, pointer, value)))
            for value in inside(rule):
                with self.subTest(f"{pointer} {value}"):
                    self.assertEqual(faults(changed(document, pointer, value), schema), [])
                    # What cannot be built is refused too, but not this number.
                    self.assertNotIn(f" {pointer}: ", self.refusal(schema, changed(document, pointer, value)))

    def test_bound_the_numbers_of_an_actuator_alike(self):
        measured = data_file("actuator.json")
        measured["measured"] = {key: 1 for key in SCHEMAS["actuator.schema.json"]["properties"]["measured"]["properties"]
                                if key != "comment"}
        self.assert_same_bounds("actuator", measured, "/measured")
        sections = ("coil", "magnet", "body", "surroundings", "calibration")
        properties = SCHEMAS["actuator.schema.json"]["properties"]
        # D has four coils, each with its share of the current.
        self.assert_same_bounds("actuator", {
            "format": "actuator/1", "configuration": "D",
            **{section: defaults(properties[section]) for section in sections}})
        for names in ({"coil": {"wire_diameter_mm": 0.25, "wire_overall_mm": 0.3}}, {"body": {"shore_hardness_00": 30}},
                      {"body": {"youngs_modulus_MPa": 0.2}},
                      {"bottom_layer_silicone": {"shore_hardness_A": 30, "density_kg_m3": 1080, "conductivity_W_mK": 0.2}},
                      {"bottom_layer_silicone": {"shore_hardness_00": 30, "heat_capacity_J_kgK": 1300}},
                      {"bottom_layer_silicone": {"youngs_modulus_MPa": 0.2}}):
            self.assert_same_bounds("actuator", {"format": "actuator/1", "configuration": "B", **names})

    def test_bound_the_numbers_of_effects_alike(self):
        # Of models that can have every effect, for they know of none; a motor's are of a joint without a coil and a magnet.
        finger, motor = json.loads(PAPER_FINGER.read_text()), data_file("lumped_model.json")
        for effect in SCHEMAS["effects.schema.json"]["items"]["oneOf"]:
            rules = {key: rule for key, rule in effect["properties"]["parameters"].get("properties", {}).items()
                     if key != "comment"}
            values = {}
            for key, rule in rules.items():
                bounds = resolved(rule, "effects.schema.json")[0]
                values[key] = 1 if "enum" in rule else min(max(1, bounds["minimum"]), bounds.get("maximum", 1e9))
            base = motor if effect["title"] in ("load_friction", "rotor_inertia") else finger
            base["effects"] = [{"id": effect["title"], "parameters": values}]
            self.assertEqual(faults(base), [])
            for key, rule in rules.items():
                rule = resolved(rule, "effects.schema.json")[0]
                pointer = f"/effects/0/parameters/{key}"
                for value in outside(rule):
                    with self.subTest(f"{effect['title']} {key} {value}"):
                        self.assertNotEqual(faults(changed(base, pointer, value)), [])
                        self.assertIn(f" {pointer}: must be ", self.refusal(schema_of(base), changed(base, pointer, value)))
                for value in inside(rule):
                    with self.subTest(f"{effect['title']} {key} {value}"):
                        self.assertEqual(faults(changed(base, pointer, value)), [])
                        self.assertEqual(self.refusal(schema_of(base), changed(base, pointer, value)), "")

    def test_bound_the_numbers_of_other_files_alike(self):
        self.assert_same_bounds("lumped-model", data_file("lumped_model.json"))
        self.assert_same_bounds("pair", data_file("pair.json"))
        self.assert_same_bounds("pair", data_file("bodies.json"))

    def test_know_every_section_of_an_actuator(self):
        # The sections that `size` writes are complete.
        written = size_plain_finger(self)
        properties = SCHEMAS["actuator.schema.json"]["properties"]
        # But for a coil's share of the current, which is written where it is not the whole.
        whole = {key: 1 for key in properties["coil"]["properties"] if key.startswith("current_share_")}
        self.assertEqual(len(whole), 4)
        # And but for an enamel, a squareness and a silicone that are as usual.
        written["coil"] = {**whole, "enamel": "grade_1", "filler": "unstated", **written["coil"]}
        written["magnet"] = {"squareness": 0.95, **written["magnet"]}
        written["body"] = {"silicone": "none", **written["body"]}
        for section in ("coil", "magnet", "body", "surroundings", "model", "calibration"):
            self.assertEqual(defaults(properties[section]), written[section])

    def test_know_every_effect(self):
        listed = re.findall(r"^  EFFECT\((\w+)\)", (ROOT / "src/actuator/effects/standard_effects.cpp").read_text(), re.M)
        self.assertEqual([effect["title"] for effect in SCHEMAS["effects.schema.json"]["items"]["oneOf"]], listed)

    def test_know_every_quantity(self):
        result = run("evaluate", PAPER_FINGER, "--current-A", "1", "--json")
        printed = [key for key, value in json.loads(result.stdout).items() if not isinstance(value, (list, dict))]
        self.assertEqual(SCHEMAS["study.schema.json"]["$defs"]["quantity"]["enum"], printed)

    def test_know_every_quantity_of_a_block(self):
        names = SCHEMAS["study.schema.json"]["$defs"]["quantity_of_block"]["enum"]
        cells = [line.split("|")[1] for line in (ROOT / "docs/formats-study.md").read_text().splitlines()
                 if re.match(r"\| `(grip|crawl|driver_)", line)]
        documented = re.findall(r"`((?:grip|gripper|crawl|crawler|driver)_\w+)`", " ".join(cells))
        self.assertEqual(names, documented)
        study = {**data_file("study.json"), **BLOCKS, "columns": [{"quantity": name} for name in names]}
        self.assertEqual(faults(study), [])
        self.assertEqual(self.refusal("study", study, searches=True), "")
        # Each needs its block.
        for name in names:
            self.assertIn(f' /objectives/0/maximise: needs the block "{ {"g": "gripper", "c": "crawler", "d": "driver"}[name[0]] }"',
                          self.refusal("study", changed(data_file("study.json"), "/objectives/0/maximise", name)))

    def test_bound_the_numbers_of_the_blocks_alike(self):
        study = {**data_file("study.json"), **BLOCKS}
        self.assert_same_bounds("study", study, "/gripper/")
        self.assert_same_bounds("study", study, "/crawler/")
        self.assert_same_bounds("study", study, "/driver/")

    def test_bound_the_options_of_a_command_as_its_block(self):
        known = {"grip": ("gripper", {"width_mm": 60, "mass_g": 40, "friction": 0.8}),
                 "crawl": ("crawler", {"friction_forwards": 0.3, "friction_backwards": 0.6})}
        for command, (block, needed) in known.items():
            explained = " ".join(run("help", command).stdout.split())
            for key, rule in SCHEMAS["study.schema.json"]["properties"][block]["properties"].items():
                number, unit = re.fullmatch(r"(.*?)(_(?:deg|mm|g|A|m_s2|Hz|V|mAh|Ohm|ms))?", key).groups()
                option = "--" + number.replace("_", "-") + (unit or "").replace("_", "-", 1)
                if "default" in rule:
                    self.assertRegex(explained, rf"{re.escape(option)} [^()]*(\([^)]*\)[^()]*)*\(default {rule['default']}\)")
                for value in outside(rule) if rule.get("type") in ("number", "integer") else ():
                    with self.subTest(f"{command} {option} {value}"):
                        words = [word for name, usual in {**needed, key: value}.items() if name != key
                                 for word in ("--" + name.replace("_", "-"), usual)]
                        result = run(command, PAPER_FINGER, *words, option, value)
                        self.assertEqual(result.returncode, 2)
                        self.assertRegex(result.stderr, f"{option}: must be ")

    def test_know_every_variable_and_algorithm_of_a_study(self):
        study = data_file("study.json")
        rows = re.findall(r"^\| `(\w+)` \| [^|`]+ \| `(\w+)` \|", (ROOT / "docs/formats-actuator.md").read_text(), re.M)
        factors = defaults(SCHEMAS["actuator.schema.json"]["properties"]["calibration"])
        of_blocks = {f"{block}_{key}" for block, content in BLOCKS.items() for key, value in content.items()
                     if isinstance(value, (int, float)) and key not in ("least_current_up_to_A", "step_ms", "periods",
                                                                        "settling_periods")}
        rows_of_parts = {"configuration", "layout", "polarity"}
        names = {*rows_of_parts, "current_A", *(name for _, name in rows), *factors, *of_blocks}
        variables = SCHEMAS["study.schema.json"]["properties"]["variables"]["properties"]
        self.assertEqual(set(variables), names)
        study.update(BLOCKS)
        for name in sorted(names - rows_of_parts - {"current_A"}):
            # Far above every number there is: told of the bound, and not of the name.
            refusal = self.refusal("study", changed(study, "/variables", {name: {"values": [1e9]}}))
            self.assertIn(f" /variables/{name}/values/0: must be ", refusal)
        refusal = self.refusal("study", changed(study, "/search/algorithm", "newton"))
        algorithms = SCHEMAS["study.schema.json"]["properties"]["search"]["properties"]["algorithm"]["enum"]
        self.assertIn(f"must be one of {', '.join(algorithms)}; got", refusal)


if __name__ == "__main__":
    unittest.main()
