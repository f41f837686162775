"""Numbers with their proof, and tables of them."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from html import escape
from typing import TYPE_CHECKING, Any, Union

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    import pandas

Index = Union[int, Fraction, "tuple[int, ...]"]


@dataclass(frozen=True)
class Number:
    """A real number that is proved.

    Attributes
    ----------
    value : decimal.Decimal
        Correctly rounded to the digits that were asked for.
    radius : decimal.Decimal
        An upper bound of ``|true number - value|``; 0 if `value` is the number itself.
    exact : fractions.Fraction or None
        The number as a fraction, where it is known to be rational.

    Notes
    -----
    `float` of it is the double nearest to `value`, which with 17 digits or more is mostly that of the number.
    """

    value: Decimal
    radius: Decimal
    exact: Fraction | None = None

    @property
    def enclosure(self) -> tuple[Decimal, Decimal]:
        """The midpoint and the radius of an interval that holds the true number."""
        return self.value, self.radius

    def __float__(self) -> float:
        return float(self.value)

    def __str__(self) -> str:
        fraction = "" if self.exact is None else f"  = {fraction_text(self.exact)}"
        return f"{decimal_text(self.value)}  +- {radius_text(self.radius)}{fraction}"


#: Beyond any use, and few enough that memory suffices.
MOST_DIGITS = 10_000


def checked_digits(digits: int) -> int:
    """The number of digits, if it is within the bounds."""
    if not 1 <= digits <= MOST_DIGITS:
        raise ValueError(f"digits is {digits}, but must be from 1 to {MOST_DIGITS}")
    return digits


def decimal_text(value: Decimal) -> str:
    """The decimal as the program prints it: with a point from 1e-5 on, below with an exponent."""
    if value == 0:
        return "0"
    return f"{value:f}" if -6 < value.adjusted() < 15 else str(value).replace("E", "e")


def radius_text(radius: Decimal) -> str:
    """A bound, of one digit."""
    return f"{radius:.0e}" if radius else "0"


def made_number(parts: tuple[str, str, str | None]) -> Number:
    """The number of the texts that the compiled part returns."""
    value, radius, exact = parts
    return Number(Decimal(value), Decimal(radius), None if exact is None else made_fraction(exact))


def made_fraction(text: str) -> Fraction:
    """The fraction of "p/q" or "p". By way of Decimal, for int() refuses texts of more than 4300 digits."""
    numerator, _, denominator = text.partition("/")
    return Fraction(int(Decimal(numerator)), int(Decimal(denominator or 1)))


def fraction_text(fraction: Fraction) -> str:
    """The fraction as a text of any length, for which str() has the same bound."""
    numerator = str(Decimal(fraction.numerator))
    return numerator if fraction.denominator == 1 else f"{numerator}/{Decimal(fraction.denominator)}"


def made_index(index: int | str | tuple[int, ...]) -> Index:
    """A dyadic point comes as a text."""
    return Fraction(index) if isinstance(index, str) else index


class NumberTable(Mapping[Index, Number]):
    """Numbers by their index: an int, a Fraction (of dyadic points), or a tuple of ints.

    It is a mapping in the order of the indices. Numbers outside the support are 0 and are not in it.

    Attributes
    ----------
    name : str
        What the numbers are, such as ``"mu"`` or ``"int(phi', phi)"``.
    filter : str
        The canonical name of the filter.
    """

    def __init__(self, name: str, filter: str, entries: Iterable[tuple[Index, Number]]) -> None:
        self.name = name
        self.filter = filter
        self._numbers = dict(entries)

    def __getitem__(self, index: Index) -> Number:
        return self._numbers[index]

    def __iter__(self) -> Iterator[Index]:
        return iter(self._numbers)

    def __len__(self) -> int:
        return len(self._numbers)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, NumberTable):
            return NotImplemented
        return (self.name, self.filter, self._numbers) == (other.name, other.filter, other._numbers)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"<NumberTable {self.name} of {self.filter}, {len(self)} numbers>"

    def __str__(self) -> str:
        width = max((len(str(index)) for index in self), default=0)
        lines = [f"{str(index):>{width}}   {number}" for index, number in self.items()]
        return "\n".join([f"{self.name} of {self.filter}", *lines])

    def floats(self) -> npt.NDArray[np.float64]:
        """The values as float64, in order.

        Returns
        -------
        numpy.ndarray
            One dimension, as long as the table.
        """
        return np.array([float(number.value) for number in self.values()])

    def to_frame(self) -> "pandas.DataFrame":
        """The table as a pandas frame.

        Returns
        -------
        pandas.DataFrame
            Columns value, radius (Decimal), exact (Fraction or None) and float; one row an index.
        """
        import pandas

        rows = [(n.value, n.radius, n.exact, float(n.value)) for n in self.values()]
        index = pandas.Index(list(self), name="index", tupleize_cols=False)
        return pandas.DataFrame(rows, index=index, columns=["value", "radius", "exact", "float"])

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th>{escape(str(index))}</th><td><code>{decimal_text(number.value)}</code></td>"
            f"<td>&plusmn; {radius_text(number.radius)}</td>"
            f"<td>{'' if number.exact is None else fraction_text(number.exact)}</td></tr>"
            for index, number in self.items()
        )
        return (
            f"<table><caption>{escape(self.name)} of {escape(self.filter)}</caption><thead><tr>"
            "<th>index</th><th>value</th><th>radius</th><th>exact</th></tr></thead>"
            f"<tbody>{rows}</tbody></table>"
        )


def made_table(name: str, filter: str, entries: Iterable[tuple[Any, Any]]) -> NumberTable:
    """The table of indices and texts that the compiled part returns."""
    return NumberTable(name, filter, ((made_index(i), made_number(n)) for i, n in entries))
