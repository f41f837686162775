"""Morphs of drawings, linear and as the motion of elastic curves."""
from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _native
from .drawings import Drawing, PathText
from .filters import FilterLike, bank_of

__all__ = ["Animation", "FrameLayer", "Morph", "morph"]

Array = npt.NDArray[np.float64]


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

    def write(self, path: PathText, *, frames: int = 60, tolerance: float | None = None, loop: bool = False, pixels: int = 512) -> None:
        """Write a file; its extension selects the format, as with ``wavecurve morph``: .svg, .json (Lottie), .html, .gif and others.

        Parameters
        ----------
        path : path
        frames : int
        tolerance : float, optional
            Maximum distance of the fitted cubics from the contour, in drawing units; a tenth of a pixel without it, 0
            writes polygons.
        loop : bool
            Play for ever.
        pixels : int
            The longer side of a rendered frame.

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

    def write(self, path: PathText, *, frames: int = 60, tolerance: float | None = None, loop: bool = False, pixels: int = 512) -> None:
        """Write the linear morph, as `Animation.write`; an .html lets the viewer choose the scale."""
        self._native.write(Path(path), frames, tolerance, loop, pixels)


def morph(
    source: Drawing | PathText,
    destination: Drawing | PathText,
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
