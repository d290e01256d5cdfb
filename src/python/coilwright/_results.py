"""Searches over a study, and what they find."""

from __future__ import annotations

import copy
import html
import os
import pathlib
import tempfile
from collections.abc import Callable, Iterator, Sequence
from typing import Any, NamedTuple, Optional

from coilwright import _core
from coilwright._actuator import Actuator, Path
from coilwright._effects import Effect
from coilwright._errors import OutputError, core_of, whole
from coilwright._study import Study
from coilwright._tables import Table


class Progress(NamedTuple):
    """How far a search is.

    >>> import coilwright as cw
    >>> cw.Progress._fields
    ('evaluations', 'max_evaluations', 'feasible', 'front_size')
    """

    evaluations: int
    """Designs evaluated so far."""
    max_evaluations: int
    """Designs allowed."""
    feasible: int
    """Of those evaluated, how many keep every limit."""
    front_size: int
    """Designs on the front; of one objective 1 or 0."""


Listener = Callable[[Progress], object]


def _words(seed: Optional[int], max_evaluations: Optional[int], algorithm: Optional[str], threads: int,
           progress: Optional[Listener]) -> dict[str, Any]:
    def told(*numbers: int) -> None:
        assert progress is not None
        progress(Progress(*numbers))

    numbers = dict(seed=seed, max_evaluations=max_evaluations, threads=threads)
    return {**{name: whole(name, value) for name, value in numbers.items()}, "algorithm": algorithm,
            "progress": None if progress is None else told}


class Kept:
    """What a core of C++ gave, in its place: what an answer is pickled as."""

    def __init__(self, values: dict[str, Any], made: dict[str, Any], files: dict[str, bytes],
                 designs: list[_core.Actuator]) -> None:
        self.__dict__.update(values)
        self._made = made
        self._files = files
        self._designs = [Actuator(each) for each in designs]

    @classmethod
    def of(cls, core: Any) -> Kept:
        """All that a core tells without arguments, and the files that it writes."""
        if isinstance(core, Kept):
            return core
        kind = type(core)
        names = [name for name in dir(kind) if not name.startswith("_") and name != "write"]
        values = {name: getattr(core, name) for name in names if isinstance(getattr(kind, name), property)}
        made = {name: getattr(core, name)() for name in names if name not in ("actuator", *values)}
        designs = [core.actuator(i) for i in range(len(core))] if hasattr(kind, "__len__") else []
        with tempfile.TemporaryDirectory() as work:
            folder = pathlib.Path(work) / "files"
            core.write(str(folder))
            files = {path.name: path.read_bytes() for path in sorted(folder.iterdir())}
        return cls(values, made, files, designs)

    def __getattr__(self, name: str) -> Any:
        made = self.__dict__.get("_made", {})
        if name not in made:
            raise AttributeError(name)
        return lambda: copy.deepcopy(made[name])

    def __len__(self) -> int:
        return len(self._designs)

    def actuator(self, index: int) -> Any:
        return self._designs[index]._core

    def write(self, folder: str) -> None:
        place = pathlib.Path(folder)
        try:
            place.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryDirectory(dir=place) as work:  # all or none
                for name, content in self._files.items():
                    (pathlib.Path(work) / name).write_bytes(content)
                for name in self._files:
                    os.replace(pathlib.Path(work) / name, place / name)
        except OSError as error:
            raise OutputError(f"{folder}: cannot be written: {error.strerror}") from None


class Answer:
    """What all answers can do."""

    _core: Any

    def to_dict(self) -> dict[str, Any]:
        """The content of result.json."""
        content: dict[str, Any] = self._core.to_dict()
        return content

    @property
    def text(self) -> str:
        """What the program prints."""
        return str(self._core.text)

    def write(self, folder: Path) -> None:
        """Writes the files of the program into a folder, all or none: the same bytes, without archive and provenance.
        Raises OutputError."""
        self._core.write(os.fspath(folder))

    def __str__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return str(self._core.html)

    def __repr__(self) -> str:
        return f"<coilwright.{type(self).__name__}: {' '.join(self.text.split(chr(10), 1)[0].split())}>"

    def _made_with(self) -> tuple[Any, ...]:
        """What its class takes behind the core."""
        return ()

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (Kept.of(self._core), *self._made_with())


class _Designs(Answer):
    """Designs of an answer as actuators, by index."""

    def __len__(self) -> int:
        return len(self._core)

    def __getitem__(self, index: int) -> Actuator:
        if not -len(self) <= index < len(self):
            raise IndexError(f"design {index} of {len(self)}")
        return Actuator(self._core.actuator(index % len(self)))

    def __iter__(self) -> Iterator[Actuator]:
        return (self[i] for i in range(len(self)))

    def table(self) -> Table:
        """A row a design, in their order: front.csv or designs.csv."""
        return Table(self._core.table())


class Sized(Answer):
    """What `size` found.

    >>> import coilwright as cw
    >>> study = cw.Study.load("configs/studies/fastest_finger.json", set={"/search/max_evaluations": 30})
    >>> found = cw.size(study, answer_only=True)
    >>> found.feasible, found.best.name
    (True, 'fastest_finger')
    >>> found.evaluations()["status"].shape
    (30,)
    """

    def __init__(self, core: _core.SizeAnswer, effects: Sequence[Effect]) -> None:
        self._core = core
        self._effects = tuple(effects)

    @property
    def feasible(self) -> bool:
        """Whether the design keeps every limit; otherwise it is the least infeasible one."""
        return bool(self._core.feasible)

    @property
    def best(self) -> Actuator:
        """The design found, with the operating point at which it was judged: `evaluate` needs no current."""
        text = self._core.best()
        if text is None:
            raise ValueError("the search ended before its first evaluation")
        return Actuator._parse(text, "actuator.json", self._effects)

    def evaluations(self) -> Table:
        """Every design that was evaluated: evaluations.csv."""
        return Table(self._core.evaluations())

    def _made_with(self) -> tuple[Any, ...]:
        return (self._effects,)


class Front(_Designs):
    """What `pareto` found: the designs that no other one beats, as actuators, by index.

    >>> import coilwright as cw
    >>> study = cw.Study.load("configs/studies/speed_against_grip.json")
    >>> front = cw.pareto(study, max_evaluations=60)
    >>> len(front) == len(front.table())
    True
    >>> front[0].is_design
    True
    """

    def __init__(self, core: _core.Front, objectives: list[str]) -> None:
        self._core = core
        self._objectives = list(objectives)

    def _made_with(self) -> tuple[Any, ...]:
        return (self._objectives,)

    def evaluations(self) -> Table:
        """Every design that was evaluated: evaluations.csv."""
        return Table(self._core.evaluations())

    def plot(self, axes: Any = None, **keywords: Any) -> Any:
        """The front in its first two objectives, where matplotlib is installed; gives the axes. keywords: of its `plot`."""
        from coilwright import _plots
        return _plots.table(self.table(), self._objectives[0], self._objectives[1], axes, keywords)


class Swept(_Designs):
    """What `sweep` found: every design as an actuator, by index; all of them in memory.

    >>> import coilwright as cw
    >>> swept = cw.sweep(cw.Study.load("configs/studies/fastest_finger.json"), sample=4)
    >>> len(swept), swept[3].is_design
    (4, True)
    """

    def __init__(self, core: _core.SweepAnswer) -> None:
        self._core = core

    def plot(self, x: str, y: str, axes: Any = None, **keywords: Any) -> Any:
        """Two columns of the table against each other, where matplotlib is installed; gives the axes. keywords: of its `plot`."""
        from coilwright import _plots
        return _plots.table(self.table(), x, y, axes, keywords)


def size(study: Study, *, seed: Optional[int] = None, max_evaluations: Optional[int] = None,
         algorithm: Optional[str] = None, threads: int = 0, answer_only: bool = False,
         progress: Optional[Listener] = None) -> Sized:
    """The best design of a study with one objective, what limits it, and what that rests on.

    seed, max_evaluations, algorithm: over what the study says. threads: designs evaluated at once; 0: one a core; the
    answer does not depend on it. answer_only: end with the search. progress: called with a Progress between rounds.
    Ctrl-C ends it with KeyboardInterrupt. Raises InputError for a study with another number of objectives.

    >>> import coilwright as cw
    >>> study = cw.Study.load("configs/studies/fastest_finger.json")
    >>> seen = []
    >>> found = cw.size(study, max_evaluations=30, answer_only=True, progress=seen.append)
    >>> seen[-1].evaluations
    30
    """
    words = _words(seed, max_evaluations, algorithm, threads, progress)
    return Sized(_core.size(core_of(study, Study), words, answer_only), study._effects)


def pareto(study: Study, *, seed: Optional[int] = None, max_evaluations: Optional[int] = None,
           algorithm: Optional[str] = None, threads: int = 0, progress: Optional[Listener] = None) -> Front:
    """The best trade-offs of a study with two or three objectives; as `size` otherwise.

    >>> import coilwright as cw
    >>> cw.pareto(cw.Study.load("configs/studies/speed_against_grip.json"), max_evaluations=30)[0].is_design
    True
    """
    core = _core.pareto(core_of(study, Study), _words(seed, max_evaluations, algorithm, threads, progress))
    return Front(core, study.objectives)


def sweep(study: Study, *, sample: int = 0, sampling: str = "latin_hypercube", seed: Optional[int] = None,
          threads: int = 0) -> Swept:
    """Every design of a grid or, with `sample`, so many from the whole range ("latin_hypercube" or "random").

    >>> import coilwright as cw
    >>> len(cw.sweep(cw.Study.load("configs/studies/fastest_finger.json"), sample=5, sampling="random"))
    5
    """
    if sampling not in ("latin_hypercube", "random"):
        raise ValueError(f"sampling: must be 'latin_hypercube' or 'random'; got {sampling!r}")
    words = _words(seed, None, None, threads, None)
    return Swept(_core.sweep(core_of(study, Study), words, whole("sample", sample) or 0, sampling == "latin_hypercube"))
