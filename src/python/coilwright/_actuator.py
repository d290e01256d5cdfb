"""Actuators: a design with its dimensions, or a model given by its lumps."""

from __future__ import annotations

import json
import os
import pathlib
from collections.abc import Mapping, Sequence
from typing import Any, Union

from coilwright import _core
from coilwright._arrays import json_text
from coilwright._effects import Effect, catalogue
from coilwright._errors import number

Path = Union[str, "os.PathLike[str]"]


class Actuator:
    """An actuator, immutable: what a file of the program holds (actuator/1 or lumped-model/1, docs/formats-actuator.md).

    Make one by `load`, `from_dict` or `prototype`. Two are equal where their files would be.

    >>> import coilwright as cw
    >>> finger = cw.Actuator.load("configs/actuators/paper_finger.json")
    >>> finger.name
    'paper finger'
    >>> wider = finger.replace(gap_mm=1.1, magnet_grade="N45")
    >>> wider["body"]["gap_mm"], finger == wider
    (1.1, False)
    """

    def __init__(self, core: _core.Actuator, effects: Sequence[Effect] = ()) -> None:
        self._core = core
        self._effects = tuple(effects)

    @classmethod
    def load(cls, path: Path, *, effects: Sequence[Effect] = ()) -> Actuator:
        """Reads a file. `effects` are those written in Python that it may name. Raises InputError.

        >>> import coilwright as cw
        >>> cw.Actuator.load("configs/actuators/paper_finger.json").is_design
        True
        """
        return cls(_core.Actuator.load(os.fspath(path), catalogue(effects)), effects)

    @classmethod
    def from_dict(cls, content: Mapping[str, Any], *, effects: Sequence[Effect] = ()) -> Actuator:
        """The actuator of a file's content as `json` reads it. Raises InputError, whose file is "actuator".

        >>> import coilwright as cw
        >>> finger = cw.Actuator.prototype()
        >>> cw.Actuator.from_dict(finger.to_dict()) == finger
        True
        """
        return cls._parse(json_text(content, "actuator"), "actuator", tuple(effects))

    @classmethod
    def prototype(cls) -> Actuator:
        """The prototype of the source paper by its dimensions alone: a design in which nothing was changed yet.

        >>> import coilwright as cw
        >>> cw.Actuator.prototype().is_design
        True
        """
        return cls(_core.Actuator.prototype())

    @classmethod
    def _parse(cls, text: str, origin: str, effects: tuple[Effect, ...]) -> Actuator:
        return cls(_core.Actuator.parse(text, origin, catalogue(effects)), effects)

    def replace(self, **numbers: Union[float, str]) -> Actuator:
        """The same design with other numbers, by the names that studies vary (`coilwright list parameters`), each in the
        unit of its name; `configuration="C"`; of an effect it has `**{"dry_friction.torque_Nmm": 0.5}`. Raises
        InputError.

        >>> import coilwright as cw
        >>> cw.Actuator.prototype().replace(gap_mm=1.2)["body"]["gap_mm"]
        1.2
        """
        words = [f"{name}={value if isinstance(value, str) else repr(number(name, value))}" for name, value in numbers.items()]
        return Actuator(self._core.with_assignments(words), self._effects)

    @property
    def name(self) -> str:
        """For people; errors about it name its file."""
        return self._core.name

    @property
    def is_design(self) -> bool:
        """Whether it has dimensions; otherwise it is a lumped model, which has a motion and neither heat nor mass."""
        return self._core.is_design

    def to_dict(self) -> dict[str, Any]:
        """Its file's content.

        >>> import coilwright as cw
        >>> cw.Actuator.prototype().to_dict()["format"]
        'actuator/1'
        """
        content: dict[str, Any] = json.loads(self._core.text)
        return content

    def save(self, path: Path) -> None:
        """Writes its file, which the program reads.

        >>> import tempfile, coilwright as cw
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     cw.Actuator.prototype().save(f"{folder}/finger.json")
        ...     cw.Actuator.load(f"{folder}/finger.json") == cw.Actuator.prototype()
        True
        """
        pathlib.Path(path).write_text(self._core.text, encoding="utf-8")

    def __getitem__(self, key: str) -> Any:
        return self.to_dict()[key]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Actuator) and self.to_dict() == other.to_dict()

    def __hash__(self) -> int:
        return hash(json.dumps(self.to_dict(), sort_keys=True))

    def __repr__(self) -> str:
        return f"<coilwright.Actuator {self.name!r}, {'a design' if self.is_design else 'a lumped model'}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return Actuator._parse, (self._core.text, self._core.origin, self._effects)
