"""Effects that a model may lack, written in Python."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Optional

import numpy as np
from numpy.typing import NDArray

from coilwright import _core

Vector = NDArray[np.float64]


class Number(NamedTuple):
    """One number of an effect.

    >>> import coilwright as cw
    >>> cw.Number("torque_Nmm", "largest torque", lower=0.0, upper=100.0, absent=0.0).key
    'torque_Nmm'
    """

    key: str
    """Its name, with its unit at the end: "torque_Nmm"; without one it is a plain number."""
    text: str
    """What it is, in one line."""
    lower: float
    """Physical bounds, in the unit of the key; may be infinite."""
    upper: float
    absent: Optional[float] = None
    """The value at which the effect is not there; None for a shape that means nothing by itself."""


class Effect:
    """A torque at the joints that a model may lack: its numbers, and the function that gives it.

    `torques(numbers, angles, rates, currents)` gets its numbers, the joints' angles (rad) and rates (rad/s), base to
    tip, and the coils' currents (A), all in SI, and gives a torque for each joint (N m, opening positive). It must be
    pure, and is called from several threads, one call at a time, in every step of every simulation: some thousand
    times slower than an effect of Coilwright. `starts` are where fits begin, in the units of the keys.

    Once made, it stays in memory as long as the program: models and results refer to it.

    >>> import numpy as np
    >>> import coilwright as cw
    >>> stiffening = cw.Effect(
    ...     "stiffening", stage="hinge", description="silicone that stiffens as it stretches",
    ...     equation="q_j -= k3 theta_j^3", source="a Taylor series",
    ...     numbers=[cw.Number("cubic", "k3, N m/rad^3", lower=0.0, upper=1.0, absent=0.0)],
    ...     starts=[[0.01]], torques=lambda k, angles, rates, currents: -k[0] * angles**3)
    >>> stiffening.id
    'stiffening'
    """

    def __init__(self, id: str, *, stage: str, description: str, equation: str, source: str,
                 numbers: Sequence[Number], starts: Sequence[Sequence[float]],
                 torques: Callable[[Vector, Vector, Vector, Vector], Vector]) -> None:
        self._arguments = dict(id=id, stage=stage, description=description, equation=equation, source=source,
                               numbers=tuple(numbers), starts=tuple(tuple(start) for start in starts),
                               torques=torques)
        self._kind = _core.EffectKind.make(
            id, stage, description, equation, source, [_core.Number(*each) for each in numbers],
            [[float(value) for value in start] for start in starts], torques)

    @property
    def id(self) -> str:
        """What files call it."""
        return str(self._arguments["id"])

    def __repr__(self) -> str:
        return f"<coilwright.Effect {self.id}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _effect_of, (self._arguments,)


def _effect_of(arguments: dict[str, Any]) -> Effect:
    return Effect(**arguments)


def catalogue(own: Sequence[Effect]) -> _core.Effects:
    return _core.Effects([each._kind for each in own])


def effects() -> dict[str, str]:
    """The effects that Coilwright brings, each with what physically happens.

    >>> import coilwright as cw
    >>> cw.effects()["quadratic_drag"]
    'drag that grows with the square of the rate: air'
    """
    return dict(_core.effects())
