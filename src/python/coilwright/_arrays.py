"""From what Python has of numbers (arrays, masks, times, columns of tables) to arrays of float and to JSON: the one way into
C++."""

from __future__ import annotations

import datetime
import decimal
import json
import math
import numbers
import os
import re
from collections.abc import Mapping, Sequence, Set
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coilwright._errors import InputError

# Columns of time, and what the units of their names are called by NumPy.
_TIME = re.compile(r"(?:time|t)(?:_\w+)?_(s|ms|us|ns|min|h|day)")
_UNITS = {"s": "s", "ms": "ms", "us": "us", "ns": "ns", "min": "m", "h": "h", "day": "D"}
_NUMBERS = "must be numbers, in the unit at the end of its name"


def floats(name: str, values: ArrayLike, *, whole: bool = False) -> NDArray[np.float64]:
    """`values` as numbers, of the same shape, with a nan where one is masked or absent (NaN, NaT, None).

    Durations and stamps of whatever unit (NumPy's, datetime's, pandas') become a time in the unit of the name, stamps from
    the first of them on. whole: nothing may be absent. Raises InputError for what is no number, and for times under the
    name of something else.
    """
    try:
        given: Any = values if isinstance(values, np.ma.MaskedArray) else np.asarray(values)
    except ValueError as ragged:
        raise _fault(name, f"must be an array ({ragged})") from None
    plain: NDArray[Any] = np.asarray(given)
    absent: NDArray[np.bool_] = np.array(np.broadcast_to(getattr(given, "mask", False), plain.shape))
    if plain.dtype.kind == "O":
        plain, absent = _of_objects(name, plain, absent)
    if plain.dtype.kind in "mM":
        out = _times(name, plain, absent)
    elif plain.dtype.kind in "buif":
        out = np.array(plain, float)
    else:
        raise _fault(name, _NUMBERS, f"an array of {plain.dtype}")
    out[absent] = np.nan
    if whole:
        _require_whole(name, out)
    return out


def column(name: str, values: ArrayLike, *, whole: bool = False) -> NDArray[np.float64]:
    """The same of one column. Raises InputError for a table in place of one, too."""
    out = floats(name, values)
    if out.size != max(out.shape, default=1):
        raise _fault(name, "must be one column", f"shape {out.shape}")
    out = out.ravel()
    if whole:
        _require_whole(name, out)
    return out


def json_text(content: Mapping[str, Any], origin: str) -> str:
    """The content of a file as text, whatever mappings, sequences and numbers it is of: NumPy's scalars and arrays, tuples,
    paths. Raises InputError of the file `origin` with the place of what JSON has nothing for: a nan, an object."""
    return json.dumps(plain(content, origin, ""), allow_nan=False)


def plain(value: Any, origin: str, place: str) -> Any:
    """The same as objects of Python's own."""
    if isinstance(value, np.ma.MaskedArray) and np.any(value.mask):
        raise _unfit(origin, place, "must have no masked number", repr(value))
    if isinstance(value, (np.generic, np.ndarray)) and value.dtype.kind in "bOUiuf":
        value = value.tolist()
    if value is None or isinstance(value, (str, bool)):
        return value
    if isinstance(value, Mapping):
        for key in value:
            if not isinstance(key, str):
                raise _unfit(origin, place, "must have texts for names", repr(key))
        return {str(key): plain(each, origin, f"{place}/{key.replace('~', '~0').replace('/', '~1')}")
                for key, each in value.items()}
    if isinstance(value, (Sequence, Set)) and not isinstance(value, (bytes, bytearray)):
        return [plain(each, origin, f"{place}/{i}") for i, each in enumerate(value)]
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, (numbers.Real, decimal.Decimal)) and not isinstance(value, np.timedelta64):
        if isinstance(value, numbers.Integral):
            return int(value)
        if math.isfinite(value):
            return float(value)
        raise _unfit(origin, place, "must be a finite number", repr(value))
    raise _unfit(origin, place, "must be a number, a text, a list or a mapping", f"{value!r} ({type(value).__name__})")


def _unfit(origin: str, place: str, rule: str, value: str) -> InputError:
    where = f"{origin}: {place}" if place else origin
    return InputError(f"{where}: {rule}; got {value}", origin, place, rule, value)


def read_only(array: NDArray[np.float64]) -> NDArray[np.float64]:
    """The array, which can then not be written to: results are immutable."""
    array.flags.writeable = False
    return array


def _require_whole(name: str, values: NDArray[np.float64]) -> None:
    rows = np.isnan(np.atleast_1d(values)).reshape(max(1, len(np.atleast_1d(values))), -1).any(axis=1)
    if rows.any():
        row = int(np.argmax(rows))
        raise _fault(name, f"must have its numbers in every row: leave out row {row + 1} (index {row}), where one is masked, "
                           "NaN or NaT")


def _of_objects(name: str, values: NDArray[Any], mask: NDArray[np.bool_]) -> tuple[NDArray[Any], NDArray[np.bool_]]:
    """Python's objects as numbers or durations, and what of them is absent."""
    absent: NDArray[np.bool_] = mask | np.array([_is_absent(each) for each in values.flat], bool).reshape(values.shape)
    there = list(values[~absent])
    kinds = ", ".join(sorted({type(each).__name__ for each in there}))
    try:
        if all(isinstance(each, (datetime.datetime, np.datetime64)) for each in there):
            # As objects: differences alone keep time zones, and pandas' nanoseconds.
            there = [each - there[0] for each in there]
        if there and all(isinstance(each, (datetime.timedelta, np.timedelta64)) for each in there):
            found = np.array([_duration(each) for each in there], "timedelta64[ns]")
        else:
            found = np.array([_number(each) for each in there], float)
    except (TypeError, ValueError, OverflowError):
        raise _fault(name, _NUMBERS, f"objects of {kinds}") from None
    out = np.zeros(values.shape, found.dtype)
    out[~absent] = found
    return out, absent


def _is_absent(value: Any) -> bool:
    # pandas' NA is equal to nothing, and no truth either.
    if value is None or value is np.ma.masked or type(value).__name__ in ("NAType", "NaTType"):
        return True
    return isinstance(value, (float, np.generic)) and bool(value != value)


def _duration(value: Any) -> np.timedelta64:
    # pandas' own are finer than datetime's, which they are, too.
    return value.to_timedelta64() if hasattr(value, "to_timedelta64") else np.timedelta64(value)  # type: ignore[no-any-return]


def _number(value: Any) -> float:
    if isinstance(value, (str, bytes, datetime.timedelta, np.timedelta64, np.datetime64)):
        raise TypeError
    return float(value)


def _times(name: str, values: NDArray[Any], mask: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Durations, or stamps from the first on, in the unit of the name."""
    unit = _TIME.fullmatch(name)
    if unit is None:
        raise _fault(name, f"{_NUMBERS}; only a column that is called time_s, time_ms, .. takes times",
                     f"an array of {values.dtype}")
    absent = mask | np.isnat(values)
    calendar = np.datetime_data(values.dtype)[0] in ("Y", "M", "generic")
    if values.dtype.kind == "m" and calendar:
        raise _fault(name, "must be durations in a unit that has a length (timedelta64[s], [ms], ..)", str(values.dtype))
    out = np.full(values.shape, np.nan)
    there = values[~absent]
    if there.size and values.dtype.kind == "M":
        there = there.astype("datetime64[s]") if calendar else there
        there = there - there[0]
    out[~absent] = there / np.timedelta64(1, _UNITS[unit[1]])
    return out


def _fault(name: str, rule: str, value: str = "") -> InputError:
    return InputError(f"{name}: {rule}" + (f"; got {value}" if value else ""), name, "", rule, value)
