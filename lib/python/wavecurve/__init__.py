"""Certified wavelet numerics: each number with its proof.

Filter banks, connection coefficients to any number of proved digits, checks of published tables, the periodic wavelet
transform, stiffness operators, the motion of elastic curves, descriptors and morphs of drawings.

Where to start: `FilterBank`, `coefficients`, `integrals`, `check`, `identify`, `forward` and `Transform`, `stiffness`,
`LagrangeSystem`, `schulz_inverse`, `study`, `describe`, `morph`. Charts are in `wavecurve.charts` (matplotlib).

Bad arguments raise ValueError, numbers that do not exist ArithmeticError with the exponent found and the one needed, files
OSError. Long calls release the GIL and answer Ctrl-C; an interrupted computation ends in the background.
"""
from pathlib import Path as _Path

from . import _native
from .connection import (Coefficients, coefficients, integrals, moments, operator_coefficients, quadrature, quantity,
                         reproduction)
from .curves import (Curve, ShapeDistance, count_crossings, elliptic_fourier_distance, normalized_contour, sample_contour,
                     shape_distance, to_coefficients, to_samples)
from .drawings import ContourDescriptor, Descriptor, Drawing, LayerDescriptor, describe, read_drawing
from .dynamics import LagrangeSystem, SolutionStopped, Solver, Trajectory, solvers
from .filters import FilterBank, Taps, filter_aliases, filter_names
from .morphs import Animation, FrameLayer, Morph, morph
from .number_lists import IdentifiedList, Match, identify
from .numbers import Number, NumberTable
from .operators import (SchulzInverse, damping, differentiation_matrix, extreme_eigenvalues, gram, linear_operator,
                        multiscale_matrix, nonstandard_matrix, schulz_inverse, stiffness, synthesis_matrix, vibration_eigenvalues)
from .solver_study import study, study_points
from .tables import CheckedColumn, CheckedRow, CheckedTable, check
from .transform import Transform, bands, forward, inverse

__version__ = _native.version

__all__ = [
    "Animation", "CheckedColumn", "CheckedRow", "CheckedTable", "Coefficients", "ContourDescriptor", "Curve", "Descriptor",
    "Drawing", "FilterBank", "FrameLayer", "IdentifiedList", "LagrangeSystem", "LayerDescriptor", "Match", "Morph", "Number",
    "NumberTable", "SchulzInverse", "ShapeDistance", "SolutionStopped", "Solver", "Taps", "Trajectory", "Transform", "bands",
    "check", "coefficients", "count_crossings", "damping", "data_folder", "describe", "differentiation_matrix", "elliptic_fourier_distance",
    "extreme_eigenvalues", "filter_aliases", "filter_names", "forward", "gram", "identify", "integrals", "inverse",
    "linear_operator", "moments", "morph", "multiscale_matrix", "nonstandard_matrix", "normalized_contour", "operator_coefficients", "quadrature",
    "quantity", "read_drawing", "reproduction", "sample_contour", "schulz_inverse", "shape_distance", "solvers", "stiffness",
    "study", "study_points", "synthesis_matrix", "to_coefficients", "to_samples", "vibration_eigenvalues",
]

#: Published tables (``published``) and drawings to try (``examples``).
data_folder: _Path = _Path(__file__).parent / "data"

_native.use_data_folder(data_folder)
