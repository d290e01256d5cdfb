"""Tables: from columns of arrays to the text that the program reads, and back."""

from __future__ import annotations

import csv
import html
import importlib
import io
import operator
from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from coilwright._arrays import column
from coilwright._errors import InputError

Columns = Mapping[str, ArrayLike]
"""Columns by name, as a dict of arrays or a DataFrame has them; names end in their unit."""
Value = Union[float, str, None]
_SHOWN = 20


def csv_text(columns: Columns, file: str, whole: tuple[str, ...]) -> str:
    """The columns as CSV: with every digit, and an empty field where a number is absent. whole: what the names of columns
    begin with in which none may be. Raises InputError of the file, ValueError for columns that differ in length."""
    try:
        arrays = [column(name, columns[name], whole=name.startswith(whole)).tolist() for name in columns]
    except InputError as error:
        raise InputError(f"{file}: {error}", file, error.file, error.rule, error.value) from None
    if len({len(each) for each in arrays}) > 1:
        raise ValueError("columns must have one length; got " +
                         ", ".join(f"{name}: {len(each)}" for name, each in zip(columns, arrays)))
    out = io.StringIO()
    lines = csv.writer(out, lineterminator="\n")
    lines.writerow(columns)
    out.writelines(",".join("" if value != value else repr(value) for value in row) + "\n" for row in zip(*arrays))
    return out.getvalue()


class Table:
    """A table of the program's, row by row or column by column.

    >>> import coilwright as cw
    >>> table = cw.sweep(cw.Study.load("configs/studies/configurations.json"), sample=3).table()
    >>> len(table), table[0]["status"] in ("ok", "infeasible", "failed")
    (3, True)
    >>> table["mass_g"].shape, len(table[1:]), len(table[table["mass_g"] > 0])
    ((3,), 2, 3)
    """

    def __init__(self, text: str) -> None:
        rows = list(csv.reader(io.StringIO(text)))
        self._text = text
        self._names = rows[0]
        self._rows = rows[1:]

    @property
    def columns(self) -> list[str]:
        """The names of the columns."""
        return list(self._names)

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, key: Any) -> Any:
        """A row as a dict; by a slice, places or a mask a table of those rows; by a name a column as an array: of numbers
        (nan where there is none) or of texts."""
        if isinstance(key, str):
            place = place_of(key, self._names)
            return _column([row[place] for row in self._rows])
        places: Any = key if isinstance(key, slice) else np.asarray(key, dtype=None if np.size(key) else int)
        if not isinstance(key, slice) and places.ndim == 0:
            return {name: _value(field) for name, field in zip(self._names, self._rows[operator.index(key)])}
        return self._of(np.arange(len(self))[places].tolist())

    def _of(self, rows: list[int]) -> Table:
        out = io.StringIO()
        csv.writer(out, lineterminator="\n").writerows([self._names, *(self._rows[i] for i in rows)])
        return Table(out.getvalue())

    def __iter__(self) -> Iterator[dict[str, Value]]:
        return (self[i] for i in range(len(self)))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Table) and (self._names, self._rows) == (other._names, other._rows)

    def __hash__(self) -> int:
        return hash(self._text)

    def to_frame(self) -> Any:
        """As a pandas DataFrame, where pandas is installed."""
        return importlib.import_module("pandas").DataFrame({name: self[name] for name in self._names})

    def __repr__(self) -> str:
        return f"<coilwright.Table of {len(self)} rows: {', '.join(self._names)}>"

    def _repr_html_(self) -> str:
        """The first and the last rows, as notebooks show them."""
        def line(fields: Iterable[str], tag: str) -> str:
            return "<tr>" + "".join(f"<{tag}>{html.escape(field)}</{tag}>" for field in fields) + "</tr>"

        shown = [line([str(i), *map(_short, row)], "td") for i, row in enumerate(self._rows)]
        if len(shown) > _SHOWN:
            shown[_SHOWN // 2:-_SHOWN // 2] = [line(["\u22ee"] * (1 + len(self._names)), "td")]
        return (f"<table><caption>{len(self)} rows</caption><thead>{line(['', *self._names], 'th')}</thead>"
                f"<tbody>{''.join(shown)}</tbody></table>")

    @property
    def text(self) -> str:
        """As the program writes it: CSV."""
        return self._text


def _short(field: str) -> str:
    value = _value(field)
    return f"{value:.6g}" if isinstance(value, float) else field


def place_of(column: str, columns: list[str]) -> int:
    """Its place among columns. Raises KeyError that names them."""
    if column not in columns:
        raise KeyError(f"{column}: is none of the columns {', '.join(columns)}")
    return columns.index(column)


def _value(field: str) -> Value:
    try:
        return float(field)
    except ValueError:
        return field or None


def _column(fields: list[str]) -> NDArray[Any]:
    try:
        return np.array([float(field) if field else np.nan for field in fields])
    except ValueError:
        return np.array(fields, dtype=object)
