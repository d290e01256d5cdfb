"""What an actuator does at one operating point."""

from __future__ import annotations

import html
import warnings
from typing import Any, Optional

from coilwright import _core
from coilwright._actuator import Actuator
from coilwright._errors import core_of, number
from coilwright._quantities import Quantities


class Performance(Quantities):
    """What an actuator does at one operating point: every quantity of `coilwright list quantities` as an attribute, in
    the unit at the end of its name. One that has no value (a temperature in a thermal runaway) raises NoPerformance
    with the reason, and is None in `to_dict()`. Made by `evaluate`.

    >>> import coilwright as cw
    >>> finger = cw.Actuator.load("configs/actuators/paper_finger.json")
    >>> performance = cw.evaluate(finger, current=1.4)
    >>> round(performance.steady_angle_deg, 1), round(performance.grasp_force_N, 2)
    (63.6, 1.12)
    >>> performance.actuator == finger
    True
    """

    def __init__(self, core: _core.Performance, actuator: Optional[Actuator] = None, **asked: Any) -> None:
        self._core = core
        self._actuator = actuator
        self._asked = asked

    @property
    def actuator(self) -> Actuator:
        """The actuator that was evaluated."""
        if self._actuator is None:
            self._actuator = Actuator(self._core.actuator())
        return self._actuator

    def to_dict(self) -> dict[str, Any]:
        """Every quantity under its name, joint angles, modes, the operating point, and the limits of the parts: the keys
        of `coilwright evaluate --json`.

        >>> import coilwright as cw
        >>> sorted(cw.evaluate(cw.Actuator.prototype(), current=1).to_dict()["operating_point"])[0]
        'cases'
        """
        content: dict[str, Any] = self._core.to_dict()
        return content

    def assumptions(self) -> list[dict[str, Any]]:
        """Every quantity under each other modelling choice, and with each number that was neither measured nor stated at
        its other values: some eighty evaluations. Empty for a lumped model.

        >>> import coilwright as cw
        >>> len(cw.evaluate(cw.Actuator.prototype(), current=1).assumptions()) > 3
        True
        """
        content: list[dict[str, Any]] = self._core.choices()
        return content

    @property
    def text(self) -> str:
        """What the program prints of it: the limits of its parts, and a line a quantity."""
        return self._core.text

    def _repr_html_(self) -> str:
        return f"<p><b>{html.escape(self.actuator.name)}</b></p>{self._core.html}"

    def __repr__(self) -> str:
        return f"<coilwright.Performance of {self.actuator.name!r}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return _evaluated, (self.actuator, self._asked)


def _evaluated(actuator: Actuator, asked: dict[str, Any]) -> Performance:
    return evaluate(actuator, **asked)


def evaluate(actuator: Actuator, *, current: Optional[float] = None, duty: Optional[float] = None,
             grasp_opening_deg: Optional[float] = None, grasp_height_mm: Optional[float] = None,
             wiring: Optional[str] = None, supply_resistance: Optional[float] = None,
             supply_voltage: Optional[float] = None) -> Performance:
    """What an actuator does at one current: angles, speed, damping, grasp force, temperatures, mass and cost.

    current: in every coil, A; positive bends the actuator. duty: fraction of the time for which it is on, 0 to 1; for
    heat alone. grasp_opening_deg, grasp_height_mm: where grasp forces are taken. wiring: "parallel" or "series".
    supply_resistance: inside the supply and its leads, ohm. supply_voltage: of the supply without load, V.
    What is None is as the actuator's operating point has it, which `size` writes. Other threads run meanwhile. Raises
    InputError for a design that cannot be built, NoPerformance with the reason where it has no performance. Warns of each
    limit of coils, magnets, wire and supply that is broken, once a line of yours.

    >>> import coilwright as cw
    >>> finger = cw.Actuator.prototype()
    >>> speeds = [cw.evaluate(finger, current=i).peak_bending_speed_deg_s for i in (0.7, 1.4)]
    >>> speeds[0] < speeds[1]
    True
    """
    performance, remarks = evaluated(actuator, current=current, duty=duty, grasp_opening_deg=grasp_opening_deg,
                                     grasp_height_mm=grasp_height_mm, wiring=wiring, supply_resistance=supply_resistance,
                                     supply_voltage=supply_voltage)
    for remark in remarks:
        warnings.warn(remark, stacklevel=2)
    return performance


def evaluated(actuator: Actuator, *, wiring: Optional[str] = None, **asked: Optional[float]) -> tuple[Performance, list[str]]:
    """The same, with what is to be warned of in place of warnings."""
    numbers = {name: None if value is None else number(name, value) for name, value in asked.items()}
    if wiring not in (None, "parallel", "series"):
        raise ValueError(f"wiring: must be 'parallel' or 'series'; got {wiring!r}")
    core, remarks = _core.evaluate(core_of(actuator, Actuator), None if wiring is None else wiring == "series", **numbers)
    return Performance(core, actuator, wiring=wiring, **numbers), remarks
