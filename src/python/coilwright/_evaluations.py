"""Many designs of an actuator at many operating points."""

from __future__ import annotations

import collections
import os
import warnings
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coilwright import _core
from coilwright._actuator import Actuator
from coilwright._arrays import floats, read_only
from coilwright._errors import InputError, NoPerformance, whole
from coilwright._performance import evaluated

_OPERATING = frozenset({"current", "duty", "grasp_opening_deg", "grasp_height_mm", "wiring", "supply_resistance",
                        "supply_voltage"})


def evaluate_all(actuator: Actuator, columns: Mapping[str, ArrayLike], *, threads: int = 0,
                 **asked: Any) -> dict[str, Union[NDArray[np.float64], list[Optional[str]]]]:
    """Every quantity of many designs: `evaluate` of `actuator.replace(..)` row by row, on several threads.

    columns: arrays of one shape, or numbers, which stand for all; by the names of numbers of the actuator ("gap_mm") and of
    what `evaluate` is told ("current", "duty", ..). asked: what is told of all. Gives each quantity in that shape, nan where
    a design has none, and under "failure" for each design, in order, why it has no performance (also where one of its
    numbers is masked or NaN), or None. Raises InputError for a name that is no number of the actuator. Warns of each limit
    that is broken once, with how many designs break it.

    >>> import numpy as np, coilwright as cw
    >>> gaps, currents = np.meshgrid([0.8, 1.0, 1.2], [0.7, 1.4])
    >>> found = cw.evaluate_all(cw.Actuator.prototype(), {"gap_mm": gaps, "current": currents})
    >>> found["steady_angle_deg"].shape, bool(found["grasp_force_N"][1, 0] > found["grasp_force_N"][0, 0])
    ((2, 3), True)
    """
    for name in set(asked) - _OPERATING:
        raise TypeError(f"{name}: is none of {', '.join(sorted(_OPERATING))}")
    arrays = np.broadcast_arrays(*(_values(name, columns[name]) for name in columns))
    shape = arrays[0].shape if arrays else ()
    rows = [dict(zip(columns, (each.item() for each in row))) for row in zip(*(np.ravel(each)[..., None] for each in arrays))]
    names = [name for name, _, _ in _core.quantities()]

    for name in (name for name in columns if name not in _OPERATING and rows):
        _require_number_of(actuator, name, rows[0][name])

    def one(row: dict[str, Any]) -> tuple[list[float], Optional[str], list[str]]:
        changes = {name: value for name, value in row.items() if name not in _OPERATING}
        told = {**dict.fromkeys(_OPERATING), **asked, **{name: value for name, value in row.items() if name in _OPERATING}}
        try:
            performance, remarks = evaluated(actuator.replace(**changes) if changes else actuator, **told)
        except (InputError, NoPerformance) as reason:
            return [np.nan] * len(names), str(reason), []
        values = [performance._core.value(name) for name in names]
        return [np.nan if value is None else value for value in values], None, remarks

    with ThreadPoolExecutor(whole("threads", threads) or os.cpu_count()) as pool:
        found = list(pool.map(one, rows))
    for remark, count in collections.Counter(each for _, _, remarks in found for each in remarks).items():
        warnings.warn(f"{remark} ({count} of {len(found)} designs)", stacklevel=2)
    numbers = np.array([values for values, _, _ in found], float).reshape(len(found), len(names))
    out: dict[str, Union[NDArray[np.float64], list[Optional[str]]]] = {
        name: read_only(numbers[:, i].reshape(shape)) for i, name in enumerate(names)}
    out["failure"] = [reason for _, reason, _ in found]
    return out


def _values(name: str, given: ArrayLike) -> NDArray[Any]:
    """Numbers, with a nan where one is masked or absent; or words."""
    words = np.asarray(given)
    return words if words.dtype.kind in "US" or all(isinstance(each, str) for each in words.flat) else floats(name, given)


def _require_number_of(actuator: Actuator, name: str, value: Union[float, str]) -> None:
    """Raises InputError for what no design could be told, whatever the value."""
    try:
        actuator.replace(**{name: value})
    except InputError as fault:
        if not actuator.is_design or fault.rule.startswith("is not a number of a design"):
            raise
