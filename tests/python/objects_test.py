"""What every object of the package can do, by one rule each: the next class is in these tests by being public."""

import collections.abc
import copy
import inspect
import json
import pickle
import subprocess
import sys

import numpy as np
import pytest

import coilwright as cw

STUDY = "configs/studies/fastest_finger.json"
PAIR = {"bodies": [{"magnet": {"radius_mm": 5, "length_mm": 4, "remanence_T": 1.2}, "position_mm": [0, 0, z]} for z in (0, 9)]}
TIME = np.arange(40) * 0.01
RUN = {"time_s": TIME, "current_A": np.where(TIME < 0.1, 0.0, 0.7), "bending_angle_deg": 20 + 30 * TIME}


@pytest.fixture(scope="module")
def objects():
    """One of each public class."""
    finger = cw.Actuator.prototype()
    rod = cw.Actuator.from_dict({
        "format": "lumped-model/1", "name": "rod", "gravity_m_s2": 9.81, "magnetics": None,
        "links": [{"length_m": 0.2, "com_along_m": 0.2, "com_offset_m": 0.0, "mass_kg": 0.5, "inertia_kgm2": 0.0}],
        "joints": [{"stiffness_Nm_rad": 0.1, "damping_Nms_rad": 0.005}]})
    records = cw.twin(rod, {
        "format": "experiment/1", "name": "swing", "sampling_rate_Hz": 40, "noise": {"angle_deg": 0.3}, "measure": ["theta1_deg"],
        "runs": [{"file": "swing.csv", "role": "fit", "duration_s": 1, "drive": "torque",
                  "input": {"sine": {"amplitude_Nmm": 300, "frequency_Hz": 1}}}]})
    made = [finger, cw.Effect("stiffening", stage="hinge", description="a cubic spring", equation="-k q^3", source="here",
                              starts=[[0.01]], numbers=[cw.Number("cubic", "how much", 0.0, 1.0, 0.0)], torques=cubic),
            cw.Estimate("torque_Nmm", 0.6, 0.5, 0.7), cw.Number("torque_Nmm", "largest", 0.0, 1.0), cw.Pair.from_dict(PAIR),
            cw.force(cw.Pair.from_dict(PAIR)), cw.field(cw.Pair.from_dict(PAIR), [0, 0, 20]),
            cw.simulate(finger, step=1.0, duration=0.02), cw.evaluate(finger, current=0.5),
            cw.Plan({"effects": []}, "text"), cw.Tracked(records, {"films": []}, "text", {}), cw.Progress(1, 2, 3, 4), cw.Quantity("twice_mass_g", twice), records,
            cw.search(lambda v: {"f": v["x"]**2}, {"x": (-1.0, 1.0)}, {"f": "minimise"}, max_evaluations=20),
            cw.Study.load(STUDY), cw.size(cw.Study.load(STUDY), max_evaluations=20, answer_only=True),
            cw.pareto(cw.Study.load("configs/studies/speed_against_grip.json"), max_evaluations=30),
            cw.sweep(cw.Study.load(STUDY), sample=3), cw.sweep(cw.Study.load(STUDY), sample=3).table(),
            cw.InputError("a: b", "a", "", "b", ""), cw.NoPerformance("why"), cw.OutputError("where"),
            cw.diagnose(records, rod)]
    return {type(each): each for each in made}


def cubic(numbers, angles, rates, currents):
    return -numbers[0] * angles**3


def twice(performance):
    return 2 * performance.mass_g


def test_one_of_each_class_is_looked_at(objects):
    public = {getattr(cw, name) for name in cw.__all__}
    assert {each for each in public if inspect.isclass(each)} == set(objects)


def test_each_says_what_it_is(objects):
    for kind, each in objects.items():
        assert f"<{kind.__module__}." not in repr(each) and " object at 0x" not in repr(each), repr(each)
        assert "\n" not in repr(each) or isinstance(each, tuple)


def content(each):
    """What can be compared of an object, whatever it is."""
    if isinstance(each, collections.abc.Mapping):
        return {key: content(each[key]) for key in each}
    if hasattr(each, "to_dict"):
        return each.to_dict()
    if isinstance(each, np.ndarray):
        return each.tolist()
    if isinstance(each, tuple):
        return [content(part) for part in each]
    return each if type(each).__eq__ is not object.__eq__ else repr(each)


def test_each_is_pickled_and_copied(objects):
    for kind, each in objects.items():
        for again in (pickle.loads(pickle.dumps(each)), copy.deepcopy(each)):
            assert type(again) is kind and content(again) == content(each), kind


def test_a_pickled_answer_gives_and_writes_what_it_did(objects, tmp_path):
    for kind in (cw.Sized, cw.Front, cw.Swept, cw.Diagnosis):
        here = objects[kind]
        there = pickle.loads(pickle.dumps(pickle.loads(pickle.dumps(here))))
        assert there.text == here.text and there.to_dict() == here.to_dict()
        for name in ("table", "evaluations", "residuals"):
            if hasattr(here, name):
                assert getattr(there, name)() == getattr(here, name)()
        for name in ("best", "feasible", "actuator", "next_experiment", "errors", "odds"):
            if hasattr(kind, name):
                assert getattr(there, name) == getattr(here, name)
        if hasattr(kind, "__len__"):
            assert list(there) == list(here)
        here.write(tmp_path / f"{kind.__name__}_here")
        there.write(tmp_path / f"{kind.__name__}_there")
        files = {path.name: path.read_bytes() for path in (tmp_path / f"{kind.__name__}_here").iterdir()}
        assert files and files == {path.name: path.read_bytes() for path in (tmp_path / f"{kind.__name__}_there").iterdir()}
    blocked = tmp_path / "file"
    blocked.write_text("")
    with pytest.raises(cw.OutputError, match="cannot be written"):
        there.write(blocked / "folder")


def test_an_answer_of_another_process_can_be_read(objects, tmp_path):
    (tmp_path / "swept").write_bytes(pickle.dumps(objects[cw.Swept]))
    code = "import pickle, sys; print(pickle.load(open(sys.argv[1], 'rb')).table().text, end='')"
    done = subprocess.run([sys.executable, "-c", code, tmp_path / "swept"], capture_output=True, text=True, check=True)
    assert done.stdout == objects[cw.Swept].table().text


def parts_of(each):
    """What an object shows: its public attributes, elements and what methods without arguments give."""
    for name, value in inspect.getmembers(type(each)):
        if not name.startswith("_") and isinstance(value, property):
            try:
                yield name, getattr(each, name)
            except cw.NoPerformance:
                pass
    for name in ("to_dict",):
        if hasattr(each, name):
            yield name, getattr(each, name)()
    if isinstance(each, tuple):
        yield from zip(each._fields, each)
    elif isinstance(each, collections.abc.Mapping):
        yield from ((key, each[key]) for key in each)


def spoilt(value):
    """Writes to what a caller was given, wherever that can be written to."""
    if isinstance(value, np.ndarray) and value.flags.writeable:
        value[...] = 0
    elif isinstance(value, dict):
        for part in value.values():
            spoilt(part)
        value.clear()
    elif isinstance(value, list):
        for part in value:
            spoilt(part)
        value.clear()


def test_no_answer_changes_by_what_is_done_to_a_part_of_it(objects):
    given = (cw.Plan, cw.Found, cw.Tracked)  # a caller's own, as any tuple of lists
    for kind, each in objects.items():
        if kind in given or issubclass(kind, Exception):
            continue
        before = content(each)
        for name, part in list(parts_of(each)):
            spoilt(part)
            assert content(each) == before, f"{kind.__name__}.{name}"


def test_arrays_of_answers_cannot_be_written_to(objects):
    motion, forces = objects[cw.Motion], objects[cw.Forces]
    for array in (motion.rows, motion["time_s"], forces.force_N, forces.torque_Nmm):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1


def test_a_motion_is_a_mapping(objects):
    motion = objects[cw.Motion]
    assert isinstance(motion, collections.abc.Mapping)
    assert list(dict(**motion)) == list(motion) == motion.columns and len(motion) == len(motion.columns)
    assert "time_s" in motion and motion.get("none") is None and (motion["time_s"] == motion.rows[:, 0]).all()
    again = cw.simulate(cw.Actuator.prototype(), input={name: motion[name] for name in ("time_s", "current_A")})
    assert np.allclose(again["bending_angle_deg"][0], motion["bending_angle_deg"][-1], atol=30)


def test_a_table_is_cut_and_shown_without_pandas(objects, monkeypatch):
    monkeypatch.setitem(sys.modules, "pandas", None)
    table = objects[cw.Table]
    assert [row for row in table[1:]] == [table[1], table[2]] and len(table[::-1]) == 3 and table[::-1][0] == table[2]
    assert table[np.int64(1)] == table[1] == table[-2] and table[[2, 0]][0] == table[2]
    assert table[table["mass_g"] > table["mass_g"].min()]["mass_g"].size == 2
    assert table[:] == table and isinstance(table[:0], cw.Table) and len(table[:0]) == 0
    with pytest.raises(IndexError):
        table[3]
    shown = table._repr_html_()
    assert shown.count("<tr>") == 4 and all(f"<th>{name}</th>" in shown for name in table.columns)
    long = cw.Table("a,b\n" + "".join(f"{i},<{i}>\n" for i in range(1000)))._repr_html_()
    assert long.count("<tr>") == 22 and "&lt;999&gt;" in long and "<caption>1000 rows</caption>" in long


NUMBERS = [np.float64(1.25), np.float32(1.25), np.array(1.25), np.longdouble(1.25)]
WHOLES = [np.int64(12), np.uint8(12), np.int32(12), np.array(12)]


@pytest.mark.parametrize("number", NUMBERS, ids=lambda each: str(each.dtype))
@pytest.mark.parametrize("count", WHOLES, ids=lambda each: str(each.dtype))
def test_numbers_of_numpy_are_numbers_of_a_file(number, count):
    """In every function that takes the content of a file."""
    study = {"format": "study/1", "name": np.str_("own"), "operating_point": {"current_A": number},
             "variables": {"turns_radial": {"lower": count, "upper": np.int64(18)}}, "objectives": ({"minimise": "mass_g"},)}
    assert cw.Study.from_dict(study, cw.Actuator.prototype()).variables == ["turns_radial"]
    body = cw.Actuator.prototype().to_dict()
    assert cw.Actuator.from_dict({**body, "body": {**body["body"], "gap_mm": number}})["body"]["gap_mm"] == 1.25
    assert cw.Study.load(STUDY, set={"/search/max_evaluations": count, "/constraints/3/at_most": 50 * number}).limits[3] == "mass_g <= 62.5"
    bodies = [{"magnet": {"radius_mm": number, "length_mm": count, "remanence_T": 1.2}, "position_mm": np.array([0, 0, z])}
              for z in (0, 30)]
    assert cw.force(cw.Pair.from_dict({"bodies": bodies})).force_N.shape == (1, 2, 3)
    records = cw.Records.of({"push": RUN}, about={"push": {"sigma": number}}, tolerances={"face_closing_deg": count})
    assert json.loads(json.dumps(records.dataset))["runs"][0]["sigma"] == 1.25


def test_what_no_file_can_hold_is_refused_by_its_place():
    body = cw.Actuator.prototype().to_dict()
    for value, told in ((np.nan, "actuator: /body/gap_mm: must be a finite number; got nan"),
                        (np.array([1.0, np.inf]), "actuator: /body/gap_mm/1: must be a finite number; got inf"),
                        (1j, "actuator: /body/gap_mm: must be a number, a text, a list or a mapping; got 1j (complex)"),
                        (np.ma.masked, "actuator: /body/gap_mm: must have no masked number; got masked"),
                        (np.timedelta64(1, "s"), "actuator: /body/gap_mm: must be a number, a text, ")):
        with pytest.raises(cw.InputError) as error:
            cw.Actuator.from_dict({**body, "body": {**body["body"], "gap_mm": value}})
        assert str(error.value).startswith(told) and error.value.file == "actuator"
