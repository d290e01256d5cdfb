"""Motions over time."""

from __future__ import annotations

import importlib
import os
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from coilwright import _core
from coilwright._actuator import Actuator, Path
from coilwright._arrays import read_only
from coilwright._errors import core_of, number
from coilwright._tables import Columns, csv_text, place_of


class Motion(Mapping[str, NDArray[np.float64]]):
    """A motion: a mapping from the columns of `coilwright simulate` to their samples, which cannot be written to. Made by
    `simulate`.

    >>> import coilwright as cw
    >>> motion = cw.simulate(cw.Actuator.prototype(), step=1.4, duration=0.1)
    >>> motion.columns
    ['time_s', 'current_A', 'theta1_deg', 'theta2_deg', 'bending_angle_deg', 'bending_speed_deg_s']
    >>> motion["time_s"].shape, motion.rows.shape, len(motion), "theta1_deg" in motion
    ((51,), (51, 6), 6, True)
    """

    def __init__(self, columns: Sequence[str], rows: NDArray[np.float64], title: str) -> None:
        self._columns = tuple(columns)
        self._rows = read_only(np.array(rows))
        self._title = title

    @property
    def columns(self) -> list[str]:
        """Names of the columns, each with its unit at its end."""
        return list(self._columns)

    @property
    def rows(self) -> NDArray[np.float64]:
        """(samples, columns)"""
        return self._rows

    def __getitem__(self, column: str) -> NDArray[np.float64]:
        return self._rows[:, place_of(column, self.columns)]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __reduce__(self) -> tuple[Any, ...]:
        return Motion, (self._columns, self._rows, self._title)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Motion) and self._columns == other._columns and np.array_equal(self._rows, other._rows)

    def __hash__(self) -> int:
        return hash((self._columns, self._rows.tobytes()))

    def to_frame(self) -> Any:
        """As a pandas DataFrame, where pandas is installed."""
        return importlib.import_module("pandas").DataFrame(self.rows, columns=self.columns)

    def plot(self, axes: Any = None, **keywords: Any) -> Any:
        """The bending angle over time, where matplotlib is installed; gives the axes. keywords: of its `plot`."""
        from coilwright import _plots
        return _plots.motion(self, self._title, axes, keywords)

    def __repr__(self) -> str:
        return f"<coilwright.Motion of {self._title!r}, {len(self._rows)} samples>"


def simulate(actuator: Actuator, *, step: Optional[float] = None, sine: Optional[tuple[float, float, float]] = None,
             input: Union[Columns, Path, None] = None, duration: float = 1.0,
             interval: Optional[float] = None, as_written: bool = False) -> Motion:
    """The motion of an actuator under one input: a step, a sine, or a table.

    step: current in every coil from time 0 on, A; the actuator starts at rest without current. sine: amplitude (A),
    offset (A) and frequency (Hz) of the current; it starts at rest under the first sample. input: columns of arrays (or
    a CSV file) with time_s and current_A, or current1_A.., voltage_V, torque1_Nm..; held between samples; likewise. A
    time may be of any kind (docs/python.md); none of these numbers may be masked or absent.
    duration: of a step or a sine, s. interval: between samples, s (0.002); of an input the longest between samples.
    as_written: take an input also where its current is one that no coil carries, as milliamperes for amperes.
    bending_angle_deg is what the camera shows, if the actuator declares one; the rest as it is. Raises InputError, and
    RuntimeError with the reason where there is no motion; warns of what the program says on standard error.

    >>> import numpy as np, coilwright as cw
    >>> time = np.linspace(0, 0.2, 101)
    >>> motion = cw.simulate(cw.Actuator.prototype(), input={"time_s": time, "current_A": np.where(time < 0.1, 0, 1)})
    >>> bool(motion["bending_angle_deg"][-1] > motion["bending_angle_deg"][0] + 10)
    True
    """
    if sum(each is not None for each in (step, sine, input)) != 1:
        raise ValueError("give one of step, sine and input")
    command = _command(step, sine, input, number("duration", duration), None if interval is None else number("interval", interval),
                       as_written)
    columns, rows = _core.simulate(core_of(actuator, Actuator), command)
    return Motion(columns, rows, actuator.name)


def _command(step: Optional[float], sine: Optional[tuple[float, float, float]], input: Union[Columns, Path, None],
             duration: float, interval: Optional[float], as_written: bool) -> _core.Command:
    usual = 0.002 if interval is None else interval
    if step is not None:
        return _core.Command.step(number("step", step), duration, usual)
    if sine is not None:
        if len(sine) != 3:
            raise ValueError(f"sine: must be amplitude (A), offset (A) and frequency (Hz); got {sine!r}")
        return _core.Command.sine([number("sine", each) for each in sine], duration, usual)
    if isinstance(input, (str, os.PathLike)):
        return _core.Command.table(_core.read_text(os.fspath(input)), os.fspath(input), interval, as_written)
    assert input is not None
    text = csv_text(input, "input", ("time", "current", "voltage", "torque"))
    return _core.Command.table(text, "input", interval, as_written)
