"""A front by hand: speed against grasp force, from a table of designs, beside the one that `pareto` finds."""

# %% Some hundred designs from the whole range of a study, as a table of arrays (a DataFrame by .to_frame()).
import numpy as np

import coilwright as cw

study = cw.Study.load("configs/studies/speed_against_grip.json")
table = cw.sweep(study, sample=300).table()
allowed = table["status"] == "ok"
speed, grip = (table[name][allowed] for name in study.objectives)
print(f"{allowed.sum()} of {len(table)} designs keep all limits")

# %% Those that no other one beats in both.
beaten = np.array([bool(np.any((speed >= s) & (grip >= g) & ((speed > s) | (grip > g)))) for s, g in zip(speed, grip)])
print(f"{(~beaten).sum()} of them are on the front of this table")

# %% The search puts its evaluations where the front is.
front = cw.pareto(study, max_evaluations=400)
print(f"pareto has {len(front)} after 400 evaluations")
for design in list(front)[:3]:
    there = cw.evaluate(design)
    print(f"  {there.peak_bending_speed_deg_s:.0f} deg/s, {there.grasp_force_N:.2f} N")
