"""Forces and torques between coils and magnets."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coilwright import _core
from coilwright._actuator import Path
from coilwright._arrays import floats, json_text, read_only
from coilwright._errors import core_of


class Pair:
    """Coils and magnets in their places, as a file of `coilwright force` has them (docs/formats-pair.md): two, or many.

    >>> import coilwright as cw
    >>> pair = cw.Pair.from_dict({
    ...     "coil": {"inner_radius_mm": 5, "outer_radius_mm": 9, "length_mm": 10, "turns_radial": 8, "turns_axial": 20},
    ...     "magnet": {"radius_mm": 4, "length_mm": 6, "remanence_T": 1.3}, "current_A": 1.4,
    ...     "poses": [{"position_mm": [0, 0, 12], "axis": [0, 0, 1]}]})
    >>> pair.names
    ('coil 1', 'magnet 2')
    """

    def __init__(self, core: _core.Pair) -> None:
        self._core = core

    @classmethod
    def load(cls, path: Path) -> Pair:
        """Reads a file. Raises InputError.

        >>> import coilwright as cw
        >>> try:
        ...     cw.Pair.load("none.json")
        ... except cw.InputError as error:
        ...     print(error)
        none.json: cannot be opened: No such file or directory
        """
        return cls(_core.Pair.load(os.fspath(path)))

    @classmethod
    def from_dict(cls, content: Mapping[str, Any]) -> Pair:
        """The pair of a file's content as `json` reads it. Raises InputError, whose file is "pair".

        >>> import coilwright as cw
        >>> magnet = {"magnet": {"radius_mm": 5, "length_mm": 4, "remanence_T": 1.2}}
        >>> cw.Pair.from_dict({"bodies": [{**magnet, "name": "lower", "position_mm": [0, 0, 0]},
        ...                               {**magnet, "name": "upper", "position_mm": [0, 0, 9]}]}).names
        ('lower', 'upper')
        """
        return cls(_core.Pair.parse(json_text(content, "pair"), "pair"))

    @property
    def names(self) -> tuple[str, ...]:
        """Of the bodies, in their order. The last one is the one that is moved."""
        return self._core.names

    def __repr__(self) -> str:
        return f"<coilwright.Pair of {', '.join(self.names)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _pair_of, (self._core.text, self._core.origin)


def _pair_of(text: str, origin: str) -> Pair:
    return Pair(_core.Pair.parse(text, origin))


class Forces(NamedTuple):
    """What acts in each pose: arrays (poses, bodies, 3), in the axes of the pair; a torque about its body's centre.
    Made by `force`.

    >>> import coilwright as cw
    >>> cw.Forces._fields
    ('force_N', 'torque_Nmm')
    """

    force_N: NDArray[np.float64]
    """On each body, N."""
    torque_Nmm: NDArray[np.float64]
    """On each body, N mm."""


def force(pair: Pair, positions_mm: Optional[ArrayLike] = None, axes: Optional[ArrayLike] = None) -> Forces:
    """Force and torque on each body in many poses of the last one, exact in any pose.

    positions_mm: (poses, 3), of its centre, mm; without them the poses of the pair. axes: (poses, 3) or (3), directions of its
    axis, of any length; without them as in the first pose of the pair. As fast as C++ pose by pose; other threads run
    meanwhile, and Ctrl-C is heard. Raises InputError, also for magnets in one place; warns of coils and axial magnets in
    one place, and of a plate that is no mirror, as the program does.

    >>> import numpy as np, coilwright as cw
    >>> magnet = {"magnet": {"radius_mm": 5, "length_mm": 4, "remanence_T": 1.2}}
    >>> pair = cw.Pair.from_dict({"bodies": [{**magnet, "position_mm": [0, 0, 0]}, {**magnet, "position_mm": [0, 0, 9]}]})
    >>> heights = np.array([[0, 0, 9], [0, 0, 18]])
    >>> force_N, torque_Nmm = cw.force(pair, heights)
    >>> force_N.shape
    (2, 2, 3)
    >>> bool(force_N[0, 1, 2] < force_N[1, 1, 2] < 0)  # the upper magnet is attracted, the farther the less
    True
    >>> bool(np.allclose(force_N[:, 0], -force_N[:, 1]))
    True
    """
    none = np.empty((0, 3))
    positions = none if positions_mm is None else _rows("positions_mm", positions_mm, None)
    if axes is not None and positions_mm is None:
        raise ValueError("axes: must come with positions_mm")
    directions = none if axes is None else _rows("axes", axes, len(positions))
    both = _core.force(core_of(pair, Pair), positions, directions)
    return Forces(read_only(both[:, :, :3]), read_only(both[:, :, 3:]))


def _rows(name: str, values: ArrayLike, count: Optional[int]) -> NDArray[np.float64]:
    rows = np.ascontiguousarray(floats(name, values, whole=True))
    if count is not None and rows.shape == (3,):
        rows = np.tile(rows, (count, 1))
    if rows.ndim != 2 or rows.shape[1] != 3 or (count is not None and len(rows) != count) or len(rows) == 0:
        raise ValueError(f"{name}: must have shape ({count or 'poses'}, 3); got {rows.shape}")
    return rows


class Field(NamedTuple):
    """The flux density at each point. Made by `field`.

    >>> import coilwright as cw
    >>> cw.Field._fields
    ('flux_density_mT', 'gradient_T_m', 'inside')
    """

    flux_density_mT: NDArray[np.float64]
    """(points, 3), B; nan in the iron of a plate and on an edge of a magnet, where it is infinite."""
    gradient_T_m: NDArray[np.float64]
    """(points, 3, 3), dB_i / dx_j; none (0, 3, 3) where it was not asked for."""
    inside: tuple[Optional[str], ...]
    """Name of the body that each point lies in, or "plate"; None outside of all."""


def field(pair: Pair, points_mm: ArrayLike, *, pose: int = 1, gradient: bool = False) -> Field:
    """The flux density of coils and magnets at many points, anywhere: what `coilwright field` prints.

    points_mm: (points, 3) or (3). pose: of the last body, from 1. gradient: also how it changes from there, in twice the
    time. Raises InputError; warns as the program does.

    >>> import coilwright as cw
    >>> magnet = {"magnet": {"radius_mm": 5, "length_mm": 4, "remanence_T": 1.2}}
    >>> pair = cw.Pair.from_dict({"bodies": [{**magnet, "position_mm": [0, 0, 0]}, {**magnet, "position_mm": [0, 0, 9]}]})
    >>> flux = cw.field(pair, [[0, 0, 4.5], [0, 0, 30]]).flux_density_mT
    >>> bool(flux[0, 2] > flux[1, 2] > 0)
    True
    """
    given = floats("points_mm", points_mm, whole=True)
    points = _rows("points_mm", given[None] if given.shape == (3,) else given, None)
    core = core_of(pair, Pair)
    flux, slopes, within = _core.field(core, points, int(pose), bool(gradient))
    names = (None, *pair.names, "plate")  # -1 is the last one
    return Field(read_only(flux), read_only(slopes), tuple(names[number] for number in within))
