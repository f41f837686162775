"""Matrices of the periodized multiscale basis, and Schulz's inverse."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _native
from .filters import FilterLike, bank_of
from .transform import all_levels

if TYPE_CHECKING:
    import scipy.sparse
    import scipy.sparse.linalg

__all__ = ["SchulzInverse", "damping", "differentiation_matrix", "extreme_eigenvalues", "gram", "linear_operator",
           "multiscale_matrix", "nonstandard_matrix", "schulz_inverse", "stiffness", "synthesis_matrix", "vibration_eigenvalues"]


def levels_of(samples: int, levels: int | None) -> int:
    """All levels where none are given."""
    return all_levels(samples) if levels is None else levels


def multiscale_matrix(
    filter: FilterLike, samples: int, levels: int | None = None, derivatives: tuple[int, int] = (1, 1)
) -> "scipy.sparse.csc_matrix":
    """The matrix of ``int b_i^(p) b_j^(q) dx`` of the periodized basis on the unit interval.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    samples : int
        The size, a power of two up to 2^24.
    levels : int, optional
        Levels of decomposition; all by default, 0 for the circulant of a single scale.
    derivatives : (int, int)
        Orders p, q.

    Returns
    -------
    scipy.sparse.csc_matrix
        samples x samples, rows and columns in global-to-local order; exactly symmetric for even p + q.

    Raises
    ------
    ValueError
        For sizes that do not fit.
    ArithmeticError
        Where phi is not smooth enough; the message has the exponents found and needed.
    """
    p, q = derivatives
    return _native.matrix(bank_of(filter), samples, levels_of(samples, levels), p, q)


def stiffness(filter: FilterLike, samples: int, levels: int | None = None) -> "scipy.sparse.csc_matrix":
    """The stiffness matrix K, derivatives (1, 1) and unit factor, as `multiscale_matrix`.

    Returns
    -------
    scipy.sparse.csc_matrix
    """
    return multiscale_matrix(filter, samples, levels, (1, 1))


def gram(filter: FilterLike, samples: int, levels: int | None = None) -> "scipy.sparse.csc_matrix":
    """The Gram matrix, derivatives (0, 0); exactly the identity of an orthonormal filter.

    Returns
    -------
    scipy.sparse.csc_matrix
    """
    return multiscale_matrix(filter, samples, levels, (0, 0))


def damping(
    filter: FilterLike, samples: int, levels: int | None = None, *, s1: float = 0.0, s2: float = 0.0
) -> "scipy.sparse.csc_matrix":
    """Rayleigh damping ``C = s1 M + s2 K``, publication (3.5).

    Returns
    -------
    scipy.sparse.csc_matrix
    """
    return _native.damping(bank_of(filter), samples, levels_of(samples, levels), s1, s2)


def differentiation_matrix(
    filter: FilterLike, samples: int, derivative: int = 1, *, collocation: bool = False
) -> "scipy.sparse.csc_matrix":
    """A circulant that differentiates functions of period 1, on any number of samples.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    samples : int
        The size N.
    derivative : int
        The order d.
    collocation : bool
        From the values f(n/N) to the values of the derivative of the function of the space that has them. Otherwise
        Galerkin's method: from the coefficients of f to those of the derivative's projection.

    Returns
    -------
    scipy.sparse.csc_matrix

    Raises
    ------
    ValueError
        For sizes and orders that do not fit.
    ArithmeticError
        Where phi is not smooth enough, or no function of the space has given values.

    Examples
    --------
    >>> import numpy, wavecurve
    >>> x = numpy.arange(50) / 50
    >>> slope = wavecurve.differentiation_matrix("db4", 50) @ numpy.sin(2 * numpy.pi * x)
    >>> bool(numpy.max(numpy.abs(slope - 2 * numpy.pi * numpy.cos(2 * numpy.pi * x))) < 1e-8)
    True
    """
    return _native.differentiation(bank_of(filter), samples, derivative, collocation)


def nonstandard_matrix(
    filter: FilterLike, samples: int, levels: int | None = None, derivative: int = 1
) -> "scipy.sparse.csc_matrix":
    """The non-standard form of a derivative (Beylkin, Coifman and Rokhlin 1991) as one matrix.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
        Orthonormal.
    samples : int
        A power of two.
    levels : int, optional
        Levels of decomposition; all by default.
    derivative : int

    Returns
    -------
    scipy.sparse.csc_matrix
        On the diagonal a block [A B; C 0] for each level, the coarsest first, whose zero is the scaling functions' block.

    Raises
    ------
    ValueError
        For sizes that do not fit, and a filter that is not orthonormal.
    ArithmeticError
        Where phi is not smooth enough.
    """
    return _native.nonstandard(bank_of(filter), samples, levels_of(samples, levels), derivative)


def synthesis_matrix(filter: FilterLike, samples: int, levels: int | None = None) -> "scipy.sparse.csc_matrix":
    """The matrix S of the inverse transform: samples = S coefficients.

    Returns
    -------
    scipy.sparse.csc_matrix
    """
    return _native.synthesis_matrix(bank_of(filter), samples, levels_of(samples, levels))


def linear_operator(
    filter: FilterLike, samples: int, levels: int | None = None, derivatives: tuple[int, int] = (1, 1)
) -> "scipy.sparse.linalg.LinearOperator":
    """`multiscale_matrix` as an operator that is applied in O(samples) without being assembled.

    Returns
    -------
    scipy.sparse.linalg.LinearOperator
        For scipy's iterative solvers; its adjoint is known.
    """
    from scipy.sparse.linalg import LinearOperator

    p, q = derivatives
    bank = bank_of(filter)
    native = _native.NativeOperator(bank, samples, levels_of(samples, levels), p, q)
    sign = -1.0 if (p + q) % 2 else 1.0

    def apply(x: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        return native.apply(np.reshape(x, (samples, -1))).reshape(x.shape)

    def adjoint(x: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        return sign * apply(x)

    return LinearOperator((samples, samples), matvec=apply, rmatvec=adjoint, matmat=apply, rmatmat=adjoint,
                          dtype=np.float64)


def extreme_eigenvalues(
    filter: FilterLike, samples: int, levels: int | None = None, derivative: int = 1
) -> tuple[float, float]:
    """The smallest eigenvalue above 0 and the largest of the matrix of derivatives (p, p), p = 0 or 1.

    Returns
    -------
    (float, float)
        Their quotient is the condition number on the complement of the null space.
    """
    return _native.spectrum_ends(bank_of(filter), samples, levels_of(samples, levels), derivative)


def vibration_eigenvalues(filter: FilterLike, samples: int) -> npt.NDArray[np.float64]:
    """The eigenvalues of ``K x = lambda M x`` by frequency; that of k tends to ``(2 pi k)^2``.

    Returns
    -------
    numpy.ndarray
        As long as there are frequencies.
    """
    return _native.vibration_eigenvalues(bank_of(filter), samples)


@dataclass(frozen=True)
class SchulzInverse:
    """An inverse by Schulz's iteration, and how it came about.

    Attributes
    ----------
    inverse : numpy.ndarray or scipy.sparse.csc_matrix
    residuals : list of float
        ``||I - X_n C||_F``, n = 0, 1, ...; the last is that of `inverse`.
    status : {"converged", "stagnated", "singular"}
    error_bound : float
        A bound of ``||X - C^-1||_F``; infinite where the last residual is 1 or more.
    dropped : list of float
        Frobenius norm of what each step dropped, of sparse matrices.
    """

    inverse: Any
    residuals: list[float]
    status: str
    error_bound: float
    dropped: list[float]

    def __repr__(self) -> str:
        return (f"<SchulzInverse {self.status} after {len(self.residuals) - 1} steps, residual {self.residuals[-1]:.3g}, "
                f"error at most {self.error_bound:.3g}>")


def schulz_inverse(c: Any, tolerance: float = 1e-10, threshold: float = 0.0) -> SchulzInverse:
    """Schulz's iteration ``X_{n+1} = 2 X_n - X_n C X_n``, publication section 3.3.

    Parameters
    ----------
    c : array_like or scipy sparse matrix
        Square.
    tolerance : float
        The residual at which the iteration ends.
    threshold : float
        Entries of a sparse matrix below this times the largest are dropped after each step.

    Returns
    -------
    SchulzInverse

    Raises
    ------
    ValueError
        Unless c is square, not empty and finite.
    ArithmeticError
        Where sparse products take too many multiplications.
    """
    if hasattr(c, "tocsc"):
        return SchulzInverse(**_native.schulz_sparse(c.tocsc(), tolerance, threshold))
    return SchulzInverse(**_native.schulz_dense(np.atleast_2d(np.asarray(c, dtype=float)), tolerance))
