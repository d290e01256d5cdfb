#!/usr/bin/env python3
"""Prints how much the Python package costs over C++ and over a function of Python itself, in processor time:

    cmake --build --preset release --target cpp_loops coilwright_python
    PYTHONPATH=build/release/python /usr/bin/python3 benchmarks/python/figures.py
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np

import coilwright as cw

ROOT = pathlib.Path(__file__).resolve().parents[2]
LOOPS = ROOT / "build/release/benchmarks/python/cpp_loops"
FINGER = ROOT / "configs/actuators/paper_finger.json"
PAIR = {"coil": {"inner_radius_mm": 3, "outer_radius_mm": 9.5, "length_mm": 12, "turns_radial": 15, "turns_axial": 30},
        "magnet": {"radius_mm": 10, "length_mm": 6, "remanence_T": 1.44}, "current_A": 1.0,
        "poses": [{"position_mm": [0, 0, 14], "axis": [0.3, -0.1, 0.9]}]}
ROUNDS = 5


def in_cpp(*words) -> float:
    return float(subprocess.run([LOOPS, *map(str, words)], check=True, capture_output=True, text=True).stdout)


def here(work) -> float:
    begin = time.process_time()
    work()
    return time.process_time() - begin


def compared(title: str, of_python, of_cpp) -> None:
    """The median of several rounds of both in turn: the machine is never quite idle."""
    ratios, seconds = [], []
    for _ in range(ROUNDS):
        seconds.append(of_python())
        ratios.append(seconds[-1] / of_cpp())
    print(f"{title}: {np.median(seconds):.3f} s, {np.median(ratios):.3f} of C++ "
          f"({min(ratios):.3f} to {max(ratios):.3f})", flush=True)


def forces(count: int, folder: pathlib.Path) -> None:
    (folder / "pair.json").write_text(json.dumps(PAIR))
    pair = cw.Pair.load(folder / "pair.json")
    i = np.arange(count)
    places = np.column_stack([i % 7, i % 5, 14 + i % 11]).astype(float)
    compared(f"force, {count} poses", lambda: here(lambda: cw.force(pair, places)),
             lambda: in_cpp("force", folder / "pair.json", count))


def evaluations(count: int) -> None:
    finger = cw.Actuator.load(FINGER)
    fingers = [finger.replace(gap_mm=0.9 + 1e-4 * (i % 1000)) for i in range(count)]

    def loop():
        for each in fingers:
            cw.evaluate(each, current=1.4).peak_bending_speed_cold_deg_s
    compared(f"evaluate, {count} designs", lambda: here(loop), lambda: in_cpp("evaluate", FINGER, count))


def own_objective(budget: int, milliseconds: float) -> None:
    cost = 0.0

    def function(v):
        nonlocal cost
        begin = time.thread_time()
        while time.thread_time() - begin < 1e-3 * milliseconds:
            pass
        value = {"f": (v["x"] - 0.3)**2 + 100 * (v["y"] - v["x"]**2)**2 + (v["z"] - 1)**2}
        cost += time.thread_time() - begin
        return value
    ranges = {"x": (-2.0, 2.0), "y": (-1.0, 3.0), "z": (0.0, 2.0)}
    total = here(lambda: cw.search(function, ranges, {"f": "minimise"}, max_evaluations=budget))
    print(f"own objective, budget {budget}, {milliseconds} ms a call: {total:.2f} s, {total / cost:.3f} of the function "
          f"itself", flush=True)


def effect_of_python() -> None:
    own = cw.Effect("own_drag", stage="hinge", description="air", equation="q_j -= c |theta_j'| theta_j'", source="ours",
                    numbers=[cw.Number("drag_Nmms2_rad2", "c", lower=0.0, upper=1.0, absent=0.0)], starts=[[0.01]],
                    torques=lambda numbers, angles, rates, currents: -numbers[0] * np.abs(rates) * rates)

    def seconds(id: str) -> float:
        drag = {"effects": [{"id": id, "parameters": {"drag_Nmms2_rad2": 0.0116}}]}
        finger = cw.Actuator.from_dict({**cw.Actuator.load(FINGER).to_dict(), **drag}, effects=[own])
        return here(lambda: [cw.simulate(finger, step=1.4) for _ in range(20)]) / 20
    ratios = [seconds("own_drag") / seconds("quadratic_drag") for _ in range(ROUNDS)]
    print(f"simulate 1 s with an effect of Python: {1e3 * seconds('own_drag'):.1f} ms, {np.median(ratios):.0f} times one of "
          f"ours ({min(ratios):.0f} to {max(ratios):.0f})", flush=True)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as work:
        forces(1_000_000 if "--short" not in sys.argv else 20_000, pathlib.Path(work))
    evaluations(400 if "--short" not in sys.argv else 50)
    effect_of_python()
    own_objective(2000, 10.0)
