"""Plots by matplotlib, which is asked for only here."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from coilwright._diagnosis import Diagnosis
    from coilwright._motion import Motion
    from coilwright._tables import Table


def _axes(axes: Any) -> Any:
    return axes if axes is not None else importlib.import_module("matplotlib.pyplot").figure().add_subplot()


def motion(of: Motion, title: str, axes: Any, keywords: dict[str, Any]) -> Any:
    axes = _axes(axes)
    axes.plot(of["time_s"], of["bending_angle_deg"], **keywords)
    axes.set(xlabel="time (s)", ylabel="bending angle (deg)", title=title)
    return axes


def table(of: Table, x: str, y: str, axes: Any, keywords: dict[str, Any]) -> Any:
    axes = _axes(axes)
    axes.plot(of[x], of[y], **{"marker": "o", "linestyle": "none", **keywords})
    axes.set(xlabel=x, ylabel=y)
    return axes


def residuals(of: Diagnosis, run: str, axes: Any, keywords: dict[str, Any]) -> Any:
    axes = _axes(axes)
    rows = [row for row in of.residuals() if row["run"] == run]
    time = [row["time_s"] for row in rows]
    for name, label, style in (("measured", "measured", "k."), ("declared", "declared", ":"), ("after", "corrected", "-")):
        axes.plot(time, [row[name] for row in rows], style, **{"label": label, **keywords})
    axes.set(xlabel="time (s)", ylabel=rows[0]["channel"], title=run)
    axes.legend()
    return axes
