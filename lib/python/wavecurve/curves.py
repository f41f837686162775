"""Curves, drawings, descriptors and morphs."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple, Union

import numpy as np
import numpy.typing as npt

from . import _native
from .filters import FilterBank, FilterLike, bank_of
from .transform import all_levels

__all__ = ["Animation", "ContourDescriptor", "Curve", "Descriptor", "Drawing", "FrameLayer", "LayerDescriptor", "Morph",
           "ShapeDistance", "count_crossings", "describe", "elliptic_fourier_distance", "morph", "normalized_contour",
           "read_drawing", "sample_contour", "shape_distance", "to_coefficients", "to_samples"]

Array = npt.NDArray[np.float64]
Path_ = Union[str, "PathLike[str]"]


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

    def __init__(self, path: Path_, *, open: bool = False, y_up: bool = False) -> None:
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


def read_drawing(path: Path_, *, open: bool = False, y_up: bool = False) -> Drawing:
    """Read an SVG file or a table of points.

    Parameters
    ----------
    path : path
        .svg, .svgz or .csv.
    open, y_up : bool
        Of tables: contours are not closed; y points up.

    Returns
    -------
    Drawing

    Raises
    ------
    ValueError
        For what is no drawing, with the file and the line.
    """
    return Drawing(path, open=open, y_up=y_up)


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
    drawing: Drawing | Path_,
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


class FrameLayer(NamedTuple):
    """A layer of a still picture: its id and its contours, n x 2 each."""

    id: str
    contours: list[Array]


class Animation:
    """Outlines that are piecewise linear in time, for any player.

    Attributes
    ----------
    duration : float
        Seconds.
    """

    def __init__(self, native: Any) -> None:
        self._native = native
        self.duration: float = native.duration

    def __repr__(self) -> str:
        return f"<Animation of {self.duration:g} s>"

    def frame(self, time: float) -> list[FrameLayer]:
        """The layers at a time, in painting order.

        Returns
        -------
        list of FrameLayer
        """
        return [FrameLayer(*layer) for layer in self._native.frame(time)]

    def write(self, path: Path_, *, frames: int = 60, tolerance: float = 0.0, loop: bool = False, pixels: int = 512) -> None:
        """Write a file; its extension selects the format: .svg .json (Lottie) .html .gif .mp4 .webm .png (folder).

        Parameters
        ----------
        path : path
        frames : int
        tolerance : float
            Maximum distance of the fitted cubics from the contour, in drawing units; 0 writes polygons.
        loop : bool
            Play for ever.
        pixels : int
            Of the longer side of a rendered frame.

        Raises
        ------
        ValueError
            For another extension.
        OSError
            Where the file cannot be written.
        """
        self._native.write(Path(path), frames, tolerance, loop, pixels)


class Morph:
    """One drawing into another, publication section 4; `morph` makes it."""

    def __init__(self, native: Any) -> None:
        self._native = native

    def __repr__(self) -> str:
        return "<Morph>"

    def animate(self) -> Animation:
        """The linear morph, (4.1).

        Returns
        -------
        Animation
        """
        return Animation(self._native.animate())

    def move(
        self, *, frames: int = 60, solver: str = "spectral", until: float | None = None, density: float = 1.0,
        stiffness: float = 1.0, bending: float = 0.0, mass_damping: float = 0.0, stiffness_damping: float = 0.1
    ) -> Animation:
        """The morph as the motion of elastic contours released as the source, publication section 4.2.

        Parameters
        ----------
        frames : int
            Keys at equal times.
        solver : str
            A name of `solvers`.
        until : float, optional
            Length of the motion in units of its time; until it has settled by default.
        density, stiffness, bending, mass_damping, stiffness_damping : float
            As `LagrangeSystem` has them.

        Returns
        -------
        Animation

        Raises
        ------
        ArithmeticError
            Where the motion never settles, or the solver stops.
        """
        return Animation(self._native.move(frames, solver, until, density, stiffness, bending, mass_damping, stiffness_damping))

    def write(self, path: Path_, *, frames: int = 60, tolerance: float = 0.0, loop: bool = False, pixels: int = 512) -> None:
        """Write the linear morph, as `Animation.write`; an .html lets the viewer choose the scale."""
        self._native.write(Path(path), frames, tolerance, loop, pixels)


def morph(
    source: Drawing | Path_,
    destination: Drawing | Path_,
    filter: FilterLike = "bspline4.4",
    *,
    samples: int = 1024,
    scale: int | None = None,
    detail: str = "blend",
    duration: float = 2.0,
    rotation: bool = False,
    map: Mapping[str, str] | None = None,
) -> Morph:
    """The morph of one drawing into another.

    Parameters
    ----------
    source, destination : Drawing or path
    filter : str, os.PathLike or FilterBank
    samples : int
        Points a contour, a power of two from 4 on.
    scale : int, optional
        Control points that are interpolated; all by default.
    detail : {"drop", "blend", "stage"}
        What becomes of the details finer than the scale.
    duration : float
        Seconds.
    rotation : bool
        Remove a rotation before points are matched.
    map : mapping, optional
        Ids of layers of the source and what they become.

    Returns
    -------
    Morph

    Raises
    ------
    ValueError
        For a map that fits no layer, numbers out of bounds.
    """
    ends = [drawing if isinstance(drawing, Drawing) else Drawing(drawing) for drawing in (source, destination)]
    pairs = list((map or {}).items())
    return Morph(_native.NativeMorph(ends[0]._native, ends[1]._native, bank_of(filter), samples, scale, detail, duration,
                                     rotation, pairs))
