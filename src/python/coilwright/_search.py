"""The search by itself, on functions of Python."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

from coilwright import _core
from coilwright._arrays import floats
from coilwright._results import Listener, _words

Range = Union[tuple[float, float], tuple[float, float, float], range]
Numbers = Mapping[str, Any]


class Found(NamedTuple):
    """What `search` found.

    >>> import coilwright as cw
    >>> cw.Found._fields
    ('best', 'feasible', 'stop_reason', 'evaluations')
    """

    best: list[dict[str, float]]
    """The front, best in the first objective first; of one objective one design: variables, objectives, constraints. If
    nothing is feasible and there is one objective, the least infeasible design."""
    feasible: bool
    """Whether they keep every constraint."""
    stop_reason: str
    """"evaluation_limit", "space_exhausted" or "converged"."""
    evaluations: list[dict[str, float]]
    """Every design, in the order of evaluation; one that could not be evaluated has variables only."""


def search(function: Callable[[Numbers], Numbers], variables: Mapping[str, Range], objectives: Mapping[str, str],
           constraints: Sequence[str] = (), *, vectorised: bool = False, start: Optional[Mapping[str, float]] = None,
           max_evaluations: int = 2000, seed: int = 1, algorithm: str = "automatic",
           progress: Optional[Listener] = None) -> Found:
    """Searches for what makes a Python function small or large, by the search of `size` (one objective) or `pareto` (two
    or three): local models of all that was evaluated, for functions that take milliseconds or more.

    variables: each (lower, upper), (lower, upper, step) or a range of whole numbers. objectives: each "minimise" or
    "maximise". constraints: names of what must stay <= 0, scaled to order 1. `function` gets a number for each variable
    and gives one for each objective and constraint; with `vectorised` arrays, as many designs at once as the search
    asks for. A nan is a design that cannot be evaluated. The same function and seed give the same answer.

    >>> import coilwright as cw
    >>> found = cw.search(lambda v: {"f": (v["x"] - 0.3)**2 + v["n"], "g": 2.5 - v["n"]},
    ...                   {"x": (0.0, 1.0), "n": range(1, 6)}, {"f": "minimise"}, ["g"], max_evaluations=60)
    >>> best = found.best[0]
    >>> found.feasible, best["n"], abs(best["x"] - 0.3) < 0.01
    (True, 3.0, True)
    """
    for name, sense in objectives.items():
        if sense not in ("minimise", "maximise"):
            raise ValueError(f"objectives: {name!r} must be 'minimise' or 'maximise'; got {sense!r}")
    inputs, outputs = list(variables), [*objectives, *constraints]
    problem = _core.Problem([_variable(name, each) for name, each in variables.items()],
                            [(name, sense == "maximise") for name, sense in objectives.items()], list(constraints),
                            _batch(function, inputs, outputs, vectorised),
                            [] if start is None else [start[name] for name in inputs])
    best, feasible, reason, records = _core.search(problem, _words(seed, max_evaluations, algorithm, 0, progress))
    records = sorted(records, key=lambda record: record[4])
    return Found([_row(inputs, outputs, each) for each in best], feasible, reason,
                 [_row(inputs, outputs, each) for each in records])


def _variable(name: str, values: Range) -> tuple[str, str, float, float, float]:
    if isinstance(values, range):
        if len(values) == 0 or values.step < 1:
            raise ValueError(f"variables: {name!r} must be a range that counts up; got {values}")
        return name, "integer", values[0], values[-1], values.step
    lower, upper, step = (*values, 0.0)[:3]
    return name, "continuous", lower, upper, step


def _batch(function: Callable[[Numbers], Numbers], inputs: list[str], outputs: list[str],
           vectorised: bool) -> Callable[[NDArray[np.float64]], NDArray[np.float64]]:
    def together(points: NDArray[np.float64]) -> NDArray[np.float64]:
        answers = _mapping(function(dict(zip(inputs, points.T))), outputs)
        return np.column_stack([np.broadcast_to(floats(name, answers[name]), len(points)) for name in outputs])

    def one_by_one(points: NDArray[np.float64]) -> NDArray[np.float64]:
        rows = []
        for point in points.tolist():
            answer = _mapping(function(dict(zip(inputs, point))), outputs)
            rows.append([float(floats(name, answer[name]).item()) for name in outputs])
        return np.array(rows)

    return together if vectorised else one_by_one


def _mapping(answer: Numbers, outputs: list[str]) -> Numbers:
    if not isinstance(answer, Mapping) or not answer.keys() >= {*outputs}:
        raise KeyError(f"the function must give each of {', '.join(outputs)} by name; got {answer!r}")
    return answer


def _row(inputs: list[str], outputs: list[str], record: _core.Record) -> dict[str, float]:
    point, objectives, constraints, failure, _ = record
    row = dict(zip(inputs, point))
    if not failure:
        row.update(zip(outputs, [*objectives, *constraints]))
    return row
