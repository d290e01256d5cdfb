"""An objective of one's own: in a study of designs, and in the search by itself."""

from collections.abc import Mapping
from typing import Any

# %% A quantity is a name with its unit and a function of a Performance. A study may ask for it like for any other.
import coilwright as cw


def grip_per_mass(performance: cw.Performance) -> float:
    return performance.grasp_force_cold_N / performance.mass_g * 1000


study = cw.Study.from_dict(
    {"format": "study/1", "name": "grip per mass",
     "operating_point": {"share_of_current_limit": 1, "duty": 0.5},
     "variables": {"turns_radial": {"lower": 10, "upper": 18}, "magnet_length_mm": {"lower": 4, "upper": 12},
                   "gap_mm": {"lower": 0.6, "upper": 1.5}},
     "objectives": [{"maximise": "grip_per_mass_N_kg"}],
     "constraints": [{"quantity": "mass_g", "at_most": 70}, {"quantity": "thermal_load", "at_most": 1}]},
    cw.Actuator.prototype(),
    quantities=[cw.Quantity("grip_per_mass_N_kg", grip_per_mass, "grasp force divided by mass", scale=15)])
found = cw.size(study, max_evaluations=60, answer_only=True)
print(f"{grip_per_mass(cw.evaluate(found.best)):.2f} N/kg, from "
      f"{grip_per_mass(cw.evaluate(cw.Actuator.prototype(), current=1.4)):.2f}")

# %% The search by itself takes any function: with arrays, where it can.
calls = []


def spring(v: Mapping[str, Any]) -> Mapping[str, Any]:
    calls.append(len(v["wire_mm"]))
    stiffness = 79.3e3 * v["wire_mm"]**4 / (8 * v["coil_mm"]**3 * v["turns"])
    return {"mass": (v["turns"] + 2) * v["coil_mm"] * v["wire_mm"]**2, "too_soft": 1 - stiffness / 2.0}


answer = cw.search(spring, {"wire_mm": (0.5, 3.0), "coil_mm": (8.0, 30.0), "turns": range(3, 16)},
                   {"mass": "minimise"}, ["too_soft"], vectorised=True, max_evaluations=150)
print(f"{answer.best[0]} after {len(answer.evaluations)} evaluations in {len(calls)} calls")
