"""Small studies of the paper's finger for the tests of size, sweep and pareto."""

import json

from program import PAPER_FINGER, run


def write_study(test, **changes):
    """study.json beside finger.json in the test's folder; a change of None removes a key."""
    study = {
        "format": "study/1", "name": "small", "actuator": "finger.json",
        "operating_point": {"share_of_current_limit": 0.9, "duty": 0.5},
        "variables": {"turns_radial": {"lower": 10, "upper": 17}, "wire_gauge_AWG": {"values": [27, 28, 30]},
                      "gap_mm": {"lower": 0.7, "upper": 1.6}},
        "objectives": [{"maximise": "peak_bending_speed_deg_s"}],
        "constraints": [{"quantity": "mass_g", "at_most": 66}, {"quantity": "thermal_load", "at_most": 1.1}],
        "search": {"max_evaluations": 60, "seed": 5},
    }
    study.update(changes)
    study = {key: value for key, value in study.items() if value is not None}
    test.write("finger.json", PAPER_FINGER.read_text())
    test.write("study.json", json.dumps(study))
    return study


def size_plain_finger(test):
    """Runs `size` on an actuator of which plain.json states nothing; its out/actuator.json has every default."""
    test.write("plain.json", '{"format": "actuator/1", "configuration": "B"}')
    test.write("study.json", json.dumps(
        {"format": "study/1", "name": "x", "actuator": "plain.json", "operating_point": {"current_A": 0.5},
         "variables": {"turns_axial": {"values": [30]}}, "objectives": [{"minimise": "mass_g"}]}))
    test.assertEqual(run("size", "study.json", "--out", "out", cwd=test.folder).returncode, 0)
    return test.result("out/actuator.json")


GRID = {"configuration": {"values": ["A", "B"]}, "turns_radial": {"lower": 12, "upper": 15},
        "gap_mm": {"lower": 0.7, "upper": 1.3, "step": 0.2}}
FRONT = [{"maximise": "peak_bending_speed_deg_s"}, {"minimise": "mass_g"}]
