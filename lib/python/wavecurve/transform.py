"""The periodic wavelet transform of arrays."""
from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _native
from .filters import FilterBank, FilterLike, bank_of

__all__ = ["Transform", "bands", "forward", "inverse"]


class Transform(_native.NativeTransform):
    """The discrete periodic wavelet transform of a bank for signals of one length.

    Coefficients stand in global-to-local order: the scaling coefficients of the coarsest level first, then the
    wavelet coefficients from coarse to fine (`bands` has their places). Publication, section 2.1, (2.7)-(2.9).

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    samples : int
        The length of each signal; 2^levels divides it.
    levels : int, optional
        Levels of decomposition; by default as many as `samples` can be halved.

    Raises
    ------
    ValueError
        For numbers that do not fit, an unknown filter.

    Notes
    -----
    An object may serve several threads at once. The transform wraps as often as needed where the filter is longer
    than the signal. PyWavelets' ``mode="periodization"`` differs by a shift and signs (docs/conventions.md).

    Examples
    --------
    >>> import numpy, wavecurve
    >>> transform = wavecurve.Transform("db4", 256)
    >>> x = numpy.arange(256.0)
    >>> numpy.allclose(transform.inverse(transform.forward(x)), x)
    True
    """

    def __init__(self, filter: FilterLike, samples: int, levels: int | None = None) -> None:
        if levels is None:
            levels = all_levels(samples)
        self._bank = bank_of(filter)
        super().__init__(self._bank, samples, levels)

    @property
    def bank(self) -> FilterBank:
        """The filter bank."""
        return self._bank

    def __repr__(self) -> str:
        return f"Transform({self._bank.name!r}, {self.samples}, {self.levels})"

    def __reduce__(self) -> tuple[object, ...]:
        return Transform, (self._bank, self.samples, self.levels)


def all_levels(samples: int) -> int:
    """How often a number can be halved; 0 for what is not positive, which the library refuses by name."""
    return (samples & -samples).bit_length() - 1 if samples > 0 else 0


@lru_cache(maxsize=64)
def kept_transform(filter: FilterLike, samples: int, levels: int | None) -> Transform:
    """Transforms do not change, so that those of names are kept."""
    return Transform(filter, samples, levels)


def transform_for(
    x: npt.ArrayLike, filter: FilterLike, levels: int | None, axis: int
) -> tuple[npt.NDArray[Any], Transform]:
    """The array, and the transform of signals along its axis."""
    array = x if isinstance(x, np.ndarray) else np.asarray(x)
    try:
        samples = array.shape[axis]
    except IndexError:
        raise ValueError(f"axis is {axis}, but must be one of the argument's {array.ndim}") from None
    if isinstance(filter, str) and not filter.endswith(".json"):
        return array, kept_transform(filter, samples, levels)
    return array, Transform(filter, samples, levels)


def forward(
    x: npt.ArrayLike, filter: FilterLike, levels: int | None = None, axis: int = -1, threads: int = 1
) -> npt.NDArray[Any]:
    """Samples to wavelet coefficients.

    Parameters
    ----------
    x : array_like
        float64 or float32, read where it lies; integers become float64. 2^levels divides the size along the axis.
    filter : str, os.PathLike or FilterBank
    levels : int, optional
        Levels of decomposition; by default as many as the size can be halved.
    axis : int
        The axis along which each signal runs.
    threads : int
        Threads that share the signals of a batch; the result is the same to the last bit.

    Returns
    -------
    numpy.ndarray
        An array of the shape and dtype of x, in global-to-local order along the axis.

    Raises
    ------
    ValueError
        For a size that does not fit, an unknown axis or filter.
    """
    array, transform = transform_for(x, filter, levels, axis)
    return transform.forward(array, axis, None, threads)


def inverse(
    coefficients: npt.ArrayLike, filter: FilterLike, levels: int | None = None, axis: int = -1, threads: int = 1
) -> npt.NDArray[Any]:
    """Wavelet coefficients to samples; the inverse of `forward`, with the same parameters.

    Parameters
    ----------
    coefficients : array_like
        In global-to-local order along the axis.
    filter, levels, axis, threads
        As `forward` has them.

    Returns
    -------
    numpy.ndarray
        An array of the shape and dtype of `coefficients`.

    Raises
    ------
    ValueError
        As `forward`.
    """
    array, transform = transform_for(coefficients, filter, levels, axis)
    return transform.inverse(array, axis, None, threads)


def bands(samples: int, levels: int | None = None) -> list[slice]:
    """Where each band stands in global-to-local order.

    Parameters
    ----------
    samples, levels : int
        As `Transform` has them.

    Returns
    -------
    list of slice
        The scaling coefficients, then the wavelet coefficients from coarse to fine: the order of ``pywt.wavedec``.

    Raises
    ------
    ValueError
        Unless 2^levels divides samples.
    """
    if levels is None:
        levels = all_levels(samples)
    if samples < 1 or levels < 0 or samples % (1 << levels):
        raise ValueError(f"samples is {samples}, but must be a positive multiple of 2^levels, levels {levels}")
    edges = [0, *(samples >> depth for depth in range(levels, -1, -1))]
    return [slice(a, b) for a, b in zip(edges, edges[1:])]
