"""The motion of an elastic curve, and the solvers of its equation."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple, Union

import numpy as np
import numpy.typing as npt

from . import _native
from .filters import FilterBank, FilterLike, bank_of
from .transform import all_levels

if TYPE_CHECKING:
    import scipy.sparse

__all__ = ["LagrangeSystem", "Solver", "SolutionStopped", "Trajectory", "solvers"]

Array = npt.NDArray[np.float64]
Force = Union[npt.ArrayLike, "tuple[float, npt.ArrayLike, npt.ArrayLike]", Callable[[float, Array, Array], npt.ArrayLike]]


class Solver(NamedTuple):
    """A solver by its name, and what it takes: "tolerance", "step", or "nothing" for a closed form."""

    name: str
    summary: str
    takes: str
    is_massless: bool


def solvers() -> list[Solver]:
    """All solvers.

    Returns
    -------
    list of Solver
    """
    return [Solver(*row) for row in _native.solver_table()]


@dataclass(frozen=True)
class Trajectory:
    """States at times.

    Attributes
    ----------
    times : numpy.ndarray
    displacement, velocity : numpy.ndarray
        Times x samples x coordinates, coefficients in global-to-local order.
    evaluations, operations : int
        What it has cost: of the right-hand side, and additions and multiplications by formula.
    solver : str
    """

    times: Array
    displacement: Array
    velocity: Array
    evaluations: int
    operations: int
    solver: str

    def __repr__(self) -> str:
        return f"<Trajectory of {len(self.times)} times by {self.solver}, {self.evaluations} evaluations>"


class SolutionStopped(ArithmeticError):
    """A solver could not go on: a force that fails, a step size that vanishes, too much work.

    Attributes
    ----------
    reached : Trajectory
        The states of the times before.
    """

    def __init__(self, reason: str, reached: Trajectory) -> None:
        super().__init__(reason)
        self.reached = reached

    def __reduce__(self) -> tuple[object, ...]:
        return SolutionStopped, (self.args[0], self.reached)


class LagrangeSystem:
    """``M q'' + C q' + K q = Q`` of an elastic closed curve on the periodized multiscale basis.

    Parameters
    ----------
    filter : str, os.PathLike or FilterBank
    samples : int
        A power of two.
    levels : int, optional
        Levels of decomposition; all by default.
    density, stiffness, bending : float
        rho, e_0 and the factor of the second derivatives, per unit of the parameter interval.
    mass_damping, stiffness_damping, damping_density : float
        ``C = damping_density G + mass_damping M + stiffness_damping K``.

    Raises
    ------
    ValueError
        For a constant that is negative or not finite, and sizes that do not fit.
    ArithmeticError
        Where phi is not smooth enough for the stiffness.

    Notes
    -----
    Publication, (3.3)-(3.5). The n-th mode of an undamped free curve has the angular frequency
    ``2 pi n sqrt(stiffness / density)``.
    """

    def __init__(
        self,
        filter: FilterLike,
        samples: int,
        levels: int | None = None,
        *,
        density: float = 1.0,
        stiffness: float = 1.0,
        bending: float = 0.0,
        mass_damping: float = 0.0,
        stiffness_damping: float = 0.0,
        damping_density: float = 0.0,
    ) -> None:
        self.bank: FilterBank = bank_of(filter)
        self.samples = samples
        self.levels = all_levels(samples) if levels is None else levels
        self.material = dict(density=density, stiffness=stiffness, bending=bending, mass_damping=mass_damping,
                             stiffness_damping=stiffness_damping, damping_density=damping_density)
        self._native = _native.NativeLagrangeSystem(self.bank, samples, self.levels, **self.material)

    def __repr__(self) -> str:
        material = ", ".join(f"{name}={value:g}" for name, value in self.material.items() if value)
        return f"LagrangeSystem({self.bank.name!r}, {self.samples}, {self.levels}, {material})"

    def __reduce__(self) -> tuple[object, ...]:
        return restored_system, (self.bank, self.samples, self.levels, self.material)

    def mass(self) -> "scipy.sparse.csc_matrix":
        """M, samples x samples."""
        return self._native.mass()

    def damping(self) -> "scipy.sparse.csc_matrix":
        """C, samples x samples."""
        return self._native.damping()

    def stiffness(self) -> "scipy.sparse.csc_matrix":
        """K, samples x samples."""
        return self._native.stiffness()

    def eigenvalues(self) -> dict[str, Array]:
        """The eigenvalues on the finest level by frequency 0 .. samples / 2.

        Returns
        -------
        dict
            "gram", "mass", "damping" and "stiffness".
        """
        return self._native.eigenvalues()

    def solve(
        self,
        displacement: npt.ArrayLike,
        times: npt.ArrayLike,
        solver: str = "spectral",
        *,
        velocity: npt.ArrayLike | None = None,
        tolerance: float | None = None,
        step: float | None = None,
        forces: Sequence[Force] = (),
        rest: npt.ArrayLike | None = None,
    ) -> Trajectory:
        """The motion from an initial displacement.

        Parameters
        ----------
        displacement : array_like
            Samples x coordinates (or one coordinate), coefficients in global-to-local order.
        times : array_like
            Increasing, none negative.
        solver : str
            A name of `solvers`; "spectral" is the exact solution.
        velocity : array_like, optional
            As displacement; at rest by default.
        tolerance, step : float, optional
            How exact the solver shall be, whichever it takes.
        forces : sequence
            Each a constant density (one row for the same everywhere, else coefficients), (omega, cosine, sine) with
            coefficients, or a function of time, positions and velocities that returns the density at the sample points.
        rest : array_like, optional
            The rest shape, seen by functions.

        Returns
        -------
        Trajectory

        Raises
        ------
        ValueError
            For sizes, times or values that do not fit, an unknown solver, a missing tolerance.
        ArithmeticError
            For a massless system with singular damping.
        SolutionStopped
            Where the solver cannot go on; it has the states reached.
        """
        moments = np.atleast_1d(np.asarray(times, dtype=float))
        states = self._native.solve(solver, tolerance, step, columns(displacement),
                                    None if velocity is None else columns(velocity), moments,
                                    [made_force(force) for force in forces], None if rest is None else columns(rest))
        moved, speeds, evaluations, operations, reason = states
        reached = Trajectory(moments[: len(moved)], moved, speeds, evaluations, operations, solver)
        if reason is not None:
            raise SolutionStopped(reason, reached)
        return reached


def columns(values: npt.ArrayLike) -> Array:
    """One coordinate is a column."""
    array = np.asarray(values, dtype=float)
    return array[:, np.newaxis] if array.ndim == 1 else array


def made_force(force: Force) -> Any:
    """A force as the compiled part takes it."""
    if callable(force):
        function: Any = force

        def density(time: float, positions: Array, velocities: Array) -> Array:
            return columns(function(time, positions, velocities))
        return density
    if isinstance(force, tuple) and len(force) == 3 and np.ndim(force[0]) == 0 and np.ndim(force[1]) > 0:
        return float(force[0]), columns(force[1]), columns(force[2])
    array = np.asarray(force, dtype=float)
    return array[np.newaxis, :] if array.ndim == 1 else array


def restored_system(bank: FilterBank, samples: int, levels: int, material: dict[str, float]) -> LagrangeSystem:
    """A pickled system again."""
    return LagrangeSystem(bank, samples, levels, **material)
