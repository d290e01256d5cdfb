"""From records to the effect that a model lacks, and back: diagnoses, plans, synthetic records."""

from __future__ import annotations

import copy
import json
import os
import pathlib
import tempfile
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple, Optional, Union

from coilwright import _core
from coilwright._actuator import Actuator, Path
from coilwright._arrays import json_text, plain
from coilwright._effects import Effect, catalogue
from coilwright._errors import InputError, core_of, number, whole
from coilwright._results import Answer
from coilwright._tables import Columns, Table, csv_text

Hidden = Mapping[str, Mapping[str, float]]


class Records(Mapping[str, Table]):
    """Records of one actuator in memory, immutable: what the folder of a data set holds (docs/formats-dataset.md), a table
    a run.

    Make it of arrays by `of`, or by `twin`.

    >>> import coilwright as cw
    >>> records = cw.twin(cw.Actuator.prototype(), "configs/experiments/paper.json")
    >>> list(records)[0], records[list(records)[0]].columns[:2]
    ('step_0.35A.csv', ['time_s', 'current_A'])
    """

    def __init__(self, dataset: Mapping[str, Any], files: Mapping[str, str]) -> None:
        self._dataset: dict[str, Any] = plain(dataset, "records", "")
        self._files = dict(files)
        _require_file_names(self._files)

    @property
    def dataset(self) -> dict[str, Any]:
        """The content of dataset.json."""
        return copy.deepcopy(self._dataset)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Records) and (self._dataset, self._files) == (other._dataset, other._files)

    def __hash__(self) -> int:
        return hash(tuple(self._files.items()))

    def __repr__(self) -> str:
        return f"<coilwright.Records {self._dataset.get('name', '')!r}: {', '.join(self._files)}>"

    @classmethod
    def of(cls, runs: Mapping[str, Columns], *, name: str = "records",
           about: Mapping[str, Mapping[str, Any]] = {}, **keys: Any) -> Records:
        """Records of arrays: for each run its columns by name, each with its unit at its end ("time_s", "current_A",
        "bending_angle_deg"); a time may be of any kind (docs/python.md), and of what is measured a sample that is masked
        or NaN is absent. A run is called by a plain file name, with or without .csv. about: of a run, the keys of an element of "runs" ({"kind": .., "role": .., "sigma": ..});
        a motion to fit is meant where nothing is said. keys: those of the data set ("tolerances", "calibrate", ..).

        >>> import numpy as np, coilwright as cw
        >>> time = np.arange(0, 1, 0.01)
        >>> records = cw.Records.of({"push": {"time_s": time, "current_A": time, "bending_angle_deg": 30 * time}},
        ...                         about={"push": {"sigma": 0.3}})
        >>> records.dataset["runs"][0]
        {'file': 'push.csv', 'kind': 'transient', 'role': 'fit', 'drive': 'current', 'sigma': 0.3}
        """
        unknown = set(about) - set(runs)
        if unknown:
            raise ValueError(f"about: has no run called {', '.join(sorted(unknown))}")
        _require_file_names(runs)
        entries = [{**_usual_entry(run, columns), **about.get(run, {})} for run, columns in runs.items()]
        _require_file_names([entry["file"] for entry in entries])
        files = {entry["file"]: csv_text(columns, entry["file"], ("time", entry.get("drive", "time")))
                 for entry, columns in zip(entries, runs.values())}
        return cls({"format": "measured-data/1", "name": name, **keys, "runs": entries}, files)

    @classmethod
    def load(cls, folder: Path) -> Records:
        """The records of a folder, or of the dataset.json in it: all files that its runs name. Raises InputError for files
        that do not lie in that folder.

        >>> import coilwright as cw, tempfile
        >>> records = cw.twin(cw.Actuator.prototype(), "configs/experiments/paper.json")
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     records.save(folder)
        ...     cw.Records.load(folder) == records
        True
        """
        place = pathlib.Path(folder)
        if place.name != "dataset.json":
            place = place / "dataset.json"
        try:
            dataset = json.loads(_core.read_text(str(place)))
            runs = dataset["runs"]
            names = [name for run in runs for name in (run["file"], _file_of(run.get("input_file"))) if name is not None]
        except (json.JSONDecodeError, KeyError, TypeError, AttributeError) as fault:
            raise InputError(f"{place}: is no data set ({fault!r})", str(place), "", "is no data set", repr(fault)) from None
        _require_file_names(dict.fromkeys(names))
        return cls(dataset, {name: (place.parent / name).read_text(**_BYTES) for name in dict.fromkeys(names)})

    def __iter__(self) -> Iterator[str]:
        return iter(self._files)

    def __len__(self) -> int:
        return len(self._files)

    def __getitem__(self, file: str) -> Table:
        return Table(self._files[file])

    def save(self, folder: Path, actuator: Optional[Actuator] = None) -> None:
        """Writes the folder of a data set, which the program reads; with the declared actuator, if one is given."""
        place = pathlib.Path(folder)
        place.mkdir(parents=True, exist_ok=True)
        for name, text in self._files.items():
            (place / name).write_text(text, **_BYTES)
        dataset = self.dataset
        if actuator is not None:
            actuator.save(place / "actuator.json")
            dataset = {**dataset, "actuator": "actuator.json"}
        (place / "dataset.json").write_text(json.dumps(dataset, indent=2) + "\n", encoding="utf-8")


# Whatever a foreign file is written in comes out as it went in.
_BYTES: dict[str, Any] = {"encoding": "utf-8", "errors": "surrogateescape"}


def _file_of(input: Any) -> Optional[str]:
    name: Optional[str] = input["file"] if isinstance(input, Mapping) else input
    return name


def _require_file_names(names: Iterable[str]) -> None:
    """Raises InputError for names that cannot be those of the records in a folder beside dataset.json."""
    ours = ["dataset.json", "actuator.json"]
    all = [*ours, *(str(name) for name in names)]
    fault = _core.fault_of_file_names(all)
    if fault is not None:
        index, rule = fault
        raise InputError(f"records: a run {rule}; got {all[index]!r}", "records", "", rule, all[index])


def _usual_entry(run: str, columns: Columns) -> dict[str, Any]:
    entry = {"file": run if run.endswith(".csv") else run + ".csv", "kind": "transient", "role": "fit"}
    for drive in ("current", "voltage", "torque"):
        if any(column.startswith(drive) for column in columns):
            return {**entry, "drive": drive}
    return entry


class Estimate(NamedTuple):
    """A fitted number with its 95 % interval, in the unit of its key; None where the records set no bound.

    >>> import coilwright as cw
    >>> cw.Estimate("torque_Nmm", 0.6, 0.5, 0.7).value
    0.6
    """

    key: str
    value: float
    lower: Optional[float]
    upper: Optional[float]


class Diagnosis(Answer):
    """What the records say of the model: the verdict, the effects that it lacks, and how sure that is. Made by
    `diagnose`. Everything else is in `to_dict()`, whose keys are in docs/formats-diagnosis.md.

    >>> import coilwright as cw
    >>> cw.Diagnosis.effects.__doc__ is not None
    True
    """

    def __init__(self, core: _core.Diagnosed, effects: Sequence[Effect]) -> None:
        self._core = core
        self._effects = tuple(effects)
        self._content: dict[str, Any] = json.loads(core.json)

    @property
    def verdict(self) -> str:
        """"explained", "no_missing_effect", "declared_numbers_off", "partly_explained" or "unexplained"."""
        return str(self._content["verdict"])

    @property
    def effects(self) -> dict[str, list[Estimate]]:
        """The effects that the declared model lacks, each with its fitted numbers."""
        return {each["id"]: [Estimate(key, row["value"], *row["ci95"]) for key, row in each["parameters"].items()]
                for each in self._content["effects"]}

    @property
    def odds(self) -> dict[str, float]:
        """The probability that each effect is there, given that the truth is among the hypotheses; the most probable
        first."""
        return dict(self._content["odds"]["effects"])

    @property
    def errors(self) -> dict[str, Any]:
        """Errors on the runs that no fit has seen, as "declared", fitted anew ("before") and with effects ("after")."""
        return copy.deepcopy(dict(self._content["error"]["validate"]))

    @property
    def actuator(self) -> Actuator:
        """The corrected actuator: recalibrated, with the effects that were added."""
        return Actuator._parse(self._core.actuator, "actuator.json", self._effects)

    def residuals(self) -> Table:
        """Every sample as measured, and as the declared and the corrected model predict it: residuals.csv."""
        return Table(self._core.residuals())

    @property
    def next_experiment(self) -> Optional[dict[str, Any]]:
        """The experiment that would separate what these records cannot; None where there is none."""
        return json.loads(self._core.next_experiment) if self._core.next_experiment else None

    def to_dict(self) -> dict[str, Any]:
        """The content of diagnosis.json."""
        return copy.deepcopy(self._content)

    def _made_with(self) -> tuple[Any, ...]:
        return (self._effects,)

    def write(self, folder: Path) -> None:
        """Writes the files of the program into a folder, all or none: the same bytes, but for where records of memory
        are said to be from. Raises OutputError."""
        self._core.write(os.fspath(folder))

    def plot(self, run: str, axes: Any = None, **keywords: Any) -> Any:
        """A run as measured, declared and corrected, where matplotlib is installed; gives the axes. keywords: of
        its `plot`."""
        from coilwright import _plots
        return _plots.residuals(self, run, axes, keywords)


def diagnose(records: Union[Records, Path], actuator: Union[Actuator, Path, None] = None, *, seed: int = 1,
             threads: int = 0, as_written: bool = False, effects: Sequence[Effect] = (),
             progress: Optional[Callable[[str], object]] = None) -> Diagnosis:
    """Finds the effects that a declared model lacks to explain records.

    records: in memory, or the folder of a data set. actuator: the declared one; without it the one that the folder
    names. seed: of the additional starts of fits. threads: fits at once; 0: one a core; the answer does not depend on
    it. as_written: fit records also where another unit or sign makes far more of them. effects: written in Python,
    compared with those of Coilwright; Records.of(.., effect_probabilities={id: 0.2}) says how probable one is beforehand. progress: called with a line at a time. It takes seconds to minutes; Ctrl-C ends
    it with KeyboardInterrupt at the next line of progress. Raises InputError for records that cannot be used.

    >>> import coilwright as cw
    >>> try:
    ...     cw.diagnose("configs")
    ... except cw.InputError as error:
    ...     print(error)
    configs: has no dataset.json: coilwright init dataset --from RECORDS makes one of your records
    """
    if isinstance(records, Records) and actuator is None:
        raise ValueError("actuator: must be given with records in memory, which lie in no folder to name one from")
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work) / "records"
        if isinstance(records, Records):
            records.save(folder)
        else:
            folder = pathlib.Path(records)
        declared: Optional[Path] = actuator if not isinstance(actuator, Actuator) else None
        if isinstance(actuator, Actuator):
            declared = pathlib.Path(work) / "actuator.json"
            actuator.save(declared)
        try:
            core = _core.diagnose(str(folder), None if declared is None else os.fspath(declared), whole("seed", seed) or 0,
                                  whole("threads", threads) or 0,
                                  as_written, catalogue(effects), progress)
        except InputError as error:
            raise _without(work, error) from None
    diagnosis = Diagnosis(core, effects)
    for each in diagnosis.to_dict()["warnings"]:
        warnings.warn(f"{each['run']}: {each['text']}", stacklevel=2)
    return diagnosis


def require_no_slip(records: Records, actuator: Actuator) -> None:
    """Refuses records as `diagnose` does that were written in another unit or with another sign than they say."""
    with tempfile.TemporaryDirectory() as work:
        records.save(work, actuator)
        try:
            _core.require_no_slip(work)
        except InputError as error:
            raise _without(work, error) from None


def _without(work: str, error: InputError) -> InputError:
    """The error without the folder that only this module knows, and with the keyword in place of the option."""
    return InputError(*(str(each).replace(work + "/", "").replace("--as-written", "as_written=True")
                        for each in error.args))


class Plan(NamedTuple):
    """What an experiment could show. Made by `plan`.

    >>> import coilwright as cw
    >>> cw.Plan._fields
    ('content', 'text')
    """

    content: dict[str, Any]
    """The keys of docs/how_to/plan_experiment.md."""
    text: str
    """What the program prints."""


def plan(experiment: Union[Mapping[str, Any], Path], actuator: Actuator, *,
         calibrate: Sequence[str] = ("joint_stiffness", "joint_damping"), exact: bool = False,
         noise: Mapping[str, float] = {}, seed: int = 1, threads: int = 0) -> Plan:
    """What an experiment could show of an actuator, before anything is recorded: the smallest strength of each effect,
    effects that look alike, the run to add. Raises InputError.

    experiment: a file of docs/formats-experiment.md, or its content. noise: of instruments, over what it says:
    {"angle_deg": 0.3}. exact: take every declared number as exact.

    >>> import coilwright as cw
    >>> try:
    ...     cw.plan({"format": "experiment/1"}, cw.Actuator.prototype())
    ... except cw.InputError as error:
    ...     error.file
    'experiment'
    """
    return Plan(*_core.plan(_planned(experiment, noise), core_of(actuator, Actuator), list(calibrate), exact,
                            whole("seed", seed) or 0, whole("threads", threads) or 0))


def twin(actuator: Actuator, experiment: Union[Mapping[str, Any], Path], hidden: Hidden = {}, *,
         noise: Mapping[str, float] = {}, seed: int = 1, effects: Sequence[Effect] = ()) -> Records:
    """Synthetic records of an actuator that has effects which it does not declare.

    hidden: their ids with their numbers: {"dry_friction": {"torque_Nmm": 0.6}}. effects: those written in Python.
    Otherwise as `plan`. The same arguments give the same bytes as the program's.

    >>> import coilwright as cw
    >>> finger = cw.Actuator.prototype()
    >>> len(cw.twin(finger, "configs/experiments/paper.json", {"dry_friction": {"torque_Nmm": 0.6}}, seed=7)) > 3
    True
    """
    words = [f"{id}:{','.join(f'{key}={number(key, value)!r}' for key, value in numbers.items())}".rstrip(":")
             for id, numbers in hidden.items()]
    return Records(*_core.twin(core_of(actuator, Actuator), _planned(experiment, noise), words, whole("seed", seed) or 0,
                               catalogue(effects)))


def _planned(experiment: Union[Mapping[str, Any], Path], noise: Mapping[str, float]) -> _core.Planned:
    words = [f"{name}={number(name, value)!r}" for name, value in noise.items()]
    if isinstance(experiment, Mapping):
        return _core.Planned(json_text(experiment, "experiment"), "experiment", words)
    origin = os.fspath(experiment)
    return _core.Planned(_core.read_text(origin), origin, words)


def report(folder: Path, file: Optional[Path] = None) -> pathlib.Path:
    """Writes the page of a folder of results, as `coilwright report` does; without `file` as report.html in it. Gives
    its path. Raises InputError where the folder has no results, or this build has nothing to draw with.

    >>> import coilwright as cw
    >>> try:
    ...     cw.report("docs")
    ... except cw.InputError as error:
    ...     error.file
    'docs'
    """
    path = pathlib.Path(folder) / "report.html" if file is None else pathlib.Path(file)
    _core.report(os.fspath(folder), os.fspath(path))
    return path
