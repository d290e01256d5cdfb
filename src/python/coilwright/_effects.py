"""Effects that a model may lack, written in Python."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Optional

from coilwright import _core

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


Function = Callable[..., Any]
# What an effect may give, with the stages that take it.
_STAGES = {"torques": ("magnetics", "hinge", "chain"), "currents": ("drive", "magnetics"), "shown": ("camera",)}


class Effect:
    """Something that a model may lack: its numbers, and the one function of what it changes, all in SI.

    - `torques(numbers, angles, rates, currents)`: adds a torque at each joint, N m, opening positive. Stage magnetics,
      hinge or chain. Angles (rad) and rates (rad/s) of the joints, base to tip; currents (A) of the coils.
    - `currents(numbers, currents)`: turns the coils' currents into others. Stage drive: those that flow; magnetics:
      those by which forces count (a weaker magnet is a smaller current).
    - `shown(numbers, angles, rates)`: gives the joints' angles and rates as the camera shows them. Stage camera.

    States of its own (heat, creep, a filter): `settled(numbers, angles, currents)` gives their values after a long hold,
    as many as there are; the function gets them as its last argument, and gives their slopes behind the rest. slow: they
    take so long that a step's response is taken with them held.

    Functions must be pure, and are called from several threads, one call at a time, in every step of every simulation,
    which takes some hundred times as long as with an effect of Coilwright. `starts` are where fits begin, in the units of
    the keys. Once made, it stays in memory as long as the program: models and results refer to it.

    >>> import coilwright as cw
    >>> def about(id, key):
    ...     return dict(id=id, description=id, equation="see the function", source="of this example", starts=[[0.01]],
    ...                 numbers=[cw.Number(key, "how much of it", lower=0.0, upper=1.0, absent=0.0)])
    >>> stiffening = cw.Effect(**about("stiffening", "cubic"), stage="hinge",
    ...                        torques=lambda k, angles, rates, currents: -k[0] * angles**3)
    >>> leak = cw.Effect(**about("leak", "share"), stage="drive", currents=lambda k, currents: (1 - k[0]) * currents)
    >>> bent_lens = cw.Effect(**about("bent_lens", "share"), stage="camera",
    ...                       shown=lambda k, angles, rates: ((1 + k[0]) * angles, (1 + k[0]) * rates))
    >>> creep = cw.Effect(**about("creep", "stiffness_Nm_rad"), stage="hinge",
    ...                   settled=lambda k, angles, currents: angles,
    ...                   torques=lambda k, angles, rates, currents, crept: (k[0] * (crept - angles), (angles - crept) / 0.3))
    >>> declared = cw.Actuator.prototype().to_dict()
    >>> for effect in (stiffening, leak, bent_lens, creep):
    ...     effects = [{"id": effect.id, "parameters": {effect.numbers[0].key: 0.01}}]
    ...     motion = cw.simulate(cw.Actuator.from_dict({**declared, "effects": effects}, effects=[effect]), step=1.4)
    ...     print(effect.id, f"{motion['bending_angle_deg'][-1]:.2f}")
    stiffening 60.62
    leak 64.99
    bent_lens 65.86
    creep 63.84
    """

    def __init__(self, id: str, *, stage: str, description: str, equation: str, source: str,
                 numbers: Sequence[Number], starts: Sequence[Sequence[float]], torques: Optional[Function] = None,
                 currents: Optional[Function] = None, shown: Optional[Function] = None,
                 settled: Optional[Function] = None, slow: bool = False) -> None:
        self.numbers = tuple(numbers)
        """Its numbers, in the order in which its functions get them."""
        self._arguments = dict(id=id, stage=stage, description=description, equation=equation, source=source,
                               numbers=self.numbers, starts=tuple(tuple(start) for start in starts), torques=torques,
                               currents=currents, shown=shown, settled=settled, slow=slow)
        given = {name: function for name, function in zip(_STAGES, (torques, currents, shown)) if function is not None}
        if len(given) != 1:
            raise ValueError(f"effect {id}: must have one of {', '.join(_STAGES)}; got {', '.join(given) or 'none'}")
        [(gives, acts)] = given.items()
        if stage not in _STAGES[gives]:
            raise ValueError(f"effect {id}: stage must be {' or '.join(_STAGES[gives])} for {gives}; got {stage}")
        self._kind = _core.EffectKind.make(
            id, stage, description, equation, source, [_core.Number(*each) for each in numbers],
            [[float(value) for value in start] for start in starts], gives, acts, settled, slow)

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
