"""The charts of the report, by matplotlib, which is imported when one is drawn."""
from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from .drawings import Descriptor
from .filters import FilterLike, bank_of
from .numbers import NumberTable
from .operators import SchulzInverse
from .tables import COLOURS, CheckedTable

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

__all__ = ["plot_checked", "plot_contours", "plot_filter", "plot_matrix", "plot_numbers", "plot_schulz", "plot_study"]

#: The order and style of lines: told apart in grey as well.
STYLES = ["o-", "s--", "^-.", "v:", "D-", "x--", "P-.", "*:"]


def axes_or_new(axes: "Axes | None") -> "Axes":
    """The axes given, or those of a new figure."""
    if axes is not None:
        return axes
    from matplotlib import pyplot

    return pyplot.subplots(layout="constrained")[1]


def plot_filter(filter: FilterLike, axes: "Axes | None" = None) -> "Axes":
    """The taps of the four filters by their index.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    axes : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes
    """
    axes, bank = axes_or_new(axes), bank_of(filter)
    for style, which in zip(STYLES, ("analysis_low", "analysis_high", "synthesis_low", "synthesis_high")):
        first, taps = bank._one(which)
        axes.plot(np.arange(first, first + len(taps)), taps, style, label=which.replace("_", " "))
    axes.set(xlabel="$n$", ylabel="tap", title=bank.name)
    axes.legend()
    return axes


def plot_numbers(table: NumberTable, axes: "Axes | None" = None) -> "Axes":
    """The numbers of a table by their index, which must be one number.

    Parameters
    ----------
    table : NumberTable
    axes : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes
    """
    axes = axes_or_new(axes)
    axes.stem([float(index) for index in table], table.floats())  # type: ignore[arg-type]
    axes.set(xlabel="index", title=f"{table.name} of {table.filter}")
    return axes


def plot_checked(table: CheckedTable, axes: "Axes | None" = None) -> "Axes":
    """How many numbers have each verdict.

    Parameters
    ----------
    table : CheckedTable
    axes : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes
    """
    axes = axes_or_new(axes)
    verdicts = list(table.counts)
    bars = axes.barh(verdicts, [table.counts[v] for v in verdicts], color=[COLOURS.get(v, "grey") for v in verdicts])
    axes.bar_label(bars, padding=3)
    axes.invert_yaxis()
    axes.set(xlabel="numbers", title=table.title or "checked table")
    return axes


def plot_matrix(matrix: Any, axes: "Axes | None" = None) -> "Axes":
    """Magnitudes of a matrix on a logarithmic grey scale, 12 decades at most.

    Parameters
    ----------
    matrix : array_like or scipy sparse matrix
    axes : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes
    """
    from matplotlib.colors import LogNorm

    axes = axes_or_new(axes)
    sizes = np.abs(matrix.toarray() if hasattr(matrix, "toarray") else np.asarray(matrix))
    largest = sizes.max() or 1.0
    shown = np.where(sizes > largest * 1e-12, sizes, np.nan)
    image = axes.imshow(shown, cmap="Greys", norm=LogNorm(largest * 1e-12, largest), interpolation="nearest")
    axes.figure.colorbar(image, ax=axes, label="magnitude of the entry")
    axes.set(xlabel="column", ylabel="row")
    return axes


def plot_schulz(inverse: SchulzInverse, axes: "Axes | None" = None) -> "Axes":
    """The residuals of Schulz's iteration by step.

    Parameters
    ----------
    inverse : SchulzInverse
    axes : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes
    """
    axes = axes_or_new(axes)
    axes.semilogy(inverse.residuals, "o-")
    axes.set(xlabel="step $n$", ylabel=r"$\|I - X_n C\|_F$", title=inverse.status)
    return axes


def plot_study(study: "pandas.DataFrame", error: str = "displacement_l2_max", axes: "Axes | None" = None) -> "Axes":
    """Work against precision of each solver, of a study with one setting.

    Parameters
    ----------
    study : pandas.DataFrame
        What `study` returns.
    error : str
        A column of errors.
    axes : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes
    """
    axes = axes_or_new(axes)
    for place, (name, points) in enumerate(study[study["status"] == "ok"].groupby("solver", sort=False)):
        axes.loglog(points["evaluations"], points[error], STYLES[place % len(STYLES)], label=name)
    axes.set(xlabel="evaluations", ylabel=error.replace("_", " "))
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    return axes


def plot_contours(contours: "Iterable[Any] | Descriptor", axes: "Axes | None" = None) -> "Axes":
    """Closed contours, y down, in one scale for both axes.

    Parameters
    ----------
    contours : iterable of array_like, or Descriptor
        n x 2 each.
    axes : matplotlib.axes.Axes, optional

    Returns
    -------
    matplotlib.axes.Axes
    """
    axes = axes_or_new(axes)
    if isinstance(contours, Descriptor):
        contours = [points for place in range(len(contours.layers)) for points in contours.reconstruct(place)]
    for points in contours:
        closed = np.vstack([points, points[:1]])
        axes.plot(closed[:, 0], closed[:, 1], "k-", linewidth=1)
    axes.set_aspect("equal")
    if not axes.yaxis_inverted():
        axes.invert_yaxis()
    return axes
