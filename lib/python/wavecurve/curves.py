"""Curves: samples, coefficients, points, distances of shapes."""
from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from . import _native
from .filters import FilterBank, FilterLike, bank_of
from .transform import all_levels

__all__ = ["Curve", "ShapeDistance", "count_crossings", "elliptic_fourier_distance", "normalized_contour", "sample_contour",
           "shape_distance", "to_coefficients", "to_samples"]

Array = npt.NDArray[np.float64]


def sample_contour(points: npt.ArrayLike, samples: int = 256, *, keep_corners: bool = False) -> Array:
    """Points of a closed polygon, uniform in arc length.

    Parameters
    ----------
    points : array_like
        n x 2.
    samples : int
        A power of two from 4 on.
    keep_corners : bool
        Place a point on every corner.

    Returns
    -------
    numpy.ndarray
        samples x 2, clockwise as seen with y down.
    """
    return _native.sample_contour(plane(points), samples, keep_corners)


def plane(points: npt.ArrayLike) -> Array:
    """Points as n x 2."""
    array = np.asarray(points, dtype=float)
    if array.ndim != 2 or array.shape[1] != 2:
        raise ValueError(f"points have the shape {array.shape}, but must be n x 2")
    return array


def to_coefficients(
    samples: npt.ArrayLike, filter: FilterLike, levels: int | None = None, *, mode: str = "samples"
) -> Array:
    """Wavelet coefficients of a contour, in units of the drawing.

    Parameters
    ----------
    samples : array_like
        n x 2.
    filter : str, os.PathLike or FilterBank
    levels : int, optional
        All by default.
    mode : {"samples", "interpolate"}
        Whether the samples are the finest coefficients, as in the publication, or the curve passes through them.

    Returns
    -------
    numpy.ndarray
        n x 2, global-to-local order.

    Raises
    ------
    ArithmeticError
        Where no stable curve passes through the samples.
    """
    points = plane(samples)
    return _native.to_coefficients(bank_of(filter), points, all_levels(len(points)) if levels is None else levels, mode)


def to_samples(
    coefficients: npt.ArrayLike, filter: FilterLike, levels: int | None = None, *, mode: str = "samples"
) -> Array:
    """The inverse of `to_coefficients`, with the same parameters.

    Returns
    -------
    numpy.ndarray
        n x 2.
    """
    points = plane(coefficients)
    return _native.to_samples(bank_of(filter), points, all_levels(len(points)) if levels is None else levels, mode)


def normalized_contour(points: npt.ArrayLike) -> Array:
    """A closed curve without place, size, rotation, start and direction (Kuhl and Giardina 1982).

    Returns
    -------
    numpy.ndarray
        n x 2, mean 0, mean squared distance 1.
    """
    return _native.normalized_contour(plane(points))


def count_crossings(points: npt.ArrayLike, *, closed: bool = True) -> int:
    """How often a polygon properly crosses itself; exact.

    Returns
    -------
    int
    """
    return _native.count_crossings(plane(points), closed)


class ShapeDistance(NamedTuple):
    """How far two curves are from each other as shapes: total, by scale (coarse to fine), and the best shift and angle."""

    total: float
    by_scale: Array
    shift: float
    angle: float


def shape_distance(
    a: npt.ArrayLike, b: npt.ArrayLike, filter: FilterLike = "sym8", levels: int | None = None, *, closed: bool = True
) -> ShapeDistance:
    """The distance of two curves as shapes; place, size, rotation, start and direction do not count.

    Parameters
    ----------
    a, b : array_like
        n x 2, n a power of two from 4 on, uniform in arc length.
    filter : str, os.PathLike or FilterBank
        Orthonormal.
    levels : int, optional
        By default down to 8 coefficients.
    closed : bool
        False for strokes there and back.

    Returns
    -------
    ShapeDistance
        `total` is 0 for equal shapes and at most sqrt 2.
    """
    first = plane(a)
    if levels is None:
        levels = max(0, all_levels(len(first)) - 3)
    return ShapeDistance(*_native.shape_distance(first, plane(b), bank_of(filter), levels, closed))


def elliptic_fourier_distance(a: npt.ArrayLike, b: npt.ArrayLike, harmonics: int = 20) -> float:
    """The distance of elliptic Fourier descriptors (Kuhl and Giardina 1982), the yardstick of `shape_distance`.

    Returns
    -------
    float
    """
    return _native.elliptic_fourier_distance(plane(a), plane(b), harmonics)


class Curve:
    """The closed curve ``f(t) = sum_n c_n phi(N t - n)`` at any t.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    finest : array_like
        The coefficients of the finest level, N x 2.

    Raises
    ------
    ArithmeticError
        Where phi is not continuous.
    """

    def __init__(self, filter: FilterLike, finest: npt.ArrayLike) -> None:
        self.bank: FilterBank = bank_of(filter)
        self.finest = plane(finest)
        self._native = _native.NativeCurve(self.bank, self.finest)

    def __repr__(self) -> str:
        return f"<Curve of {len(self.finest)} coefficients, {self.bank.name}>"

    def __reduce__(self) -> tuple[object, ...]:
        return Curve, (self.bank, self.finest)

    def __call__(self, t: npt.ArrayLike, derivative: int = 0) -> Array:
        """Points, or derivatives with respect to t.

        Parameters
        ----------
        t : array_like
            Parameters of any shape; the curve has the period 1.
        derivative : int
            The order.

        Returns
        -------
        numpy.ndarray
            The shape of t, and 2.

        Raises
        ------
        ArithmeticError
            Where phi has no such derivative; the message has the Sobolev exponent.
        """
        moments = np.asarray(t, dtype=float)
        return self._native.derivative(moments.ravel(), derivative).reshape((*moments.shape, 2))

    def curvature(self, t: npt.ArrayLike) -> Array:
        """The curvature, positive where the curve turns clockwise as seen with y down.

        Returns
        -------
        numpy.ndarray
            The shape of t, in 1 / unit of length.
        """
        moments = np.asarray(t, dtype=float)
        return np.reshape(self._native.curvature(moments.ravel()), moments.shape)
