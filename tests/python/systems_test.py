import json

import numpy as np
import pytest

import coilwright as cw

FINGER = "configs/actuators/paper_finger.json"
CASES = {
    "linearise": (lambda finger: cw.linearise(finger, 1.4), ["--current-A", 1.4]),
    "linearise, a current each": (lambda finger: cw.linearise(finger, [1.4, -0.3]), ["--current-A", 1.4, -0.3]),
    "reach": (lambda finger: cw.reach(finger, 40, pieces=1), ["--angle-deg", 40, "--pieces", 1]),
    "drive by a bridge": (lambda finger: cw.drive(finger, mean_current=1.2, wiring="series", frequency=300),
                          ["--mean-A", 1.2, "--wiring", "series", "--frequency-Hz", 300]),
    "drive by a cell": (lambda finger: cw.drive(finger, duty=0.5, frequency=10, cell_voltage=4.2, cell_capacity_mAh=150,
                                                coil_temperature_degC=40),
                        ["--duty", 0.5, "--frequency-Hz", 10, "--cell-voltage-V", 4.2, "--cell-capacity-mAh", 150,
                         "--coil-temperature-degC", 40]),
    "grip": (lambda finger: cw.grip(finger, width_mm=60, mass_g=20, friction=0.8, current=1.1),
             ["--width-mm", 60, "--mass-g", 20, "--friction", 0.8, "--current-A", 1.1]),
    "grip of a box": (lambda finger: cw.grip(finger, width_mm=60, height_mm=40, mass_g=10, friction=0.9, shape="box"),
                      ["--width-mm", 60, "--height-mm", 40, "--mass-g", 10, "--friction", 0.9, "--shape", "box"]),
    "crawl": (lambda finger: cw.crawl(finger, friction_forwards=0.3, friction_backwards=0.6, periods=2,
                                      settling_periods=1),
              ["--friction-forwards", 0.3, "--friction-backwards", 0.6, "--periods", 2, "--settling-periods", 1]),
}


@pytest.mark.parametrize("case", CASES)
def test_an_answer_is_that_of_the_command_to_the_digit(case, finger, program):
    ask, words = CASES[case]
    assert ask(finger) == json.loads(program(case.split()[0].rstrip(","), FINGER, *words, "--json"))


def test_a_yield_is_that_of_the_command_to_the_digit(program):
    study, design = "configs/studies/robust_finger.json", "results/reference/robust_finger/actuator.json"
    found = cw.yield_of(cw.Study.load(study), cw.Actuator.load(design), builds=12, seed=3)
    assert found == json.loads(program("yield", study, design, "--builds", 12, "--seed", 3, "--json", "--quiet"))
    with pytest.raises(cw.InputError, match='needs the block "spread"'):
        cw.yield_of(cw.Study.load("configs/studies/fastest_finger.json"), cw.Actuator.load(design))


def test_a_field_is_that_of_the_command_to_the_digit(tmp_path, program):
    bodies = [{"name": "ring", "magnet": {"inner_radius_mm": 2, "outer_radius_mm": 5, "length_mm": 4, "remanence_T": 1.2},
               "position_mm": [0, 0, 5]},
              {"name": "coil", "position_mm": [1, 0, 12], "axis": [0, 0.1, 1], "current_A": 2,
               "coil": {"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 6, "turns_radial": 8, "turns_axial": 20}}]
    content = {"bodies": bodies, "plate": {"position_mm": [0, 0, -1], "normal": [0, 0, 1], "thickness_mm": 5}}
    (tmp_path / "pair.json").write_text(json.dumps(content))
    points = [[0, 0, 8.5], [3, 0, 5], [6, 1, 12], [0, 0, -3]]
    words = [str(each) for point in points for each in ("--at", *point)]
    rows = json.loads(program("field", tmp_path / "pair.json", *words, "--gradient", "--json"))["points"]
    found = cw.field(cw.Pair.from_dict(content), points, gradient=True)
    assert found.inside == tuple(row["inside"] for row in rows) == (None, "ring", "coil", "plate")
    assert [list(each) for each in found.flux_density_mT[:3]] == [row["flux_density_mT"] for row in rows[:3]]
    assert found.gradient_T_m[:3].tolist() == [row["gradient_T_m"] for row in rows[:3]]
    assert np.isnan(found.flux_density_mT[3]).all()


@pytest.mark.parametrize("ask, error", [
    (lambda finger: cw.drive(finger), "give duty, mean_current or both"),
    (lambda finger: cw.drive(finger, duty=0.5, cell_capacity_mAh=150), "give cell_voltage, too"),
    (lambda finger: cw.drive(finger, duty=0.5, wiring="star"), "wiring: must be 'parallel' or 'series'; got 'star'"),
    (lambda finger: cw.grip(finger, width_mm=60, mass_g=1, friction=1, shape="box"), "height_mm"),
    (lambda finger: cw.reach(finger, 900), "actuator|paper_finger"),
    (lambda finger: cw.linearise(finger, [1, 2, 3]), "paper_finger"),
    (lambda finger: cw.grip(finger, width_mm=60, mass_g=0.0005, friction=1), "mass_g: must be from 0.001 to"),
    (lambda finger: cw.drive(finger, duty=0.5, actuators=2.5), "actuators: must be a whole number"),
    (lambda finger: cw.crawl(finger, friction_forwards=-1, friction_backwards=1), "paper_finger"),
])
def test_what_cannot_be_asked_is_refused(ask, error, finger):
    with pytest.raises(ValueError, match=error):
        ask(finger)


def test_arrays_of_designs_are_evaluated_as_each_by_itself(finger):
    gaps, currents = np.meshgrid([0.8, 1.0], [0.7, 1.4, 1e5])
    found = cw.evaluate_all(finger, {"gap_mm": gaps, "current": currents, "turns_radial": 14}, duty=0.5)
    one = cw.evaluate(finger.replace(gap_mm=1.0, turns_radial=14), current=1.4, duty=0.5)
    assert found["steady_angle_deg"][1, 1] == one.steady_angle_deg and found["mass_g"].shape == (3, 2)
    assert np.isnan(found["grasp_force_N"][2]).all() and np.isnan(found["temperature_ripple_K"][0]).all()
    assert [reason is None for reason in found["failure"]] == [True] * 4 + [False] * 2
    assert "does not settle" in found["failure"][5]


def test_records_are_loaded_as_they_were_saved(tmp_path, finger):
    records = cw.twin(finger, "configs/experiments/paper.json")
    records.save(tmp_path / "set", finger)
    loaded = cw.Records.load(tmp_path / "set")
    assert dict(loaded._files) == dict(records._files) and loaded == cw.Records.load(tmp_path / "set/dataset.json")
    (tmp_path / "set/step_0.35A.csv").write_bytes(b"time_s,current_A,bending_angle_deg\n0,0,0 \xb0\n")
    cw.Records.load(tmp_path / "set").save(tmp_path / "again")
    assert (tmp_path / "again/step_0.35A.csv").read_bytes() == (tmp_path / "set/step_0.35A.csv").read_bytes()
    for content, text in (("{}", "is no data set"), ('{"runs": [{"file": "../a.csv"}]}', "a run")):
        (tmp_path / "dataset.json").write_text(content)
        with pytest.raises(cw.InputError, match=text):
            cw.Records.load(tmp_path)


def test_plots_take_the_keywords_of_matplotlib(finger):
    pytest.importorskip("matplotlib")
    axes = cw.simulate(finger, step=1.0, duration=0.05).plot(color="red", label="step")
    assert axes.lines[0].get_color() == "red" and axes.lines[0].get_label() == "step"


def test_a_posterior_of_memory_stands_for_the_file_that_a_spread_names():
    path, design = "configs/studies/undeclared_robust.json", "results/reference/undeclared_robust/actuator.json"
    with open("results/reference/undeclared_effect/diagnosis.json", encoding="utf-8") as file:
        text = file.read()
    finger = cw.Actuator.load(design)
    of_memory = cw.Study.load(path, posterior=_Diagnosed(text))
    assert cw.yield_of(of_memory, finger, builds=10) == cw.yield_of(cw.Study.load(path), finger, builds=10)
    with pytest.raises(cw.InputError, match="posterior"):
        cw.Study.load(path, posterior=_Diagnosed("{}"))


class _Diagnosed:
    """As far as a study knows a Diagnosis: one takes minutes to make."""

    def __init__(self, text):
        self._core = type("Core", (), {"json": text})


def test_a_model_predicts_and_scores_records_without_a_fit(finger):
    hidden = {"dry_friction": {"torque_Nmm": 0.8}}
    records = cw.twin(finger, "configs/experiments/paper.json", hidden, noise={"angle_deg": 0.2}, seed=4)
    right = finger.to_dict() | {"effects": [{"id": "dry_friction", "parameters": {"torque_Nmm": 0.8}}]}
    run = "step_1.05A.csv"
    scores = {name: cw.score(model, records, [run])[run]["bending_angle_deg"]
              for name, model in (("declared", finger), ("right", cw.Actuator.from_dict(right)))}
    assert scores["right"]["rmse"] == pytest.approx(0.2, rel=0.2) and scores["declared"]["rmse"] > 2 * scores["right"]["rmse"]
    assert scores["right"]["samples"] == len(records[run])
    shown = cw.predict(finger, records, [run])[run]["bending_angle_deg"]
    motion = cw.simulate(finger, input={name: records[run][name] for name in ("time_s", "current_A")})
    assert np.interp(records[run]["time_s"][40], motion["time_s"], motion["bending_angle_deg"]) == shown[40]
    with pytest.raises(ValueError, match="have no x.csv"):
        cw.predict(finger, records, ["x.csv"])
    free = records.dataset
    free["runs"][0]["start"] = "free"
    with pytest.raises(cw.InputError, match="at_rest"):
        cw.predict(finger, cw.Records(free, dict(records._files)))


@pytest.mark.parametrize(("column", "factor", "said"), [("time_s", 1 / 86400, "days"), ("time_s", 1e3, "ms"),
                                                        ("bending_angle_deg", np.pi / 180, "rad"),
                                                        ("current_A", 1e3, "mA"), ("current_A", -1, "sign")])
def test_records_in_another_unit_are_not_scored_as_they_are_written(finger, column, factor, said):
    right = cw.twin(finger, "configs/experiments/paper.json", noise={"angle_deg": 0.2}, seed=4)["step_1.05A.csv"]
    wrong = cw.Records.of({"push": {name: np.asarray(right[name]) * (factor if name == column else 1)
                                    for name in right.columns}})
    with pytest.raises(cw.InputError, match=f"{column}.*{said}.*as_written=True"):
        cw.score(finger, wrong)
    if factor != 1e3:  # A motion of minutes, or under kiloamperes, takes minutes.
        assert cw.score(finger, wrong, as_written=True)


STUDY, DESIGN = "configs/studies/robust_finger.json", "results/reference/robust_finger/actuator.json"
ASKED = {
    "linearise": lambda number, whole: cw.linearise(cw.Actuator.prototype(), number(1.25)),
    "linearise, a current each": lambda number, whole: cw.linearise(cw.Actuator.prototype(), np.array([1.25, number(0.5)])),
    "reach": lambda number, whole: cw.reach(cw.Actuator.prototype(), number(40), pieces=whole(1)),
    "drive": lambda number, whole: cw.drive(cw.Actuator.prototype(), mean_current=number(1.25), actuators=whole(2)),
    "grip": lambda number, whole: cw.grip(cw.Actuator.load(FINGER), width_mm=number(60), mass_g=number(20),
                                          friction=number(0.75), fingers=whole(3)),
    "crawl": lambda number, whole: cw.crawl(cw.Actuator.load(FINGER), friction_forwards=number(0.25), friction_backwards=number(0.5),
                                            periods=whole(2), settling_periods=whole(1)),
    "yield_of": lambda number, whole: cw.yield_of(cw.Study.load(STUDY), cw.Actuator.load(DESIGN), builds=whole(10), seed=whole(3)),
    "twin": lambda number, whole: cw.twin(cw.Actuator.prototype(), "configs/experiments/paper.json", seed=whole(3)).dataset,
    "evaluate": lambda number, whole: cw.evaluate(cw.Actuator.prototype(), current=number(0.5)).to_dict(),
    "simulate": lambda number, whole: cw.simulate(cw.Actuator.prototype(), step=number(0.5), duration=number(0.125)).rows.tolist(),
}


@pytest.mark.parametrize("name", ASKED)
def test_numbers_of_numpy_are_numbers_of_every_function(name):
    plain = ASKED[name](float, int)
    for number, whole in ((np.float64, np.int64), (np.float32, np.uint8), (np.array, np.array)):
        assert ASKED[name](number, whole) == plain, number


def test_whole_numbers_that_are_none_are_refused_by_their_names():
    study, design, finger = cw.Study.load(STUDY), cw.Actuator.load(DESIGN), cw.Actuator.prototype()
    for name, call in {"builds": lambda: cw.yield_of(study, design, builds=3), "worth": lambda: cw.yield_of(study, design, worth=4),
                       "seed": lambda: cw.twin(finger, "configs/experiments/paper.json", seed=-1),
                       "threads": lambda: cw.plan("configs/experiments/paper.json", finger, threads=1.5)}.items():
        with pytest.raises(ValueError, match=name):
            call()
    with pytest.raises(ValueError, match="seed: must be a whole number >= 0; got -1"):
        cw.diagnose("configs", seed=-1)


def test_what_is_no_model_no_records_and_no_list_is_refused_by_its_name(finger):
    records = cw.twin(finger, "configs/experiments/paper.json", seed=4)
    for name, call in {"actuator": lambda: cw.score("finger", records), "records": lambda: cw.score(finger, "records"),
                       "runs": lambda: cw.predict(finger, records, "step_1.05A.csv")}.items():
        with pytest.raises(TypeError, match=f"^{name}: must be"):
            call()
    with pytest.raises(ValueError, match="^builds: must be a whole number"):
        cw.yield_of(cw.Study.load(STUDY), cw.Actuator.load(DESIGN), builds="many")


def test_records_under_other_names_are_scored_when_they_are_renamed():
    finger = cw.Actuator.load(FINGER)
    time = np.arange(0, 0.2, 0.01)
    shown = cw.simulate(finger, input={"time_s": time, "current_A": np.full(20, 0.5)}, interval=None)["bending_angle_deg"]
    foreign = cw.Records.of({"push": {"t_s": time, "I": np.full(20, 0.5), "angle": shown}})
    with pytest.raises(cw.InputError, match=r"must have the columns time_s and current_A .*, and has t_s, I, angle: make "
                                            r"records of arrays by those names \(Records.of\)"):
        cw.score(finger, foreign)
    names = {"t_s": "time_s", "I": "current_A", "angle": "bending_angle_deg"}
    table = foreign["push.csv"]
    renamed = cw.Records.of({"push": {names[column]: table[column] for column in table.columns}})
    assert cw.score(finger, renamed)["push.csv"]["bending_angle_deg"]["max"] < 1e-6


def test_what_lies_beyond_an_input_is_not_predicted():
    finger = cw.Actuator.load(FINGER)
    time = np.arange(0, 0.5, 0.01)
    measured = {"time_s": time, "bending_angle_deg": np.full(50, 21.0)}

    def records(samples):
        made = cw.Records.of({"push": {name: column[:samples] for name, column in measured.items()},
                              "input": {"time_s": time[:30], "current_A": np.zeros(30)}})
        run = {"file": "push.csv", "kind": "transient", "role": "fit", "drive": "current", "input_file": "input.csv"}
        return cw.Records({**made.dataset, "runs": [run]}, {name: made[name].text for name in made})

    with pytest.raises(cw.InputError, match=r"push.csv: must lie within its input, from 0 to 0.3 s, .*it is from 0 to 0.49 s: "
                                            r"leave out the samples beyond"):
        cw.predict(finger, records(50))
    assert cw.predict(finger, records(31))["push.csv"]["bending_angle_deg"].shape == (31,)
    gone = cw.Records.of({"push": {"time_s": time, "current_A": 0 * time, "bending_angle_deg": np.full(50, np.nan)}})
    with pytest.raises(cw.InputError, match="push.csv: bending_angle_deg: must have a sample to be scored"):
        cw.score(finger, gone, as_written=True)
