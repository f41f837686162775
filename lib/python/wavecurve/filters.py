"""Filter banks, in the library's order and in that of PyWavelets."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from decimal import Decimal
from fractions import Fraction
from functools import lru_cache
from os import PathLike
from typing import NamedTuple, Union

import numpy as np
import numpy.typing as npt

from . import _native
from .numbers import NumberTable, checked_digits, made_table

FilterLike = Union["FilterBank", str, "PathLike[str]"]
Tap = Union[int, float, str, Decimal, Fraction]


class Taps(NamedTuple):
    """A filter ``h_n``, ``n = first_index, first_index + 1, ...``, in the library's own order."""

    first_index: int
    taps: npt.NDArray[np.float64]


class FilterBank(_native.NativeFilterBank):
    """The four filters of a two-channel bank with perfect reconstruction.

    Parameters
    ----------
    name_or_path : str or os.PathLike
        A name, of this library (``"db4"``, ``"coif2"``, ``"bspline4.4"``, ``"cdf9.7"``), of PyWavelets, MATLAB or R
        (``"D8"``, ``"bior4.4"``, ``"la8"``), or the path of a JSON file with your own taps.

    Raises
    ------
    ValueError
        For an unknown name, or a file that is no filter.

    Notes
    -----
    `analysis_low`, `analysis_high`, `synthesis_low` and `synthesis_high` are the filters with their first indices:
    ``phi(t) = sqrt 2 sum_n synthesis_low_n phi(2t - n)``. `dec_lo`, `dec_hi`, `rec_lo` and `rec_hi` are the same numbers in
    PyWavelets' order, sign and length, so that ``pywt.Wavelet("mine", filter_bank=bank)`` works. Each tap is the
    correctly rounded one. docs/conventions.md has the map.

    Examples
    --------
    >>> import wavecurve
    >>> wavecurve.FilterBank("D8")
    FilterBank('db4')
    """

    def __init__(self, name_or_path: str | PathLike[str]) -> None:
        super().__init__(str(name_or_path))

    @classmethod
    def from_taps(  # type: ignore[override]
        cls,
        synthesis: Iterable[Tap],
        *,
        first_index: int = 0,
        analysis: Iterable[Tap] | None = None,
        analysis_first_index: int = 0,
        sum: str = "sqrt2",
        name: str = "taps",
        vanishing_moments: int | None = None,
        dual_vanishing_moments: int | None = None,
        accuracy: Tap | None = None,
    ) -> "FilterBank":
        """The bank of your own low-pass taps, after a check of what they claim.

        Parameters
        ----------
        synthesis, analysis : iterable of str, Decimal, Fraction, int or float
            The low-pass filters; without `analysis` the filter is orthonormal. Decimals stand for all numbers that round
            to them, a Fraction for itself; of a float its shortest decimal counts.
        first_index, analysis_first_index : int
            The index of the first tap.
        sum : {"sqrt2", "1", "2"}
            What the taps add up to.
        vanishing_moments, dual_vanishing_moments : int, optional
            The zeros at pi of `synthesis` and of `analysis`, where they are claimed.
        accuracy : number or str, optional
            A bound of the error of every tap; without it half a unit of its last digit.

        Raises
        ------
        ValueError
            If no filter near the taps has perfect reconstruction, and by how much.
        """
        made = _native.NativeFilterBank.from_taps(
            name,
            (first_index, [tap_text(tap) for tap in synthesis]),
            None if analysis is None else (analysis_first_index, [tap_text(tap) for tap in analysis]),
            sum,
            vanishing_moments,
            dual_vanishing_moments,
            None if accuracy is None else tap_text(accuracy),
        )
        bank = cls.__new__(cls)
        bank.__setstate__(made.__getstate__())
        return bank

    def __repr__(self) -> str:
        return f"FilterBank({self.name!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, FilterBank) and self.__getstate__() == other.__getstate__()

    def __hash__(self) -> int:
        return hash(self.name)

    def _one(self, which: str) -> Taps:
        return Taps(*self.taps(which))

    @property
    def analysis_low(self) -> Taps:
        """The low-pass filter of the analysis side, sum sqrt 2."""
        return self._one("analysis_low")

    @property
    def analysis_high(self) -> Taps:
        """The high-pass filter of the analysis side."""
        return self._one("analysis_high")

    @property
    def synthesis_low(self) -> Taps:
        """The low-pass filter of phi, sum sqrt 2."""
        return self._one("synthesis_low")

    @property
    def synthesis_high(self) -> Taps:
        """The high-pass filter, of psi."""
        return self._one("synthesis_high")

    def _padded(self, which: str) -> npt.NDArray[np.float64]:
        """In the window of all low-pass taps, made even at its end; of the high-pass filters the mirrored window."""
        low, dual = self.synthesis_low, self.analysis_low
        first = min(low.first_index, dual.first_index)
        last = max(t.first_index + len(t.taps) for t in (low, dual)) - 1
        length = (last - first + 2) // 2 * 2
        filter = self._one(which)
        is_high = which.endswith("high")
        start = filter.first_index - (1 - (first + length - 1) if is_high else first)
        window = np.zeros(length)
        window[start : start + len(filter.taps)] = filter.taps
        return -window if is_high and first % 2 else window

    @property
    def dec_lo(self) -> list[float]:
        """Decomposition low pass as PyWavelets has it."""
        return [float(tap) for tap in self._padded("analysis_low")[::-1]]

    @property
    def dec_hi(self) -> list[float]:
        """Decomposition high pass as PyWavelets has it."""
        return [float(tap) for tap in self._padded("analysis_high")[::-1]]

    @property
    def rec_lo(self) -> list[float]:
        """Reconstruction low pass as PyWavelets has it."""
        return [float(tap) for tap in self._padded("synthesis_low")]

    @property
    def rec_hi(self) -> list[float]:
        """Reconstruction high pass as PyWavelets has it."""
        return [float(tap) for tap in self._padded("synthesis_high")]

    @property
    def filter_bank(self) -> tuple[list[float], list[float], list[float], list[float]]:
        """(dec_lo, dec_hi, rec_lo, rec_hi), the attribute that ``pywt.Wavelet(filter_bank=...)`` reads."""
        return self.dec_lo, self.dec_hi, self.rec_lo, self.rec_hi

    def decimals(self, which: str = "synthesis_low", digits: int = 40) -> NumberTable:  # type: ignore[override]
        """One of the filters to any number of proved digits.

        Parameters
        ----------
        which : {"analysis_low", "analysis_high", "synthesis_low", "synthesis_high"}
        digits : int
            Significant digits, 1 .. 10000.

        Returns
        -------
        NumberTable
            By the library's index n.
        """
        first, numbers = super().decimals(which, checked_digits(digits))
        return made_table(which, self.name, enumerate(numbers, first))

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th>{which}</th><td>{taps.first_index}</td><td><code>"
            f"{', '.join(f'{tap:.6g}' for tap in taps.taps)}</code></td></tr>"
            for which in ("analysis_low", "analysis_high", "synthesis_low", "synthesis_high")
            for taps in [self._one(which)]
        )
        return (
            f"<table><caption>{self.name}: {self.vanishing_moments} vanishing moments, Sobolev exponent "
            f"{self.sobolev_exponent:.3f}</caption><thead><tr><th>filter</th><th>first index</th><th>taps</th></tr></thead>"
            f"<tbody>{rows}</tbody></table>"
        )


def tap_text(tap: Tap) -> str:
    """A tap as the library reads it: every digit, and no more."""
    return repr(float(tap)) if isinstance(tap, float) else str(tap)


@lru_cache(maxsize=256)
def named_bank(name: str) -> FilterBank:
    """The bank of a name, kept: it never changes."""
    return FilterBank(name)


def bank_of(filter: FilterLike) -> FilterBank:
    """A filter bank, of a name or path where it is none yet."""
    if isinstance(filter, FilterBank):
        return filter
    text = str(filter)
    return FilterBank(text) if text.endswith(".json") else named_bank(text)


def filter_names() -> Sequence[str]:
    """The canonical names of all filters; the splines, which are infinitely many, up to order 9.

    Returns
    -------
    list of str
    """
    return _native.filter_names()


def filter_aliases() -> dict[str, str]:
    """What else filters are called, and the canonical names.

    Returns
    -------
    dict
        Alias to canonical name, such as ``"D8"`` to ``"db4"``.
    """
    return _native.filter_aliases()
