import json
import pickle
import resource
import threading

import numpy as np
import pytest

import coilwright as cw


def test_gives_the_numbers_of_the_program_to_the_last_digit(finger, program):
    asked = json.loads(program("evaluate", "configs/actuators/paper_finger.json", "--current-A", 1.4, "--json"))
    given = cw.evaluate(finger, current=1.4)
    here = given.to_dict()
    assert here == {key: asked[key] for key in here}
    assert given.assumptions() == asked["assumptions"]


def test_every_quantity_of_the_table_is_an_attribute_with_its_unit_in_the_stub(finger, program):
    rows = json.loads(program("list", "quantities", "--json"))
    names = [row["key"] for row in rows if row["of"] == "evaluate"]
    with open("src/python/coilwright/_quantities.pyi", encoding="utf-8") as file:
        listed = [line.strip().removesuffix(": float") for line in file if line.endswith(": float\n")]
    assert listed == names
    values = cw.evaluate(finger, current=1.0).to_dict()
    for name in names:
        assert getattr(cw.Performance, name).__doc__
        if values[name] is None:
            with pytest.raises(cw.NoPerformance, match=f"^{name}: has no value: "):
                getattr(cw.evaluate(finger, current=1.0), name)
        else:
            assert getattr(cw.evaluate(finger, current=1.0), name) == values[name]


def test_the_operating_point_that_size_wrote_stands_where_nothing_is_said(finger):
    with pytest.raises(cw.InputError, match="paper_finger.json: has no operating_point: give a current"):
        cw.evaluate(finger)
    driven = cw.Actuator.from_dict({**finger.to_dict(), "operating_point": {"current_A": 0.9, "duty": 0.5}})
    assert cw.evaluate(driven).current_A == 0.9
    assert cw.evaluate(driven, current=1.2).to_dict()["operating_point"]["duty"] == 0.5


def test_a_runaway_raises_with_its_reason(finger):
    hot = cw.evaluate(finger, current=5.0)
    with pytest.raises(cw.NoPerformance, match="coil_hot_spot_degC: has no value: the current is at or beyond"):
        hot.coil_hot_spot_degC


FASTEST = cw.Study.load("configs/studies/fastest_finger.json")
AMPERES = {"time_s": [0, 0.1], "current_A": [0, 1400]}
ONE_PLACE = {"bodies": [{"magnet": {"size_mm": [5, 5, 5], "remanence_T": 1}, "position_mm": [0, 0, z]} for z in (0, 2, 9)]}


@pytest.mark.parametrize("call, error, text", [
    (lambda _: cw.evaluate("finger.json", current=1), TypeError, "actuator: must be a coilwright.Actuator, as Actuator.load gives; got 'f"),
    (lambda finger: cw.evaluate(finger, current=[1, 2]), TypeError, r"current: must be a number; got \[1, 2\]"),
    (lambda finger: cw.evaluate(finger, current=1, supply_voltage=-1), cw.InputError, "finger.json: supply_voltage: must be > 0; got -1"),
    (lambda finger: finger.replace(gap_mm=None), TypeError, "gap_mm: must be a number; got None"),
    (lambda finger: cw.simulate(finger, sine=(1, 0)), ValueError, r"sine: must be amplitude .*; got \(1, 0\)"),
    (lambda finger: cw.simulate(finger, input=AMPERES), cw.InputError, "input: column current_A: .* 1400 A.*: looks like milliamperes"),
    (lambda finger: cw.simulate(finger, step=1.0)["angle_deg"], KeyError, "angle_deg: is none of the columns time_s, "),
    (lambda finger: cw.size(finger), TypeError, "study: must be a coilwright.Study, as Study.load gives; got <"),
    (lambda _: cw.size(FASTEST, max_evaluations=-1), ValueError, "max_evaluations: must be a whole number >= 0; got -1"),
    (lambda _: cw.sweep(FASTEST, sample=2.5), ValueError, "sample: must be a whole number >= 0; got 2.5"),
    (lambda _: cw.Study.load("nowhere.json"), cw.InputError, "^nowhere.json: cannot be opened: No such file or directory$"),
    (lambda _: cw.force(cw.Pair.from_dict(ONE_PLACE)), cw.InputError, "pair: must have magnet 1 and magnet 2 apart: in pose 0"),
    (lambda finger: cw.twin(finger, "configs/experiments/paper.json", {"rotor_inertia": {"inertia_kgm2": 1e-7}}),
     cw.InputError, "rotor_inertia:inertia_kgm2=1e-07: cannot be in .*finger.json: coil and magnet act across the joint"),
])
def test_what_is_wrong_with_an_argument_is_told_by_its_name(finger, call, error, text):
    with pytest.raises(error, match=text):
        call(finger)


def test_numpy_numbers_are_numbers(finger):
    assert cw.evaluate(finger, current=np.float64(1.4)).mass_g == cw.evaluate(finger, current=1.4).mass_g


def test_threads_give_the_same_bits(finger):
    alone = [cw.evaluate(finger, current=1 + i / 10).peak_bending_speed_deg_s for i in range(4)]
    together = [0.0] * 4

    def work(i):
        together[i] = cw.evaluate(finger, current=1 + i / 10).peak_bending_speed_deg_s
    threads = [threading.Thread(target=work, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert together == alone


def test_a_performance_can_be_pickled_and_shown(finger):
    given = cw.evaluate(finger, current=1.3, duty=0.4)
    assert pickle.loads(pickle.dumps(given)).to_dict() == given.to_dict()
    assert "steady_angle_deg" in given._repr_html_() and "steady_angle_deg" in given.text


def test_memory_does_not_grow_in_a_hundred_thousand_calls(finger):
    pair = cw.Pair.from_dict({"coil": {"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 10, "turns_radial": 8,
                                       "turns_axial": 20},
                              "magnet": {"radius_mm": 4, "length_mm": 6, "remanence_T": 1.3}, "current_A": 1.4,
                              "poses": [{"position_mm": [0, 0, 12], "axis": [0, 0, 1]}]})
    performance = cw.evaluate(finger, current=1.4)

    def calls(count):
        for _ in range(count):
            cw.force(pair)
            performance.mass_g
            finger.name
    calls(5_000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    calls(35_000)
    for i in range(300):
        cw.evaluate(finger, current=1 + i * 1e-3).to_dict()
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 4_000  # KB: what malloc keeps


def test_many_designs_are_told_by_whatever_columns_are(finger):
    pandas = pytest.importorskip("pandas")
    table = {"gap_mm": [0.9, 1.1], "current": [0.5, 0.6]}
    plain = cw.evaluate_all(finger, table)["mass_g"]
    assert (cw.evaluate_all(finger, pandas.DataFrame(table))["mass_g"] == plain).all()
    words = cw.evaluate_all(finger, {"magnet_grade": ["N42", "N52"], "current": 0.5})["steady_angle_deg"]
    assert words[0] < words[1]


def test_a_design_with_a_masked_number_has_no_performance(finger):
    for gaps in (np.ma.masked_array([0.9, 1.1], [False, True]), [0.9, np.nan], [0.9, None]):
        found = cw.evaluate_all(finger, {"gap_mm": gaps, "current": 0.5})
        assert np.isnan(found["mass_g"]).tolist() == [False, True]
        assert found["failure"] == [None, "gap_mm=nan: must be a finite number"]


def test_a_name_that_no_design_has_is_refused_at_once(finger):
    with pytest.raises(cw.InputError, match='is not a number of a design; did you mean "gap_mm"'):
        cw.evaluate_all(finger, {"gp_mm": [1.0, 1.1], "current": 0.5})
    with pytest.raises(TypeError, match="curent: is none of current, duty"):
        cw.evaluate_all(finger, {"gap_mm": [1.0]}, curent=0.5)
