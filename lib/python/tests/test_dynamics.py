"""The Lagrange system, all solvers, the study."""
import pickle

import numpy
import pytest
import scipy.linalg
import wavecurve

SAMPLES = 32
TURNS = 2 * numpy.pi * numpy.arange(SAMPLES) / SAMPLES


def displacement(system):
    shape = numpy.column_stack([0.4 * numpy.cos(TURNS) + 0.1 * numpy.sin(2 * TURNS), -0.3 * numpy.sin(TURNS)])
    return wavecurve.forward(shape, system.bank, system.levels, axis=0)


def exact(system, start, time):
    """By the exponential of the whole first-order system."""
    m, c, k = (matrix.toarray() for matrix in (system.mass(), system.damping(), system.stiffness()))
    zero, one = numpy.zeros_like(m), numpy.identity(len(m))
    generator = numpy.block([[zero, one], [-numpy.linalg.solve(m, k), -numpy.linalg.solve(m, c)]])
    state = scipy.linalg.expm(generator * time) @ numpy.vstack([start, numpy.zeros_like(start)])
    return state[: len(m)]


@pytest.mark.parametrize("name", ["db4", "bspline4.4"])
def test_the_exact_solver_is_the_matrix_exponential(name):
    system = wavecurve.LagrangeSystem(name, SAMPLES, mass_damping=0.1, stiffness_damping=0.01)
    start, times = displacement(system), [0.0, 0.3, 1.0]
    found = system.solve(start, times)
    assert found.displacement.shape == found.velocity.shape == (3, SAMPLES, 2)
    for state, time in zip(found.displacement, times):
        assert numpy.linalg.norm(state - exact(system, start, time)) < 1e-9 * numpy.linalg.norm(start)


@pytest.mark.parametrize("solver", wavecurve.solvers(), ids=lambda solver: solver.name)
def test_every_solver_runs(solver):
    system = wavecurve.LagrangeSystem("db4", SAMPLES, density=0.0 if solver.is_massless else 1.0, stiffness_damping=0.1,
                                      damping_density=1.0 if solver.is_massless else 0.0)
    start = displacement(system)
    accuracy = {"tolerance": {"tolerance": 1e-8}, "step": {"step": 1 / 2048}}.get(solver.takes, {})
    found = system.solve(start, [0.0, 0.25], solver.name, **accuracy)
    assert numpy.allclose(found.displacement[0], start, atol=1e-12)
    assert (found.evaluations > 0) == bool(accuracy)
    if "decoupled" not in solver.name:
        truth = system.solve(start, [0.25]).displacement[0]
        # Steps of 1/2048 and tolerances of 1e-8 leave less than 2 % and 1e-5 of the displacement; a wrong force or sign
        # leaves all of it.
        bound = 2e-2 if solver.takes == "step" else 1e-5
        assert numpy.linalg.norm(found.displacement[1] - truth) < bound * numpy.linalg.norm(start)
    if accuracy:
        with pytest.raises(ValueError):
            system.solve(start, [0.25], solver.name)


def test_forces_of_each_kind_agree():
    system = wavecurve.LagrangeSystem("db4", SAMPLES, mass_damping=0.5)
    start, times = displacement(system), [0.5]
    density = wavecurve.forward(numpy.tile([0.0, 9.81], (SAMPLES, 1)), system.bank, axis=0)
    uniform = system.solve(start, times, forces=[[0.0, 9.81]]).displacement
    general = system.solve(start, times, tolerance=1e-10, forces=[lambda t, x, v: numpy.tile([0.0, 9.81], (len(x), 1))])
    for other in (system.solve(start, times, forces=[density]).displacement, general.displacement,
                  system.solve(start, times, forces=[(0.0, density, 0 * density)]).displacement,
                  system.solve(start, times, forces=[density / 2, density / 2]).displacement):
        assert numpy.max(numpy.abs(other - uniform)) < 1e-7
    assert numpy.max(numpy.abs(uniform - system.solve(start, times).displacement)) > 0.1


def test_a_force_that_fails_stops_with_what_is_reached():
    def force(time, positions, velocities):
        if time > 0.5:
            raise RuntimeError("no more")
        return numpy.zeros_like(positions)

    system = wavecurve.LagrangeSystem("db4", SAMPLES)
    with pytest.raises(wavecurve.SolutionStopped, match="no more") as caught:
        system.solve(displacement(system), numpy.linspace(0, 1, 11), "coupled", tolerance=1e-6, forces=[force])
    reached = caught.value.reached
    assert 0 < len(reached.displacement) < 11 and len(reached.times) == len(reached.displacement)
    assert pickle.loads(pickle.dumps(caught.value)).args == caught.value.args


@pytest.mark.parametrize("call, error", [
    (lambda: wavecurve.LagrangeSystem("db4", 32, density=-1.0), ValueError),
    (lambda: wavecurve.LagrangeSystem("db2", 32), ArithmeticError),
    (lambda: wavecurve.LagrangeSystem("db4", 32).solve(numpy.zeros((16, 2)), [1.0]), ValueError),
    (lambda: wavecurve.LagrangeSystem("db4", 32).solve(numpy.zeros(32), [1.0, 0.5]), ValueError),
    (lambda: wavecurve.LagrangeSystem("db4", 32).solve(numpy.zeros(32), [1.0], "newton"), ValueError),
    (lambda: wavecurve.LagrangeSystem("db4", 32, density=0.0).solve(numpy.ones(32), [1.0]), ArithmeticError),
])
def test_bad_arguments_have_messages(call, error):
    with pytest.raises(error) as caught:
        call()
    assert str(caught.value)


def test_systems_are_pickled_and_show_themselves():
    system = wavecurve.LagrangeSystem("db4", 32, 3, stiffness_damping=0.1)
    again = pickle.loads(pickle.dumps(system))
    assert repr(again) == repr(system) == "LagrangeSystem('db4', 32, 3, density=1, stiffness=1, stiffness_damping=0.1)"
    assert set(system.eigenvalues()) == {"gram", "mass", "damping", "stiffness"}
    assert len(system.eigenvalues()["mass"]) == 17


def test_the_study_is_the_programs(program):
    names = ["spectral", "decoupled"]
    shown = program("compare", "--samples", 16, "--shape", "star", "--damping", "0,0", "--solvers", ",".join(names),
                    "--format", "json")["points"]
    found = wavecurve.study_points(samples=[16], shapes=["star"], dampings=[(0, 0)], solvers=names)
    for point in (*shown, *found):
        if point["cost"]:
            point["cost"].pop("seconds")  # differs from run to run
    assert found == shown
    frame = wavecurve.study(samples=[16], shapes=["star"], dampings=[(0, 0)], solvers=names)
    assert list(frame["solver"]) == [point["solver"] for point in shown]
    assert list(frame["displacement_l2_max"]) == [point["error"]["displacement_l2_max"] for point in shown]
    with pytest.raises(ValueError, match="unknown"):
        wavecurve.study(solvers=["nobody"])
