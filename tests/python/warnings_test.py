"""What the program says on standard error is a warning here."""

import json
import os
import re
import subprocess
import warnings

import numpy as np
import pytest

import coilwright as cw

ROD = {"magnet": {"radius_mm": 5, "length_mm": 6, "remanence_T": 1.2}}
PLATE = {"thickness_mm": 1, "radius_mm": 8}


def told(call):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        call()
    assert all(each.filename == __file__ for each in caught)  # the line of the caller
    return [str(each.message) for each in caught]


def standard_error(*words):
    done = subprocess.run([os.environ["COILWRIGHT"], *map(str, words)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return [line.removeprefix("MIND: ") for line in done.stderr.splitlines() if line]


@pytest.mark.parametrize("content", [
    {"magnets": [ROD["magnet"]] * 2, "poses": [{"position_mm": [0, 0, z], "axis": [0, 0, 1]} for z in (1, 30, 2)]},
    {"magnets": [ROD["magnet"]] * 2, "poses": [{"position_mm": [0, 0, 30], "axis": [0, 0, 1]}]},
    {"bodies": [{**ROD, "position_mm": [0, 0, 3]}], "plate": PLATE},
])
def test_bodies_that_cannot_be_so_are_told_as_the_program_tells_them(tmp_path, content):
    file = tmp_path / "pair.json"
    file.write_text(json.dumps(content))
    said = standard_error("force", file)
    # Poses count from 1 in a file, and from 0 in an array.
    without_numbers = lambda texts: [re.sub(r"poses? [0-9, ]+", "", each) for each in texts]
    assert without_numbers(told(lambda: cw.force(cw.Pair.load(file)))) == without_numbers(said)
    assert bool(said) == ("plate" in content or len(content["poses"]) > 1)


def test_overlaps_of_poses_in_arrays_are_told():
    pair = cw.Pair.from_dict({"bodies": [{**ROD, "position_mm": [0, 0, 0]}, {**ROD, "position_mm": [0, 0, 20]}]})
    [text] = told(lambda: cw.force(pair, np.array([[0, 0, z] for z in (20, 3, 4)])))
    assert text.startswith("pair: in poses 1, 2 the bodies are in the same place, as no two parts can be")
    with warnings.catch_warnings(), pytest.raises(UserWarning):
        warnings.simplefilter("error")
        cw.force(pair, [[0, 0, 3]])


def test_remarks_on_a_motion_are_those_of_the_program(tmp_path, finger):
    table = tmp_path / "input.csv"
    table.write_text("time_s,current_A\n0,0\n0.2,1.4\n0.4,0.2\n")
    said = standard_error("simulate", "configs/actuators/paper_finger.json", "--input", table, "--out", tmp_path / "out.csv")
    assert [line.replace("--interval-s 0.002", "interval=0.002") for line in said] == \
        told(lambda: cw.simulate(finger, input=table)) and said


def supplied(finger, **point):
    return cw.Actuator.from_dict({**finger.to_dict(), "operating_point": {"current_A": 1.0, **point}})


def test_a_supply_that_cannot_drive_the_current_is_told(finger):
    cold = cw.evaluate(supplied(finger)).supply_voltage_cold_V
    weak, enough = supplied(finger, supply_voltage_V=0.9 * cold), supplied(finger, supply_voltage_V=1.1 * cold)
    supply = lambda call: [each for each in told(call) if "supply" in each]
    assert supply(lambda: cw.simulate(enough, step=1.0, duration=0.1)) == []
    [text] = supply(lambda: cw.simulate(weak, step=1.0, duration=0.1))
    assert "drives 0.9 A in every coil at most, coils at 20 degC, and not 1 A" in text
    [text] = supply(lambda: cw.evaluate(weak))
    assert text.startswith("actuator: breaks the limit of supply_load: the supply has not the voltage")


def test_a_limit_that_is_broken_is_told_and_stands_in_the_text(finger):
    held = cw.evaluate(finger, current=1.0, supply_voltage=100)
    needed = held.supply_voltage_V
    for voltage, broken in ((needed, False), (needed * (1 - 1e-9), True)):
        given = []
        texts = told(lambda: given.append(cw.evaluate(finger, current=1.0, supply_voltage=voltage)))
        assert any("supply_load" in each for each in texts) == broken
        [row] = [each for each in given[0].to_dict()["part_limits"] if each["quantity"] == "supply_load"]
        assert row["broken"] == broken and row["value"] == pytest.approx(1)
        assert ("BROKEN: the supply" in given[0].text) == broken


def test_many_designs_are_warned_of_once_a_limit_and_at_the_line_of_the_caller():
    said = told(lambda: cw.evaluate_all(cw.Actuator.prototype(), {"gap_mm": [0.9, 1.0, 1.1], "current": [0.1, 5.0, 5.0]}))
    alone = told(lambda: cw.evaluate(cw.Actuator.prototype(), current=5.0))
    assert alone and said == [f"{each} (2 of 3 designs)" for each in alone]
