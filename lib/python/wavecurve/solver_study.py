"""The study of solvers: errors and costs beside the exact solution."""
from __future__ import annotations

import json
from collections.abc import Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

from . import _native
from .dynamics import solvers as all_solvers
from .transform import all_levels

if TYPE_CHECKING:
    import pandas

__all__ = ["study", "study_points"]


def study_points(
    filters: Sequence[str] = ("db4",),
    samples: Sequence[int] = (64,),
    levels: Sequence[int] | None = None,
    shapes: Sequence[str] = ("ellipse", "star", "dent"),
    dampings: Sequence[tuple[float, float]] = ((0.0, 0.0), (0.0, 0.1), (0.0, 1.0)),
    solvers: Sequence[str] | None = None,
) -> list[dict[str, Any]]:
    """The points of the study as the command ``compare`` has them in its JSON.

    Parameters
    ----------
    filters, samples, levels, shapes, dampings, solvers
        As `study` has them.

    Returns
    -------
    list of dict
        Each with solver, filter, samples, levels, shape, damping, tolerance, error, energy_drift, model_errors, cost,
        status, reason and fingerprint.
    """
    names = [s.name for s in all_solvers() if not s.is_massless] if solvers is None else list(solvers)
    settings = [
        (filter, size, level, shape, float(s1), float(s2))
        for filter, size in product(filters, samples)
        for level in ([all_levels(size)] if levels is None else levels)
        for shape, (s1, s2) in product(shapes, dampings)
    ]
    return [json.loads(line) for line in _native.study(settings, names)]


def study(
    filters: Sequence[str] = ("db4",),
    samples: Sequence[int] = (64,),
    levels: Sequence[int] | None = None,
    shapes: Sequence[str] = ("ellipse", "star", "dent"),
    dampings: Sequence[tuple[float, float]] = ((0.0, 0.0), (0.0, 0.1), (0.0, 1.0)),
    solvers: Sequence[str] | None = None,
) -> "pandas.DataFrame":
    """Errors and costs of solvers over the product of all lists, on all cores.

    Parameters
    ----------
    filters : sequence of str
        Names, or paths of JSON files.
    samples : sequence of int
        Powers of two.
    levels : sequence of int, optional
        All of each size by default.
    shapes : sequence of str
        ellipse, star, dent, or paths of drawings; the rest shape is the unit circle.
    dampings : sequence of (s1, s2)
        The factors in ``C = s1 M + s2 K``.
    solvers : sequence of str, optional
        All that take a mass by default.

    Returns
    -------
    pandas.DataFrame
        A row for each solver at each tolerance in each setting: solver, filter, samples, levels, shape, s1, s2, tolerance,
        the errors relative to the exact solution, energy_drift, evaluations, operations, seconds (of processor time),
        status and reason.

    Raises
    ------
    ValueError
        For an unknown solver, filter or shape, sizes that do not fit.
    """
    import pandas

    rows = []
    for point in study_points(filters, samples, levels, shapes, dampings, solvers):
        row = {name: point[name] for name in ("solver", "filter", "samples", "levels", "shape")}
        row["s1"], row["s2"] = point["damping"]
        row["tolerance"] = point["tolerance"]
        row.update(point.get("error") or {})
        row["energy_drift"] = point.get("energy_drift")
        row.update(point.get("cost") or {})
        row["status"], row["reason"] = point["status"], point.get("reason")
        rows.append(row)
    return pandas.DataFrame(rows)
