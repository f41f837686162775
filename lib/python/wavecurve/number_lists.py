"""What are these numbers?"""
from __future__ import annotations

from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from . import _native
from .tables import TableLike, is_frame, is_path, printed

__all__ = ["IdentifiedList", "Match", "identify"]


@dataclass(frozen=True)
class Match:
    """A column that a list of numbers is.

    Attributes
    ----------
    filter, quantity : str
    reversed, negated, alternating : bool
        How the list departs from the library's order and sign.
    scale : str
        The factor, such as ``"sqrt2"``.
    shift : int
    in_order : bool
        Whether the numbers stand in the column's order.
    digits : float
        Right in the worst of the matched.
    matched, of : int
        Numbers that agree, and all.
    known_as : str
        The package that prints such a column.
    """

    filter: str
    quantity: str
    reversed: bool
    negated: bool
    alternating: bool
    scale: str
    shift: int
    in_order: bool
    digits: float
    matched: int
    of: int
    known_as: str

    def __str__(self) -> str:
        words = [word for word, holds in (("in another order", not self.in_order), ("reversed", self.reversed),
                                          ("negated", self.negated), ("alternating", self.alternating),
                                          (f"shift {self.shift}", self.shift), (f"times {self.scale}", self.scale != "1"),
                                          (f"as {self.known_as}", self.known_as)) if holds]
        departs = "".join(f", {word}" for word in words)
        return f"{self.filter} {self.quantity}{departs}: {self.matched} of {self.of} numbers, {self.digits:.1f} digits"


@dataclass(frozen=True)
class IdentifiedList:
    """A list of numbers and what it is.

    Attributes
    ----------
    name : str
        The variable or heading, if there is one.
    numbers : int
        How many there are.
    matches : list of Match
        The best first; empty if no known column fits.
    nearest : list of (filter, quantity, distance)
        The runners-up among the other filters.
    """

    name: str
    numbers: int
    matches: list[Match]
    nearest: list[tuple[str, str, float]]

    def __repr__(self) -> str:
        best = str(self.matches[0]) if self.matches else "no known column"
        return f"<IdentifiedList {self.name or 'unnamed'}: {best}>"

    def _repr_html_(self) -> str:
        matches = "".join(f"<li>{escape(str(match))}</li>" for match in self.matches[:5]) or "<li>no known column</li>"
        near = ", ".join(f"{escape(f)} {escape(q)} (off by {d:.2g})" for f, q, d in self.nearest)
        return f"<p><strong>{escape(self.name or 'list')}</strong> ({self.numbers} numbers)</p><ul>{matches}</ul><p>Nearest others: {near}</p>"


def identify(numbers: TableLike) -> list[IdentifiedList]:
    """Find the filter and quantity that lists of numbers show.

    Parameters
    ----------
    numbers : path, pandas.DataFrame, list, numpy.ndarray, or text
        A file in nearly any form; a frame, each column a list; numbers, of two dimensions each column a list; or a text
        with line ends, such as a literal of C or MATLAB.

    Returns
    -------
    list of IdentifiedList
        One a list, in order.

    Raises
    ------
    ValueError
        If there is no number, or there are too many.
    OSError
        If a file cannot be read.

    Examples
    --------
    >>> import wavecurve
    >>> wavecurve.identify([0.4829629131445341, 0.8365163037378077, 0.2241438680420134, -0.1294095225512603])
    [<IdentifiedList unnamed: db2 h, as PyWavelets rec_lo, MATLAB LoR: 4 of 4 numbers, 15.6 digits>]
    """
    found = _native.identify_text(list_text(numbers))
    return [
        IdentifiedList(entry["name"], entry["numbers"], [Match(**match) for match in entry["matches"]], entry["nearest"])
        for entry in found
    ]


#: More than a file of lists that anyone would read has.
LARGEST_FILE = 16 << 20


def file_bytes(path: Path) -> bytes:
    """What a file holds; of a device that has no end, no more than the bound."""
    with path.open("rb") as file:
        content = file.read(LARGEST_FILE + 1)
    if len(content) > LARGEST_FILE:
        raise ValueError(f"{path} has more than {LARGEST_FILE >> 20} MiB")
    return content


def list_text(numbers: TableLike) -> str | bytes:
    """The numbers as a text that the library reads."""
    if isinstance(numbers, str) and "\n" in numbers:
        return numbers
    if is_path(numbers):
        return file_bytes(Path(numbers))  # type: ignore[arg-type]
    if is_frame(numbers):
        frame: Any = numbers
        columns = [(str(name), list(frame[name])) for name in frame.columns]
    else:
        array: Any = np.asarray(numbers, dtype=object)
        columns = [("", list(column)) for column in (array.T if array.ndim == 2 else [np.ravel(array)])]
    lines = []
    for name, column in columns:
        values = ", ".join(printed(value) for value in column)
        lines.append(f"{name} = [{values}]" if name.isidentifier() else f"[{values}]")
    return "\n".join(lines) + "\n"
