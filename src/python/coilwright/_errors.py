"""What Coilwright raises beside Python's own exceptions, and arguments of another type than they must have."""

import datetime
import operator
from typing import Any, Optional, SupportsIndex

import numpy as np


class InputError(ValueError):
    """An input that cannot be used: a file, or a value in memory. Its text is the line that the program prints.

    >>> import coilwright as cw
    >>> try:
    ...     cw.Actuator.prototype().replace(gap_mm=-1)
    ... except cw.InputError as error:
    ...     print(error)
    ...     error.file, error.rule
    gap_mm=-1.0: must be from 0.05 to 1000
    ('gap_mm=-1.0', 'must be from 0.05 to 1000')
    """

    file: str
    """The file as it was given, or what stands for it."""
    place: str
    """JSON pointer, or line and column; empty where it is the file as a whole."""
    rule: str
    """What is asked, as the end of a sentence."""
    value: str
    """What stands there instead; empty where there is nothing to show."""

    def __init__(self, text: str, file: str = "", place: str = "", rule: str = "", value: str = "") -> None:
        super().__init__(text, file, place, rule, value)
        self.file, self.place, self.rule, self.value = file, place, rule, value

    def __str__(self) -> str:
        return str(self.args[0])


class OutputError(OSError):
    """A file or folder that cannot be written.

    >>> import coilwright as cw
    >>> issubclass(cw.OutputError, OSError)
    True
    """


class NoPerformance(RuntimeError):
    """An actuator that can be built and has no performance at its operating point, with the reason.

    >>> import coilwright as cw
    >>> try:
    ...     cw.evaluate(cw.Actuator.prototype(), current=1e5)
    ... except cw.NoPerformance as reason:
    ...     print(str(reason).split(";")[0])
    actuator: the step from rest does not settle: a joint folds, or it rings beyond 60 s
    """


def number(name: str, value: Any) -> float:
    """An argument as a number. Raises TypeError with its name where it is none: also for a duration of NumPy's, of which
    float() would forget the unit."""
    try:
        if isinstance(value, (np.timedelta64, np.datetime64)) or value is np.ma.masked:
            raise TypeError
        return float(value)
    except (TypeError, ValueError):
        is_duration = isinstance(value, (np.timedelta64, datetime.timedelta))
        cure = " (of a duration: / numpy.timedelta64(1, 's'))" if is_duration else ""
        raise TypeError(f"{name}: must be a number{cure}; got {value!r}") from None


def whole(name: str, value: Optional[int]) -> Optional[int]:
    """An argument as a whole number that is not negative, or None. Raises ValueError with its name."""
    if value is not None and (not isinstance(value, SupportsIndex) or value < 0):
        raise ValueError(f"{name}: must be a whole number >= 0; got {value!r}")
    return None if value is None else operator.index(value)


def core_of(value: Any, kind: type) -> Any:
    """What C++ has of an argument, which is of `kind`. Raises TypeError for anything else, as the path of one."""
    if not isinstance(value, kind):
        name = kind.__name__
        raise TypeError(f"{name.lower()}: must be a coilwright.{name}, as {name}.load gives; got {value!r}")
    return value._core  # type: ignore[attr-defined]
