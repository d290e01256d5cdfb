import json

import numpy as np
import pytest

import coilwright as cw

COIL = {"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 10, "turns_radial": 8, "turns_axial": 20}
MAGNET = {"radius_mm": 4, "length_mm": 6, "remanence_T": 1.3}
CUBE = {"size_mm": [8, 8, 8], "remanence_T": 1.2}


def pair(**more):
    return cw.Pair.from_dict({"coil": COIL, "magnet": MAGNET, "current_A": 1.4,
                              "poses": [{"position_mm": [0.5, 0, 12], "axis": [0, 0.1, 1]}], **more})


def test_gives_the_numbers_of_the_program(tmp_path, program):
    places = np.random.default_rng(1).uniform([-3, -3, 10], [3, 3, 20], (7, 3))
    axes = np.random.default_rng(2).uniform([-0.3, -0.3, 0.5], [0.3, 0.3, 1], (7, 3))
    poses = [{"position_mm": place.tolist(), "axis": axis.tolist()} for place, axis in zip(places, axes)]
    (tmp_path / "pair.json").write_text(json.dumps({"coil": COIL, "magnet": MAGNET, "current_A": 1.4, "poses": poses}))
    rows = json.loads(program("force", tmp_path / "pair.json", "--json"))["poses"]
    force_N, torque_Nmm = cw.force(pair(), places, axes)
    assert np.allclose(force_N[:, 1], [row["force_N"] for row in rows], rtol=1e-14)
    assert np.allclose(torque_Nmm[:, 1], [row["torque_Nmm"] for row in rows], rtol=1e-13)
    assert np.array_equal(force_N, cw.force(cw.Pair.load(tmp_path / "pair.json")).force_N)


def test_one_axis_stands_for_all_poses():
    places = [[0, 0, 12], [0, 1, 13]]
    assert np.array_equal(cw.force(pair(), places, [0, 0.2, 1]).force_N,
                          cw.force(pair(), places, [[0, 0.2, 1], [0, 0.2, 1]]).force_N)


@pytest.mark.parametrize("arguments, text", [
    (([[0, 0]],), r"positions_mm: must have shape \(poses, 3\); got \(1, 2\)"),
    (([],), r"positions_mm: must have shape"),
    (([[0, 0, 12]], [[0, 0, 1], [0, 0, 1]]), r"axes: must have shape \(1, 3\); got \(2, 3\)"),
    ((None, [0, 0, 1]), "axes: must come with positions_mm"),
    (([[0, 0, np.nan]],), "position"),
])
def test_poses_that_are_none_are_refused(arguments, text):
    with pytest.raises(ValueError, match=text):
        cw.force(pair(), *arguments)


def test_magnets_in_one_place_are_refused():
    cubes = cw.Pair.from_dict({"bodies": [{"name": "a", "magnet": CUBE, "position_mm": [0, 0, 0]},
                                          {"name": "b", "magnet": CUBE, "position_mm": [0, 0, 20]}]})
    with pytest.raises(cw.InputError, match="pair: must have a and b apart: in pose 1 they are in the same place"):
        cw.force(cubes, [[0, 0, 20], [0, 0, 3]])


@pytest.mark.parametrize("inner", [0.3, 1, 5, 7.3, 19.95])
def test_a_wall_of_the_least_thickness_is_one(inner):
    """5.05 - 5 is less than 0.05 in binary."""
    outer = round(inner + 0.05, 6)
    pair(coil={**COIL, "inner_radius_mm": inner, "outer_radius_mm": outer})
    cw.Pair.from_dict({"bodies": [{"magnet": {"inner_radius_mm": inner, "outer_radius_mm": outer, "length_mm": 3,
                                              "remanence_T": 1.2}, "position_mm": [0, 0, 0]}]})
    with pytest.raises(cw.InputError, match="by at least 0.05"):
        pair(coil={**COIL, "inner_radius_mm": inner, "outer_radius_mm": round(inner + 0.0499, 6)})
