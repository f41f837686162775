"""Connection coefficients of every kind, each with its proof."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

from . import _native
from .filters import FilterLike, bank_of
from .numbers import NumberTable, checked_digits, made_table

__all__ = ["Coefficients", "coefficients", "integrals", "moments", "operator_coefficients", "quadrature", "quantity",
           "reproduction"]


@dataclass(frozen=True)
class Coefficients:
    """Autocorrelation and connection coefficients for the indices 0, 1, 2, ...

    Attributes
    ----------
    alpha : NumberTable
        ``2 sum_i h_i h_{i+n}`` of the filter of phi.
    mu, nu : NumberTable
        ``int phi^(p)(x - l) phi^(q)(x) dx`` and the same of psi. For even p + q they are symmetric in l, for odd ones
        antisymmetric, as alpha is symmetric.
    derivatives : tuple of int
        (p, q).
    """

    filter: str
    derivatives: tuple[int, int]
    alpha: NumberTable
    mu: NumberTable
    nu: NumberTable

    def __repr__(self) -> str:
        return f"<Coefficients of {self.filter}, derivatives {self.derivatives}: alpha, mu, nu>"

    def __str__(self) -> str:
        return "\n\n".join(map(str, (self.alpha, self.mu, self.nu)))

    def _repr_html_(self) -> str:
        return "".join(table._repr_html_() for table in (self.alpha, self.mu, self.nu))


def coefficients(
    filter: FilterLike, derivatives: tuple[int, int] = (1, 1), digits: int = 40, normalize: bool = False
) -> Coefficients:
    """Alpha, mu and nu of a filter, correctly rounded, with proof.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    derivatives : (int, int)
        Orders p, q of the derivatives, 0 .. 8: (1, 1) stiffness, (0, 0) mass, (0, 1) advection, (2, 2) bending.
    digits : int
        Significant digits, 1 .. 10000.
    normalize : bool
        Divide mu and nu by their entry of index 0, as published tables do; for even p + q.

    Returns
    -------
    Coefficients

    Raises
    ------
    ValueError
        For digits or orders out of bounds, an unknown filter.
    ArithmeticError
        Where phi is not smooth enough; the message has the Sobolev exponent found and the one needed, which are the
        attributes `found` and `needed`, too.

    Examples
    --------
    >>> import wavecurve
    >>> wavecurve.coefficients("db3").mu[0].exact
    Fraction(295, 56)
    """
    bank = bank_of(filter)
    p, q = derivatives
    found = _native.coefficients(bank, p, q, checked_digits(digits), normalize)
    alpha, mu, nu = (made_table(name, bank.name, enumerate(found[name])) for name in ("alpha", "mu", "nu"))
    return Coefficients(bank.name, (p, q), alpha, mu, nu)


def integrals(
    filter: FilterLike, integral: str, *, on: str | tuple[object, object] | None = None, period: int | None = None,
    digits: int = 40
) -> NumberTable:
    """Integrals of products of up to four factors, over the line, an interval or a period.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    integral : str
        The factors, such as ``"phi' phi(l) phi(m)"`` for ``int phi'(x) phi(x - l) phi(x - m) dx``: phi, psi, phi~, psi~,
        with primes or ``^(p)`` for derivatives, ``(l)`` or ``(2x - l)`` for shift and level, and ``x^p``.
    on : str or (a, b), optional
        From a to b, integers or dyadic points; then every factor may have a letter.
    period : int, optional
        Make the factors periodic and integrate over one period.
    digits : int
        Significant digits, 1 .. 10000.

    Returns
    -------
    NumberTable
        By the tuple of the indices (an int where there is one), row by row.

    Raises
    ------
    ValueError
        With the column where the text is no longer understood, or for bounds that are exceeded.
    ArithmeticError
        Where the integral does not exist; the message has the exponents found and needed.
    """
    bank = bank_of(filter)
    interval = on if on is None or isinstance(on, str) else f"{on[0]},{on[1]}"
    name, entries = _native.integrals(bank, integral, interval, period, checked_digits(digits))
    return made_table(name, bank.name, ((plain_index(index), number) for index, number in entries))


def plain_index(index: Sequence[int]) -> int | tuple[int, ...]:
    """The number of a tuple of one."""
    return index[0] if len(index) == 1 else tuple(index)


def operator_coefficients(filter: FilterLike, operator: str, up_to: int = 10, digits: int = 40) -> NumberTable:
    """``r_l = int phi(x - l) (T phi)(x) dx`` of an operator T without compact support.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    operator : str
        ``"hilbert"``, ``"fractional:S"`` (the derivative of order S, or the integral of order -S; S a decimal or p/q),
        ``"riesz:S"`` (of the symbol ``|w|^S``), ``"hilbert:S"`` (the Hilbert transform of that), or ``"derivative:K"``.
    up_to : int
        The largest ``|l|``.
    digits : int
        Significant digits, 1 .. 10000.

    Returns
    -------
    NumberTable
        By l, from -up_to to up_to; of a derivative those of the support.

    Raises
    ------
    ValueError
        For another operator, an order above 8.
    ArithmeticError
        Where phi is not smooth enough.
    """
    bank = bank_of(filter)
    kind, _, order = operator.partition(":")
    name = f"operator {operator}"
    if kind == "fractional":
        value = fraction_of(order, operator)
        if value.denominator == 1 and value >= 0:
            kind, order = "derivative", str(value)
    if kind == "derivative" and order.isdecimal():
        entries = _native.derivative_operator(bank, min(int(order), 99), checked_digits(digits))
        return made_table(name, bank.name, ((index[0], n) for index, n in entries if abs(index[0]) <= up_to))
    if kind in ("hilbert", "riesz", "fractional"):
        order = str(fraction_of("0" if operator == "hilbert" else order, operator))
        numbers = _native.homogeneous_operator(bank, kind, order, up_to, checked_digits(digits))
        return made_table(name, bank.name, enumerate(numbers, -up_to))
    raise ValueError(f"operator is '{operator}', but must be hilbert, hilbert:S, riesz:S, fractional:S or derivative:K")


def fraction_of(order: str, operator: str) -> Fraction:
    """The order S of an operator."""
    try:
        return Fraction(order)
    except (ValueError, ZeroDivisionError):
        raise ValueError(f"operator is '{operator}', but S must be a decimal or p/q") from None


def moments(
    filter: FilterLike, highest: int = 10, *, wavelet: bool = False, dual: bool = False, digits: int = 40
) -> NumberTable:
    """The moments ``int x^p f(x) dx``, p = 0 .. highest, of phi, psi, or those of the analysis side.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    highest : int
        The highest power, 0 .. 100.
    wavelet : bool
        The moments of psi, not of phi.
    dual : bool
        Those of the analysis side.
    digits : int
        Significant digits, 1 .. 10000.

    Returns
    -------
    NumberTable
        By p. Those of psi that vanish are exactly 0.

    Raises
    ------
    ValueError
        For a bound that is exceeded.
    """
    bank = bank_of(filter)
    numbers = _native.moments(bank, wavelet, dual, highest, checked_digits(digits))
    name = f"moment({'psi' if wavelet else 'phi'}{'~' if dual else ''})"
    return made_table(name, bank.name, enumerate(numbers))


def reproduction(filter: FilterLike, digits: int = 40) -> NumberTable:
    """The numbers ``a_p`` by which shifts of phi reproduce polynomials.

    ``x^p = sum_l c_p(l) phi(x - l)``, ``c_p(l) = sum_{k<=p} binomial(p, k) l^(p-k) a_k``.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    digits : int
        Significant digits, 1 .. 10000.

    Returns
    -------
    NumberTable
        By p, below the number of vanishing moments.
    """
    bank = bank_of(filter)
    return made_table("reproduction(phi)", bank.name, enumerate(_native.reproduction(bank, checked_digits(digits))))


def quadrature(
    filter: FilterLike, count: int, *, first: int | None = None, digits: int = 40
) -> NumberTable:
    """Weights of ``int f(x) phi(x) dx = sum_k weight_k f(k)``, exact for polynomials below degree `count`.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    count : int
        The number of nodes, 1 .. 40: the integers first, first + 1, ...
    first : int, optional
        The first node; by default the nodes stand about the centre of phi.
    digits : int
        Significant digits, 1 .. 10000.

    Returns
    -------
    NumberTable
        By node.

    Raises
    ------
    ValueError
        For a count out of bounds.
    """
    bank = bank_of(filter)
    if first is None:
        first = round(float(moments(bank, 1, digits=17)[1]) - (count - 1) / 2)
    numbers = _native.quadrature_weights(bank, str(first), "1", count, checked_digits(digits))
    return made_table("weight(phi)", bank.name, enumerate(numbers, first))


def quantity(
    filter: FilterLike, name: str, *, digits: int = 40, level: int = 0, highest_moment: int = 10
) -> NumberTable:
    """Any quantity by its name in the grammar of `check`.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    name : str
        Such as ``"h*sqrt2"``, ``"mu/first"``, ``"int(phi'', phi)"``, ``"phi"``, ``"sobolev(phi)"``, ``"lifting"``.
    digits : int
        Significant digits, 1 .. 10000.
    level : int
        Values of functions at the points k / 2^level, 0 .. 10.
    highest_moment : int
        The highest moment of a list of moments, 0 .. 100.

    Returns
    -------
    NumberTable
        By the index of the quantity.

    Raises
    ------
    ValueError
        With the column where the name is no longer understood.
    ArithmeticError
        Where the quantity does not exist for the filter.
    """
    bank = bank_of(filter)
    text, entries = _native.quantity(bank, name, checked_digits(digits), level, highest_moment)
    return made_table(text, bank.name, entries)
