"""Are these numbers right?"""
from __future__ import annotations

import csv
import io
from collections.abc import Iterable
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from html import escape
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from . import _native
from .filters import FilterBank

if TYPE_CHECKING:
    import pandas

__all__ = ["CheckedColumn", "CheckedRow", "CheckedTable", "check"]

TableLike = Union[str, "PathLike[str]", "pandas.DataFrame", Iterable[Any]]

#: Background and text of the verdicts in a notebook, in light and dark legible.
COLOURS = {
    "certified": "#1b7a3d",
    "form": "#3c6e9f",
    "published-route": "#8a5a00",
    "misprint": "#a63d00",
    "agrees-to-digits": "#6b6b00",
    "discrepant": "#b00020",
    "undecided": "#5c5c5c",
}


@dataclass(frozen=True)
class CheckedRow:
    """One printed number beside the true one.

    Attributes
    ----------
    filter, quantity : str
    index : int or str
        A dyadic point and a pair are texts.
    printed, certified : str
        The print, and the true value correctly rounded.
    verdict : str
        certified, form, published-route, misprint, agrees-to-digits, discrepant or undecided.
    ulps : float
        |print - true value| in units of the print's last digit; not a number for a fraction.
    detail, route : str
        What is wrong, and the computation that yields the print.
    marked : list of (str, bool)
        The print in parts, and whether each departs from the true value.
    extra : list of str
        Fields of columns that are not the checker's.
    """

    filter: str
    quantity: str
    index: int | str
    printed: str
    verdict: str
    certified: str
    ulps: float
    detail: str
    route: str
    marked: list[tuple[str, bool]]
    extra: list[str]


@dataclass(frozen=True)
class CheckedColumn:
    """The rows of one filter and quantity.

    Attributes
    ----------
    convention : str
        How it departs from the library's order, sign and factor; empty if it does not.
    known_as : str
        The package that prints such a column.
    stated : bool
        Whether the table says the convention itself.
    solution : str
        What the taps are by their own equations, where they are another filter's.
    digits : int
        Decimals, or significant digits if `scientific`, of most of its prints.
    route : str
        The computation that explains it.
    matched, after_edit, of : int
        Entries that the route yields, those that need an edit, and all.
    credited : bool
        Whether a computation is credited; `chance` is then that of an unrelated one.
    """

    filter: str
    quantity: str
    convention: str
    known_as: str
    stated: bool
    solution: str
    digits: int
    scientific: bool
    route: str
    matched: int
    after_edit: int
    of: int
    credited: bool
    chance: float


@dataclass(frozen=True)
class CheckedTable:
    """What `check` found.

    Attributes
    ----------
    title : str
    is_right : bool
        Whether every number is certified, or right but for its form.
    rows : list of CheckedRow
    columns : list of CheckedColumn
    counts : dict
        How many rows have each verdict.
    extra_columns : list of str
        Names of what stands in `CheckedRow.extra`.
    """

    title: str
    is_right: bool
    rows: list[CheckedRow]
    columns: list[CheckedColumn]
    counts: dict[str, int]
    extra_columns: list[str] = field(default_factory=list)

    def __repr__(self) -> str:
        counts = ", ".join(f"{count} {verdict}" for verdict, count in self.counts.items())
        return f"<CheckedTable of {len(self.rows)} numbers: {counts}>"

    def __str__(self) -> str:
        lines = [f"{self.title or 'checked table'}: {len(self.rows)} numbers"]
        lines += [f"{count:6d} {verdict}" for verdict, count in self.counts.items()]
        for row in self.rows:
            if row.verdict != "certified":
                lines.append(f"{row.filter} {row.quantity}[{row.index}]: {row.printed}, true {row.certified}: {row.verdict}"
                             + (f" ({row.detail})" if row.detail else ""))
        return "\n".join(lines)

    def to_frame(self) -> "pandas.DataFrame":
        """The rows as a pandas frame.

        Returns
        -------
        pandas.DataFrame
            Columns filter, quantity, index, printed, verdict, certified, ulps, detail, route, and the extra ones.
        """
        import pandas

        names = ["filter", "quantity", "index", "printed", "verdict", "certified", "ulps", "detail", "route"]
        frame = pandas.DataFrame([[getattr(row, name) for name in names] for row in self.rows], columns=names)
        for i, name in enumerate(self.extra_columns):
            frame[name if name not in frame else f"{name} (table)"] = [row.extra[i] for row in self.rows]
        return frame

    def _repr_html_(self) -> str:
        badges = " ".join(f"{count} {badge(verdict)}" for verdict, count in self.counts.items())
        head = "".join(f"<th>{name}</th>" for name in ("filter", "quantity", "index", "printed", "certified", "distance",
                                                       "verdict", "detail"))
        rows = "".join(row_html(row) for row in self.rows)
        notes = "".join(
            f"<li>{escape(column.filter)} {escape(column.quantity)}: {escape(column.convention)}"
            + (f", as {escape(column.known_as)}" if column.known_as else "") + "</li>"
            for column in self.columns if column.convention
        )
        return (f"<p><strong>{escape(self.title or 'Checked table')}</strong> {badges}</p>"
                f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table><ul>{notes}</ul>")


def badge(verdict: str) -> str:
    """A verdict in its colour."""
    return (f'<span style="background:{COLOURS.get(verdict, "#5c5c5c")};color:#fff;border-radius:3px;'
            f'padding:0 4px">{escape(verdict)}</span>')


def row_html(row: CheckedRow) -> str:
    """A row, the digits that depart marked."""
    parts = "".join(
        (f'<mark style="background:#ffd54a;color:#000">{escape(text) or "&nbsp;"}</mark>' if departs else escape(text))
        for text, departs in row.marked
    )
    distance = "" if row.ulps != row.ulps else f"{row.ulps:.3g}"
    return (f"<tr><th>{escape(row.filter)}</th><td>{escape(row.quantity)}</td><td>{escape(str(row.index))}</td>"
            f"<td><code>{parts}</code></td><td><code>{escape(row.certified)}</code></td><td>{distance}</td>"
            f"<td>{badge(row.verdict)}</td><td>{escape(row.detail)}</td></tr>")


def is_path(table: object) -> bool:
    return isinstance(table, (str, PathLike))


def is_frame(table: object) -> bool:
    return hasattr(table, "columns") and hasattr(table, "itertuples")


def printed(number: Any) -> str:
    """A number as a print: of a float its shortest decimal, of all else every digit."""
    if isinstance(number, str):
        return number
    if isinstance(number, (float, np.floating)):
        return np.format_float_positional(number, trim="-") if 1e-5 <= abs(float(number)) < 1e16 else repr(float(number))
    if isinstance(number, (int, Decimal, Fraction, np.integer)):
        return str(number)
    raise TypeError(f"{number!r} is no number: a text, float, int, Decimal or Fraction is")


def column_text(table: Iterable[Any], filter: str, quantity: str, first_index: int, convention: str | None) -> str:
    """The numbers as a table with one column."""
    text = io.StringIO()
    if convention:
        text.write(f"# convention: {convention}\n")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["filter", "quantity", "index", "printed"])
    for index, number in enumerate(table, first_index):
        writer.writerow([filter, quantity, index, printed(number)])
    return text.getvalue()


def frame_text(
    frame: Any, filter: str | None, quantity: str | None, convention: str | None
) -> tuple[str, bool]:
    """A frame as a table, and whether its prints are doubles; what its columns do not say is said for all rows."""
    text = io.StringIO()
    for name, value in (("convention", convention), ("filter", filter), ("quantity", quantity)):
        if value:
            text.write(f"# {name}: {value}\n")
    names = [str(name) for name in frame.columns]
    with_index = "index" not in [name.lower() for name in names]
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow((["index"] if with_index else []) + names)
    for row in frame.itertuples(index=with_index, name=None):
        writer.writerow([cell if isinstance(cell, str) else frame_cell(cell) for cell in row])
    prints = [frame[name] for name in frame.columns if str(name).lower() in ("printed", "value")]
    return text.getvalue(), any(column.dtype == np.float64 for column in prints)


def frame_cell(cell: object) -> str:
    """A number of a frame, or what else stands there."""
    try:
        return printed(cell)
    except TypeError:
        return str(cell)


def check(
    table: TableLike,
    filter: str | FilterBank | None = None,
    quantity: str | None = None,
    *,
    first_index: int | None = None,
    convention: str | None = None,
) -> CheckedTable:
    """Hold every number of a table against its certified value.

    Parameters
    ----------
    table : path, pandas.DataFrame, list or numpy.ndarray
        A file as the command ``check`` reads it; a frame with the columns index and printed (or value), and filter and
        quantity unless they are given here (without a column index, the frame's own counts); or the numbers of one
        column: texts, Decimals and Fractions, of which every digit counts, or float64, which are right if no double is
        nearer to the true value.
    filter : str or FilterBank, optional
        Whose numbers they are.
    quantity : str, optional
        What they are, in the grammar of ``check``: ``"h"``, ``"mu"``, ``"int(phi'', phi)"``, ...
    first_index : int, optional
        The index of the first number of a list; by default 0, and of taps the filter's first index.
    convention : str, optional
        How all columns depart from the library's order, such as ``"reversed, from 0"``.

    Returns
    -------
    CheckedTable

    Raises
    ------
    ValueError
        For what is no such table, an unknown filter, an index out of range; the message has the line.
    OSError
        If a file cannot be read.

    Examples
    --------
    >>> import wavecurve
    >>> wavecurve.check([5.267857142857143, -3.3904761904761904], "db3", "mu")
    <CheckedTable of 2 numbers: 2 certified>
    """
    name = filter.name if isinstance(filter, FilterBank) else filter
    if is_path(table):
        found = _native.check_file(Path(table))  # type: ignore[arg-type]
    elif is_frame(table):
        text, are_doubles = frame_text(table, name, quantity, convention)
        found = _native.check_text(text, "frame", are_doubles)
    else:
        if name is None or quantity is None:
            raise ValueError("a list of numbers needs its filter and quantity; identify finds them")
        if first_index is None:
            first_index = default_first_index(name, quantity)
        numbers = list(np.ravel(table) if isinstance(table, np.ndarray) else table)  # type: ignore[arg-type]
        are_doubles = bool(numbers) and all(isinstance(number, float) for number in numbers)
        found = _native.check_text(column_text(numbers, name, quantity, first_index, convention), "list", are_doubles)
    rows = [CheckedRow(**row) for row in found["rows"]]
    columns = [CheckedColumn(**column) for column in found["columns"]]
    return CheckedTable(found["title"], found["is_right"], rows, columns, found["counts"], found["extra_columns"])


def default_first_index(filter: str, quantity: str) -> int:
    """Taps start where the filter does, all else at 0."""
    which = {"h": "synthesis_low", "g": "synthesis_high", "dual(h)": "analysis_low", "dual(g)": "analysis_high"}
    taps = which.get(quantity.split("*")[0].split("/")[0].strip(" -"))
    return FilterBank(filter)._one(taps).first_index if taps else 0
