"""Studies: which numbers of a design vary, what is wanted, what is forbidden."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

from coilwright import _core
from coilwright._actuator import Actuator, Path
from coilwright._arrays import json_text, plain
from coilwright._effects import Effect, catalogue
from coilwright._errors import number
from coilwright._performance import Performance

if TYPE_CHECKING:
    from coilwright._diagnosis import Diagnosis


class Quantity(NamedTuple):
    """A quantity of one's own, for objectives, constraints and columns of a study.

    `function` gets a Performance and gives a number, or None where there is none. It must be pure, and is called from
    several threads, one call at a time.

    >>> import coilwright as cw
    >>> grip = cw.Quantity("grip_per_mass_N_kg", lambda p: p.grasp_force_N / p.mass_g * 1000, "grasp force per mass")
    >>> grip.function(cw.evaluate(cw.Actuator.prototype(), current=1)) > 5
    True
    """

    name: str
    """Ends with its unit; a plain number without one."""
    function: Callable[[Performance], Optional[float]]
    meaning: str = "a function of Python"
    """One line for people."""
    scale: float = 1.0
    """An ordinary magnitude, in its unit, > 0."""


class Study:
    """A study, read and checked, immutable: a file of docs/formats-study.md.

    >>> import coilwright as cw
    >>> study = cw.Study.load("configs/studies/fastest_finger.json", set={"/search/max_evaluations": 30})
    >>> study.objectives, study.limits[3]
    (['peak_bending_speed_deg_s'], 'mass_g <= 70')
    """

    def __init__(self, text: str, origin: str, actuator: Optional[Actuator], changes: Sequence[str],
                 quantities: Sequence[Quantity], effects: Sequence[Effect], posterior: Optional[str] = None) -> None:
        self._effects = tuple(effects)
        self._made_of = (text, origin, actuator, tuple(changes), tuple(quantities), tuple(effects), posterior)
        self._core = _core.Study.parse(text, origin, None if actuator is None else actuator._core, list(changes),
                                       [_row(each) for each in quantities], catalogue(effects), posterior)

    @classmethod
    def load(cls, path: Path, *, set: Mapping[str, Union[float, str]] = {}, actuator: Optional[Actuator] = None,
             quantities: Sequence[Quantity] = (), effects: Sequence[Effect] = (),
             posterior: Optional[Diagnosis] = None) -> Study:
        """Reads a file. set: numbers of its actuator by name, or of the study by JSON pointer, as --set of the program.
        actuator: in place of the one that it names. quantities: its objectives, constraints and columns may name them.
        effects: its actuator may have them. posterior: in place of the diagnosis that its spread names. Raises InputError.

        >>> import coilwright as cw
        >>> cw.Study.load("configs/studies/fastest_finger.json", set={"/constraints/3/at_most": 60}).limits[3]
        'mass_g <= 60'
        """
        origin = os.fspath(path)
        return cls(_core.read_text(origin), origin, actuator, _assignments(set), quantities, effects, _json_of(posterior))

    @classmethod
    def from_dict(cls, content: Mapping[str, Any], actuator: Optional[Actuator] = None, *,
                  quantities: Sequence[Quantity] = (), effects: Sequence[Effect] = (),
                  posterior: Optional[Diagnosis] = None) -> Study:
        """The study of a file's content as `json` reads it; without an actuator of yours, of the file that it names,
        from the working folder; likewise of the diagnosis. Raises InputError, whose file is "study".

        >>> import coilwright as cw
        >>> cw.Study.from_dict({"format": "study/1", "name": "light", "operating_point": {"current_A": 1.0},
        ...                     "variables": {"turns_radial": {"lower": 8, "upper": 18}},
        ...                     "objectives": [{"minimise": "mass_g"}]}, cw.Actuator.prototype()).variables
        ['turns_radial']
        """
        if actuator is not None:
            content = {"actuator": "actuator.json", **content}
        return cls(json_text(content, "study"), "study", actuator, (), quantities, effects, _json_of(posterior))

    def _of(self, actuator: Actuator) -> _core.Study:
        """The same study of another actuator."""
        text, origin, _, changes, quantities, effects, posterior = self._made_of
        return Study(text, origin, actuator, changes, quantities, effects, posterior)._core

    @property
    def name(self) -> str:
        """For people; given to the design found."""
        return self._core.name

    @property
    def variables(self) -> list[str]:
        """Names of what varies, each with its unit."""
        return self._core.variables

    @property
    def objectives(self) -> list[str]:
        """Names of the quantities that are wanted large or small."""
        return self._core.objectives

    @property
    def limits(self) -> list[str]:
        """What is forbidden to pass: "mass_g <= 70"."""
        return self._core.limits

    def __repr__(self) -> str:
        return f"<coilwright.Study {self.name!r}: {', '.join(self.objectives)} over {', '.join(self.variables)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Study, self._made_of


def _json_of(posterior: Optional[Diagnosis]) -> Optional[str]:
    return None if posterior is None else posterior._core.json


def _assignments(changes: Mapping[str, Union[float, str]]) -> list[str]:
    return [f"{name}={value if isinstance(value, str) else repr(plain(value, 'set', name))}" for name, value in changes.items()]


def _row(quantity: Quantity) -> tuple[str, str, float, Callable[[_core.Performance], Optional[float]]]:
    def value(core: _core.Performance) -> Optional[float]:
        given = quantity.function(Performance(core))
        return None if given is None else number(f"quantity {quantity.name}: its function", given)

    return quantity.name, quantity.meaning, quantity.scale, value
