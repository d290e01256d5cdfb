"""The angles of a finger from films of its tags."""

from __future__ import annotations

import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

import numpy as np

from coilwright import _core
from coilwright._actuator import Path
from coilwright._diagnosis import Records, _require_file_names
from coilwright._errors import number
from coilwright._tables import Columns, csv_text


class Tracked(NamedTuple):
    """What films showed. Made by `track`.

    >>> import coilwright as cw
    >>> cw.Tracked._fields
    ('records', 'content', 'text', 'previews')
    """

    records: Records
    """A motion of each film and, where one shows the noise, a still run. A data set where each film has its log."""
    content: dict[str, Any]
    """What `coilwright track --json` prints: numbers of each film, what was guessed, what is to be said."""
    text: str
    """The same for people."""
    previews: dict[str, list[bytes]]
    """PNG pictures of each film with what was read drawn in, if asked for."""


def track(films: Union[Path, Sequence[Path]], current: Union[Columns, Path, Sequence[Union[Columns, Path]], None] = None, *,
          lens: Optional[Path] = None, rate_Hz: Optional[float] = None, exposure_ms: Optional[float] = None,
          readout_ms: Optional[float] = None, led: Optional[tuple[float, float]] = None, opens: Optional[str] = None,
          start_deg: Union[float, Sequence[float]] = (), preview: bool = False, name: str = "films") -> Tracked:
    """The angles of a finger, from films of its tags (docs/how_to/film_a_finger.md): the records of `coilwright track`.

    films: a file, or one for each motion. current: a log of the input for each: columns of arrays, or a CSV file, with
    time_s and current_A (or current1_A.., voltage_V); its first step is where the finger begins to move. lens: a file of
    `coilwright lens`. rate_Hz: at which it was filmed, where the file plays slower. exposure_ms, readout_ms: of the camera,
    otherwise by what moves. led: X, Y of an LED that is lit with the first step, px. opens: "clockwise" or
    "counterclockwise" as seen, otherwise as the tip goes farthest. start_deg: angles at the beginning of the first film, one
    for each tag but the base's. preview: keep a dozen pictures of each. name: of the data set. Needs OpenCV: raises
    RuntimeError that says what to install. Raises InputError for a film or a log that cannot be used. Ctrl-C ends it.

    >>> import coilwright as cw
    >>> try:
    ...     cw.track("configs/actuators/paper_finger.json")
    ... except (cw.InputError, RuntimeError) as error:
    ...     print("film" in str(error))
    True
    """
    paths = [os.fspath(film) for film in ([films] if isinstance(films, (str, os.PathLike)) else films)]
    if not paths:
        raise ValueError("films: must name a film or more")
    _require_file_names(pathlib.Path(film).stem + ".csv" for film in paths)
    given: Any = current
    if isinstance(current, (str, os.PathLike, Mapping)) or hasattr(current, "columns"):  # a DataFrame is no Mapping
        given = [current]
    logs = [_log(film, log) for film, log in zip(paths, given or ())]
    if given is not None and len(given) != len(paths):
        raise ValueError(f"current: needs one log for each film, {len(paths)}; got {len(given)}")
    if opens not in (None, "clockwise", "counterclockwise"):
        raise ValueError(f"opens: must be 'clockwise' or 'counterclockwise'; got {opens!r}")
    if led is not None and len(led) != 2:
        raise ValueError(f"led: must be the place in the picture, (X, Y); got {led!r}")
    angles: Any = start_deg
    said = dict(lens=None if lens is None else os.fspath(lens), opens=opens, preview=bool(preview),
                rate_Hz=_number("rate_Hz", rate_Hz), exposure_ms=_number("exposure_ms", exposure_ms),
                readout_ms=_number("readout_ms", readout_ms),
                led=None if led is None else tuple(_number("led", each) for each in led),
                start_deg=[_number("start_deg", each) for each in (angles if np.ndim(angles) else [angles])])
    dataset, files, content, text, previews = _core.track(name, paths, logs, said)
    return Tracked(Records(dataset, files), content, text, previews)


def _number(name: str, value: Optional[float]) -> Optional[float]:
    return None if value is None else number(name, value)


def _log(film: str, log: Union[Columns, Path]) -> tuple[str, str]:
    """Its text, and what errors call it."""
    if isinstance(log, (str, os.PathLike)):
        return _core.read_text(os.fspath(log)), os.fspath(log)
    origin = f"current of {pathlib.Path(film).name}"
    return csv_text(log, origin, ("time", "current", "voltage", "torque")), origin
