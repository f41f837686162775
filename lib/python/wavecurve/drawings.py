"""Drawings and their descriptors."""
from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Union

import numpy as np
import numpy.typing as npt

from . import _native
from .filters import FilterLike, bank_of
from .transform import all_levels

__all__ = ["ContourDescriptor", "Descriptor", "Drawing", "LayerDescriptor", "describe", "read_drawing"]

Array = npt.NDArray[np.float64]
PathText = Union[str, "PathLike[str]"]


class Drawing:
    """A drawing, SVG or a table of points.

    Attributes
    ----------
    path : pathlib.Path
    layers : list of str
        Ids, in painting order.
    view_box : (x, y, width, height)
    warnings : list of str
        What of the file is not supported.
    """

    def __init__(self, path: PathText, *, open: bool = False, y_up: bool = False) -> None:
        self.path = Path(path)
        self._open, self._y_up = open, y_up
        self._native = _native.NativeDrawing(self.path, open, y_up)
        self.layers: list[str] = self._native.layers
        self.view_box: tuple[float, float, float, float] = self._native.view_box
        self.warnings: list[str] = self._native.warnings

    def __repr__(self) -> str:
        return f"<Drawing {self.path.name}: {len(self.layers)} layers>"

    def __reduce__(self) -> tuple[object, ...]:
        return reread, (self.path, self._open, self._y_up)

    def contours(self, layer: str | int, samples: int = 256, *, keep_corners: bool = False) -> list[Array]:
        """The contours of a layer, sampled uniformly in arc length.

        Parameters
        ----------
        layer : str or int
            Its id or place.
        samples : int
            Points a contour, a power of two from 4 on.
        keep_corners : bool
            Place a point on every corner.

        Returns
        -------
        list of numpy.ndarray
            samples x 2 each, in units of the drawing, y down.
        """
        return self._native.contours(place_of(self.layers, layer), samples, keep_corners)


def place_of(ids: list[str], layer: str | int) -> int:
    """The place of a layer."""
    if isinstance(layer, int):
        if not -len(ids) <= layer < len(ids):
            raise ValueError(f"layer is {layer}, but there are {len(ids)}")
        return layer % len(ids)
    if layer not in ids:
        raise ValueError(f"unknown layer '{layer}'; known: {', '.join(ids)}")
    return ids.index(layer)


def reread(path: Path, open: bool, y_up: bool) -> Drawing:
    """A pickled drawing again."""
    return Drawing(path, open=open, y_up=y_up)


def read_drawing(path: PathText, *, open: bool = False, y_up: bool = False) -> Drawing:
    """Read an SVG file or a table of points.

    Parameters
    ----------
    path : path
        .svg, .svgz or .csv.
    open, y_up : bool
        What a table does not say: contours are not closed; y points up.

    Returns
    -------
    Drawing

    Raises
    ------
    ValueError
        For what is no drawing, with the file and the line.
    """
    return Drawing(path, open=open, y_up=y_up)


@dataclass(frozen=True)
class ContourDescriptor:
    """A contour's wavelet coefficients (samples x 2, global-to-local), whether it is closed, its length, and each band's
    share of the energy about the mean, coarsest first."""

    coefficients: Array
    closed: bool
    length: float
    energy_shares: Array


@dataclass(frozen=True)
class LayerDescriptor:
    """The contours of a layer."""

    id: str
    contours: list[ContourDescriptor]


class Descriptor:
    """The wavelet descriptor of a drawing, publication section 2.2.

    Attributes
    ----------
    layers : list of LayerDescriptor
    filter : FilterBank
    samples, levels : int
    """

    def __init__(self, drawing: Drawing, filter: FilterLike, samples: int, levels: int, mode: str, keep_corners: bool,
                 normalized: bool) -> None:
        self.filter = bank_of(filter)
        self.samples, self.levels = samples, levels
        self._native = _native.NativeDescriptor(drawing._native, self.filter, samples, levels, mode, keep_corners, normalized)
        self._parts = (drawing, self.filter, samples, levels, mode, keep_corners, normalized)
        self.layers = [LayerDescriptor(id, [ContourDescriptor(*c) for c in contours]) for id, contours in self._native.layers]

    def __repr__(self) -> str:
        count = sum(len(layer.contours) for layer in self.layers)
        return f"<Descriptor of {count} contours, {self.filter.name}, {self.samples} samples, {self.levels} levels>"

    def __reduce__(self) -> tuple[object, ...]:
        return Descriptor, self._parts

    def reconstruct(self, layer: str | int, scale: int | None = None) -> list[Array]:
        """The samples of a layer's contours from the coarsest coefficients.

        Parameters
        ----------
        layer : str or int
        scale : int, optional
            How many coefficients: samples, samples / 2, ... samples / 2^levels; all by default.

        Returns
        -------
        list of numpy.ndarray
            samples x 2 each.
        """
        ids = [layer_.id for layer_ in self.layers]
        return self._native.reconstruct(place_of(ids, layer), self.samples if scale is None else scale)

    def to_json(self) -> str:
        """The descriptor as ``wavecurve describe -o`` writes it.

        Returns
        -------
        str
        """
        return self._native.to_json()


def describe(
    drawing: Drawing | PathText,
    filter: FilterLike = "bspline4.4",
    samples: int = 256,
    levels: int | None = None,
    *,
    mode: str = "samples",
    keep_corners: bool = False,
    normalized: bool = False,
) -> Descriptor:
    """The wavelet descriptor of a drawing.

    Parameters
    ----------
    drawing : Drawing or path
    filter : str, os.PathLike or FilterBank
    samples : int
        A contour, a power of two from 4 on.
    levels : int, optional
        By default down to 16 coefficients.
    mode : {"samples", "interpolate"}
    keep_corners, normalized : bool
        Place a sample on every corner; remove start, direction, rotation, size and place.

    Returns
    -------
    Descriptor
    """
    if levels is None:
        levels = max(0, all_levels(samples) - 4)
    source = drawing if isinstance(drawing, Drawing) else Drawing(drawing)
    return Descriptor(source, filter, samples, levels, mode, keep_corners, normalized)
