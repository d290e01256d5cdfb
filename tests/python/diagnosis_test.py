import json

import numpy as np
import pytest

import coilwright as cw

FOLDER = "studies/undeclared_effect/data"
PENDULUM = {"format": "lumped-model/1", "name": "pendulum",
            "links": [{"length_m": 0.04, "com_along_m": 0.02, "com_offset_m": 0, "mass_kg": 0.03, "inertia_kgm2": 4e-6}],
            "joints": [{"stiffness_Nm_rad": 0.012, "damping_Nms_rad": 8e-5}], "magnetics": [None]}
EXPERIMENT = {"format": "experiment/1", "name": "short", "sampling_rate_Hz": 100, "measure": ["bending_angle_deg"],
              "noise": {"angle_deg": 0.3}, "resolution": {"angle_deg": 0.02},
              "runs": [{"file": "step.csv", "role": "fit", "duration_s": 1,
                        "input": {"step": {"after_A": 1.05, "at_s": 0.1}}}]}


def test_twin_gives_the_records_of_the_program(program, tmp_path, finger):
    program("twin", "configs/actuators/paper_finger.json", "--experiment", "configs/experiments/paper.json", "--effect",
            "dry_friction:torque_Nmm=0.6", "--seed", 7, "--out", tmp_path / "there")
    records = cw.twin(finger, "configs/experiments/paper.json", {"dry_friction": {"torque_Nmm": 0.6}}, seed=7)
    for file in records:
        assert records[file].text == (tmp_path / "there" / file).read_text()
    assert records.dataset == json.loads((tmp_path / "there/dataset.json").read_text())


def test_plan_says_what_the_program_says(program, finger, tmp_path):
    (tmp_path / "experiment.json").write_text(json.dumps(EXPERIMENT))
    said = json.loads(program("plan", tmp_path / "experiment.json", "--actuator", "configs/actuators/paper_finger.json",
                              "--json"))
    found = cw.plan(EXPERIMENT, finger)
    assert {**found.content, "experiment": 0, "actuator": 0} == {**said, "experiment": 0, "actuator": 0}
    assert "dry_friction" in found.text


def test_records_that_cannot_be_used_are_told_without_the_folder_that_nobody_knows(finger):
    time = np.arange(0, 1, 0.01)
    falling = {"push": {"time_s": time[::-1], "current_A": time, "bending_angle_deg": time}}
    with pytest.raises(cw.InputError, match=r"^records/push.csv: line 3") as caught:
        cw.diagnose(cw.Records.of(falling), finger)
    assert caught.value.file == "records/push.csv"
    with pytest.raises(cw.InputError, match="records/push.csv: .*sideways_deg"):
        cw.diagnose(cw.Records.of({"push": {"time_s": time, "current_A": time, "sideways_deg": time}}), finger)
    with pytest.raises(cw.InputError, match="^records/dataset.json: /effect_probabilities/friction: must be called by the id"):
        cw.diagnose(cw.Records.of(falling, effect_probabilities={"friction": 0.5}), finger)
    with pytest.raises(ValueError, match="about: has no run called pull"):
        cw.Records.of(falling, about={"pull": {}})


def test_records_are_saved_as_a_data_set_that_the_program_reads(tmp_path, finger):
    time = np.arange(0, 1, 0.01)
    records = cw.Records.of({"push": {"time_s": time, "current_A": time, "bending_angle_deg": 30 * time}})
    records.save(tmp_path, finger)
    assert json.loads((tmp_path / "dataset.json").read_text())["actuator"] == "actuator.json"
    assert np.array_equal(cw.Records.of({"push": {c: records["push.csv"][c] for c in records["push.csv"].columns}})
                          ["push.csv"]["bending_angle_deg"], 30 * time)


@pytest.mark.long
def test_diagnose_writes_the_bytes_of_the_program(program, tmp_path):
    program("diagnose", FOLDER, "--out", tmp_path / "there", "--quiet")
    cw.diagnose(FOLDER).write(tmp_path / "here")
    names = sorted(file.name for file in (tmp_path / "there").iterdir())
    assert sorted(file.name for file in (tmp_path / "here").iterdir()) == names and "diagnosis.json" in names
    for name in names:
        assert (tmp_path / "here" / name).read_bytes() == (tmp_path / "there" / name).read_bytes(), name


def swing(model, seed):
    """A pendulum under torques, with noise."""
    time = np.arange(0, 0.6, 0.005)
    torque = np.where((time * 4).astype(int) % 2, 5e-3 if seed % 2 else -4e-3, 0.0)
    columns = {"time_s": time, "torque1_Nm": torque}
    motion = cw.simulate(model, input=columns)
    noise = np.random.default_rng(seed).normal(0, 0.1, len(time))
    return {**columns, "theta1_deg": motion["theta1_deg"] + noise}


@pytest.mark.long
def test_an_effect_written_in_python_is_found_like_ours():
    stiffening = cw.Effect(
        "stiffening", stage="hinge", description="silicone that stiffens in one direction",
        equation="q -= k2 max(theta, 0)^2", source="of this test",
        numbers=[cw.Number("k2", "N m/rad^2", lower=0.0, upper=1.0, absent=0.0)], starts=[[0.003]],
        torques=lambda k, angles, rates, currents: -k[0] * np.maximum(angles, 0)**2)
    declared = cw.Actuator.from_dict(PENDULUM, effects=[stiffening])
    truth = cw.Actuator.from_dict({**PENDULUM, "effects": [{"id": "stiffening", "parameters": {"k2": 0.01}}]},
                                  effects=[stiffening])
    runs = {f"swing{seed}": swing(truth, seed) for seed in range(1, 4)}
    records = cw.Records.of(runs, about={"swing3": {"role": "validate"}}, tolerances="exact",
                            effect_probabilities={"stiffening": 0.2})
    diagnosis = cw.diagnose(records, declared, effects=[stiffening])
    assert diagnosis.verdict == "explained" and list(diagnosis.effects) == ["stiffening"]
    [number] = diagnosis.effects["stiffening"]
    assert number.lower < 0.01 < number.upper
    assert diagnosis.odds["stiffening"] > 0.9
    assert diagnosis.errors["after"]["rmse_deg"] < 0.5 * diagnosis.errors["declared"]["rmse_deg"]
    assert diagnosis.actuator.to_dict()["effects"][0]["id"] == "stiffening"
    assert diagnosis.residuals()["run"][0].startswith("swing")
