import numpy as np
import pytest

import coilwright as cw

MODEL = cw.Actuator.load("tests/data/formats/lumped_model.json").to_dict()
CHIRP = {"chirp": {"amplitude_A": 0.4, "offset_A": 0.3, "from_Hz": 2, "to_Hz": 8}}
SWING = {"format": "experiment/1", "name": "swing", "sampling_rate_Hz": 500,
         "runs": [{"file": "swing.csv", "role": "fit", "duration_s": 0.4, "input": CHIRP}]}
STIFFNESS = np.array([joint["stiffness_Nm_rad"] for joint in MODEL["joints"]])


def own(stage, keys, **functions):
    return cw.Effect("own", stage=stage, description="of this test", equation="see there", source="see there",
                     numbers=[cw.Number(key, key, lower=0.0, upper=np.inf) for key in keys], starts=[[1.0] * len(keys)],
                     **functions)


def lagging(numbers, angles, rates, shown):
    return shown, (angles - shown) / numbers[0], (angles - shown) / numbers[0]


def creeping(numbers, angles, rates, currents, crept):
    return numbers[0] * STIFFNESS * (crept - angles), (angles - crept) / numbers[1]


def warming(numbers, currents, lost):
    return (1 - lost[0]) * currents, (numbers[0] * np.mean(currents**2) - lost) / numbers[1]


# Ours are held to closed forms in tests/actuator/effects; the same equation in Python must move alike.
@pytest.mark.parametrize("ours, numbers, effect, same", [
    ("coil_lag", {"time_constant_ms": 30.0},
     own("drive", ["time_constant_ms"], settled=lambda numbers, angles, currents: currents,
         currents=lambda numbers, currents, states: (states, (currents - states) / numbers[0])),
     1e-5),  # ours is stepped in closed form, the other to the integrator's relative accuracy
    ("force_gain", {"gain": 1.3}, own("magnetics", ["gain"], currents=lambda numbers, currents: numbers[0] * currents), 0),
    ("magnet_heating", {"loss_1_A2": 0.1, "time_constant_s": 0.2, "warm_start": 1.0},
     own("magnetics", ["loss_1_A2", "time_constant_s", "warm_start"], currents=warming,
         settled=lambda numbers, angles, currents: [numbers[0] * np.mean(currents**2)]), 1e-9),
    ("viscoelastic_creep", {"stiffness_ratio": 0.4, "time_constant_s": 0.05},
     own("hinge", ["stiffness_ratio", "time_constant_s"], torques=creeping,
         settled=lambda numbers, angles, currents: angles), 1e-9),
    ("tracking_lag", {"time_constant_ms": 20.0},
     own("camera", ["time_constant_ms"], shown=lagging, settled=lambda numbers, angles, currents: angles), 1e-9),
    ("angle_scale", {"scale": 1.1}, own("camera", ["scale"], shown=lambda k, angles, rates: (k * angles, k * rates)), 1e-9),
])
def test_an_effect_of_python_is_recorded_as_ours_of_the_same_equation(ours, numbers, effect, same):
    def angle(**hidden):
        return cw.twin(cw.Actuator.from_dict(MODEL), SWING, hidden, effects=[effect])["swing.csv"]["bending_angle_deg"]
    alike = angle(**{ours: numbers})
    assert np.max(np.abs(alike - angle())) > 0.1
    assert np.max(np.abs(angle(own=numbers) - alike)) <= same * np.ptp(alike)


def test_a_drag_of_python_damps_small_motions_as_the_hinge_does():
    drag = own("hinge", ["damping_Nms_rad"], torques=lambda numbers, angles, rates, currents: -numbers[0] * rates)
    dragged = {**MODEL, "effects": [{"id": "own", "parameters": {"damping_Nms_rad": 1e-4}}]}
    hinges = [{**joint, "damping_Nms_rad": joint["damping_Nms_rad"] + 1e-4} for joint in MODEL["joints"]]
    there = cw.evaluate(cw.Actuator.from_dict({**MODEL, "joints": hinges}), current=0.5)
    here = cw.evaluate(cw.Actuator.from_dict(dragged, effects=[drag]), current=0.5)
    assert here.damping_ratio == pytest.approx(there.damping_ratio, rel=1e-9)  # rounding of a difference over 0.2 mrad/s


@pytest.mark.parametrize("stage, functions, error, text", [
    ("hinge", {}, ValueError, "effect own: must have one of torques, currents, shown; got none"),
    ("hinge", dict(torques=len, shown=len), ValueError, "effect own: must have one of .*; got torques, shown"),
    ("drive", dict(torques=len), ValueError, "effect own: stage must be magnetics or hinge or chain for torques; got drive"),
    ("hinge", dict(torques=lambda *_: [0.0]), ValueError, "effect own: torques must give 2 numbers; got 1"),
    ("hinge", dict(torques=lambda *_: "much"), ValueError, "effect own: torques must give an array"),
    ("hinge", dict(torques=lambda k, angles, *_: angles, settled=lambda k, angles, currents: angles[:1]), ValueError,
     "effect own: torques must give 2 arrays, the slopes of its states last"),
    ("hinge", dict(torques=lambda *_: 1 / 0), ZeroDivisionError, "division by zero"),
])
def test_what_is_wrong_with_an_effect_of_python_is_told_and_ends_the_simulation(stage, functions, error, text):
    with pytest.raises(error, match=text):
        cw.twin(cw.Actuator.from_dict(MODEL), SWING, {"own": {"k": 1.0}}, effects=[own(stage, ["k"], **functions)])
