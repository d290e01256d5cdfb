import math

import numpy as np
import pytest

import coilwright as cw


def test_finds_the_least_of_a_function_that_is_called_with_arrays():
    sizes = []

    def branin(v):
        sizes.append(np.size(v["x"]))
        valley = v["y"] - 5.1 / (4 * np.pi**2) * v["x"]**2 + 5 / np.pi * v["x"] - 6
        return {"f": valley**2 + 10 * (1 - 1 / (8 * np.pi)) * np.cos(v["x"]) + 10}
    ranges = {"x": (-5.0, 10.0), "y": (0.0, 15.0)}
    found = cw.search(branin, ranges, {"f": "minimise"}, vectorised=True, max_evaluations=120)
    assert found.best[0]["f"] == pytest.approx(0.397887, abs=1e-4)
    assert sum(sizes) == len(found.evaluations) == 120 and max(sizes) > 3
    one_by_one = cw.search(branin, ranges, {"f": "minimise"}, max_evaluations=120)
    assert [row["x"] for row in one_by_one.evaluations] == [row["x"] for row in found.evaluations]


def test_a_front_of_two_objectives_lies_on_the_line_that_is_known():
    # Schaffer's problem: x^2 against (x - 2)^2 is best for x from 0 to 2.
    found = cw.search(lambda v: {"a": v["x"]**2, "b": (v["x"] - 2)**2}, {"x": (-10.0, 10.0)},
                      {"a": "minimise", "b": "minimise"}, max_evaluations=80)
    assert len(found.best) > 20 and all(-1e-6 <= row["x"] <= 2 + 1e-6 for row in found.best)


def test_a_nan_is_a_design_that_cannot_be_evaluated():
    found = cw.search(lambda v: {"f": math.nan if v["x"] < 0 else v["x"]}, {"x": (-1.0, 1.0)}, {"f": "minimise"},
                      max_evaluations=40, start={"x": 0.5})
    assert 0 <= found.best[0]["x"] < 0.05
    assert any("f" not in row for row in found.evaluations)


def test_grids_and_whole_numbers_are_kept():
    found = cw.search(lambda v: {"f": abs(v["n"] - 6.4) + abs(v["s"] - 0.33)}, {"n": range(1, 12, 2), "s": (0.0, 1.0, 0.25)},
                      {"f": "minimise"}, max_evaluations=100)
    assert (found.best[0]["n"], found.best[0]["s"], found.stop_reason) == (7, 0.25, "space_exhausted")


@pytest.mark.parametrize("arguments, error, text", [
    (({"x": (0.0, 1.0)}, {"f": "minimize"}), ValueError, "objectives: 'f' must be 'minimise' or 'maximise'"),
    (({"x": (1.0, 0.0)}, {"f": "minimise"}), ValueError, r"variables\[0\].upper: must be >= lower"),
    (({"x": range(0)}, {"f": "minimise"}), ValueError, "variables: 'x' must be a range that counts up"),
    (({"x": (0.0, 1.0)}, {"g": "minimise"}), KeyError, "g"),
])
def test_a_problem_that_is_none_is_refused(arguments, error, text):
    with pytest.raises(error, match=text):
        cw.search(lambda v: {"f": v["x"]}, *arguments, max_evaluations=10)


def test_progress_is_told_on_the_way():
    seen = []
    cw.search(lambda v: {"f": np.sin(v["x"])}, {"x": (0.0, 6.0)}, {"f": "minimise"}, max_evaluations=30,
              progress=seen.append)
    assert seen[-1].evaluations == 30 and [each.evaluations for each in seen] == sorted(each.evaluations for each in seen)
