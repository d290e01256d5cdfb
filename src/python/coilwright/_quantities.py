"""The quantities of a Performance as attributes; _quantities.pyi lists them for type checkers."""

from __future__ import annotations

from coilwright import _core
from coilwright._errors import NoPerformance


def _attribute(name: str, meaning: str, absence: str) -> property:
    def value(self: Quantities) -> float:
        number = self._core.value(name)
        if number is None:
            raise NoPerformance(f"{name}: has no value: {absence or 'it needs a design, and this is a lumped model'}")
        return number

    return property(value, doc=f"{meaning}; in the unit of its name." +
                    (f" Raises NoPerformance where {absence}." if absence else ""))


class Quantities:
    _core: _core.Performance


for _name, _meaning, _absence in _core.quantities():
    setattr(Quantities, _name, _attribute(_name, _meaning, _absence))
