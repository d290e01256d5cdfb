"""What a model predicts of records, and how far it is off: of any model, without a fit."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from coilwright._actuator import Actuator
from coilwright._arrays import read_only
from coilwright._diagnosis import Records, _file_of, require_no_slip
from coilwright._errors import InputError, core_of
from coilwright._motion import simulate
from coilwright._tables import Table

_USUAL = {"current": "current_A (or current1_A..)", "voltage": "voltage_V", "torque": "torque1_Nm.."}
Channels = dict[str, NDArray[np.float64]]


def predict(actuator: Actuator, records: Records, runs: Optional[Sequence[str]] = None, *,
            as_written: bool = False) -> dict[str, Channels]:
    """What a model would show in place of records: for each run its measured columns, at its times.

    actuator: the declared one, or `diagnosis.actuator`, or any other. runs: file names; without them all motions. Each is
    simulated from rest under its first input, as `simulate` does, without a fitted start, clock or zero: new records then
    score a model as it is. as_written: also where another unit or sign makes far more of a record, which is refused
    otherwise, as by `diagnose`. Raises InputError for that, for a run that is no motion from rest, whose columns have no
    names of the program, or that goes on where its input has ended.

    >>> import coilwright as cw
    >>> finger = cw.Actuator.prototype()
    >>> records = cw.twin(finger, "configs/experiments/paper.json")
    >>> shown = cw.predict(finger, records, ["step_0.70A.csv"])
    >>> list(shown["step_0.70A.csv"])
    ['bending_angle_deg']
    """
    core_of(actuator, Actuator)
    if not isinstance(records, Records):
        raise TypeError(f"records: must be coilwright.Records, as Records.load gives; got {records!r}")
    if isinstance(runs, str):
        raise TypeError(f"runs: must be a list of file names, [{runs!r}]; got {runs!r}")
    entries: dict[str, Mapping[str, Any]] = {run["file"]: run for run in records.dataset["runs"]}
    names = [name for name, run in entries.items() if run.get("kind") == "transient"] if runs is None else list(runs)
    unknown = [name for name in names if name not in entries]
    if unknown:
        raise ValueError(f"runs: the records have no {', '.join(unknown)}; they have {', '.join(entries)}")
    replays = {name: _replay(records, name, entries[name]) for name in names}
    if not as_written:
        require_no_slip(records, actuator)
    return {name: _prediction(actuator, name, replay) for name, replay in replays.items()}


def score(actuator: Actuator, records: Records, runs: Optional[Sequence[str]] = None, *,
          as_written: bool = False) -> dict[str, dict[str, dict[str, float]]]:
    """How far `predict` is off, for each run and measured column: "rmse", "mae", "max" and "samples", in its unit. Absent
    samples do not count. Arguments and errors are those of `predict`.

    >>> import coilwright as cw
    >>> finger = cw.Actuator.prototype()
    >>> records = cw.twin(finger, "configs/experiments/paper.json", noise={"angle_deg": 0.2}, seed=2)
    >>> round(cw.score(finger, records)["step_0.70A.csv"]["bending_angle_deg"]["rmse"], 1)
    0.2
    """
    out: dict[str, dict[str, dict[str, float]]] = {}
    for run, shown in predict(actuator, records, runs, as_written=as_written).items():
        table = records[run]
        out[run] = {}
        for channel, values in shown.items():
            off = np.asarray(table[channel], float) - values
            off = off[~np.isnan(off)]
            if not off.size:
                raise InputError(f"{run}: {channel}: must have a sample to be scored", run, channel, "must have a sample to be "
                                 "scored", "")
            out[run][channel] = {"rmse": float(np.sqrt(np.mean(off**2))), "mae": float(np.mean(np.abs(off))),
                                 "max": float(np.max(np.abs(off))), "samples": float(len(off))}
    return out


def _refused(name: str, rule: str) -> InputError:
    return InputError(f"{name}: {rule}", name, "", rule, "")


class _Replay(NamedTuple):
    """A run and its input, which may be in a file of its own."""

    table: Table
    input: dict[str, NDArray[Any]]


def _replay(records: Records, name: str, run: Mapping[str, Any]) -> _Replay:
    if run.get("kind") != "transient" or run.get("start", "at_rest") != "at_rest":
        raise _refused(name, 'must be a motion ("transient") that starts "at_rest", to be predicted without a fit')
    table, source = records[name], records[_file_of(run.get("input_file")) or name]
    drive = run.get("drive", "current")
    driven = [column for column in source.columns if column.startswith(drive)]
    if "time_s" not in table.columns or "time_s" not in source.columns or not driven:
        raise _refused(name, f"must have the columns time_s and {_USUAL[drive]}, as the program names them, to be predicted, "
                       f"and has {', '.join(table.columns)}: make records of arrays by those names (Records.of)")
    time = np.asarray(table["time_s"], float)
    given = np.asarray(source["time_s"], float)
    last = given[-1] + float(np.max(np.diff(given), initial=0.0))  # the last sample is held as long as any
    if time.size and (time.min() < given[0] or time.max() > last):
        raise _refused(name, f"must lie within its input, from {given[0]:.6g} to {last:.6g} s, to be predicted; it is from "
                       f"{time.min():.6g} to {time.max():.6g} s: leave out the samples beyond, or record the input longer")
    return _Replay(table, {column: source[column] for column in ("time_s", *driven)})


def _prediction(actuator: Actuator, name: str, replay: _Replay) -> Channels:
    motion = simulate(actuator, input=replay.input)
    channels = [column for column in replay.table.columns if column in motion and column not in replay.input]
    if not channels:
        raise _refused(name, "must have a measured column of a motion, as bending_angle_deg or theta1_deg, and has "
                       f"{', '.join(replay.table.columns)}: make records of arrays by those names (Records.of)")
    time = np.asarray(replay.table["time_s"], float)
    return {column: read_only(np.interp(time, motion["time_s"], motion[column])) for column in channels}
