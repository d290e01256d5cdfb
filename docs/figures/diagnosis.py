#!/usr/bin/env python3
"""Draws docs/figures/diagnosis.svg: one held-out run of studies/undeclared_effect and what two models leave of it.

    scripts/coilwright.sh diagnose studies/undeclared_effect/data --out results/undeclared_effect
    docs/figures/diagnosis.py results/undeclared_effect/residuals.csv

Needs Debian's python3-matplotlib, which only this figure uses: scripts/setup.sh does not install it. The same
residuals.csv gives the same bytes with the same version of matplotlib (3.6.3 drew the one in the repository).
"""
import csv
import math
import pathlib
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402  (after the choice of what it draws with)

RUN = "step_1.25A.csv"
MEASURED, DECLARED, CORRECTED, INK = "#8793a0", "#c0392b", "#1f5fa8", "#1d2733"


def columns(path):
    """Time (s) and bending angles (deg) of the run: measured, of the declared and of the corrected model."""
    with open(path, encoding="utf-8", newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["run"] == RUN and row["channel"] == "bending_angle_deg"]
    if not rows:
        sys.exit(f"{path}: has no bending angle of {RUN}")
    if rows[0]["role"] != "validate":
        sys.exit(f"{path}: {RUN} must be a run that no fit has seen")
    return [[float(row[name]) for row in rows] for name in ("time_s", "measured", "declared", "after")]


def rms(values):
    return math.sqrt(sum(value * value for value in values) / len(values))


def draw(path):
    time, measured, declared, corrected = columns(path)
    plt.rcParams.update({
        "svg.hashsalt": "coilwright", "font.size": 11, "axes.edgecolor": INK, "axes.labelcolor": INK,
        "text.color": INK, "xtick.color": INK, "ytick.color": INK, "axes.spines.top": False,
        "axes.spines.right": False, "legend.frameon": False})
    figure, (angle, residual) = plt.subplots(
        2, 1, sharex=True, figsize=(10.6, 5.4), height_ratios=(3, 2), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.15, h_pad=0.1)

    angle.plot(time, measured, ".", color=MEASURED, markersize=4.5, label="measured")
    angle.plot(time, declared, "--", color=DECLARED, linewidth=1.6, label="model as declared")
    angle.plot(time, corrected, color=CORRECTED, linewidth=1.6, label="corrected model (quadratic_drag found)")
    angle.set_ylabel("bending angle, deg")
    angle.legend(loc="lower right", ncols=1)
    angle.set_title("Step to 1.25 A, a held-out run of studies/undeclared_effect (synthetic records)", loc="left",
                    fontsize=12, fontweight="bold")

    for model, colour, style, name in ((declared, DECLARED, "--", "as declared"),
                                       (corrected, CORRECTED, "-", "corrected")):
        left = [a - b for a, b in zip(measured, model)]
        residual.plot(time, left, style, color=colour, linewidth=1.2, label=f"{name}: {rms(left):.2f} deg rms")
    residual.axhline(0, color=INK, linewidth=0.8)
    residual.set_ylabel("measured − model, deg")
    residual.set_xlabel("time, s")
    residual.set_ylim(-12, 10)  # room for the legend below
    residual.set_xlim(0, max(time))
    residual.legend(loc="lower right", ncols=2)

    target = pathlib.Path(__file__).resolve().parent / "diagnosis.svg"
    figure.savefig(target, facecolor="white", metadata={
        "Date": None, "Creator": None, "Title": "Measured, declared and corrected bending angle of a held-out run"})
    # An accessible name, which matplotlib does not write; and no blanks at line ends.
    text = target.read_text(encoding="utf-8").replace(
        "<svg ", '<svg role="img" aria-label="Bending angle over time: measured, as declared, corrected" ', 1)
    target.write_text("\n".join(line.rstrip() for line in text.splitlines()) + "\n", encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    draw(sys.argv[1])
