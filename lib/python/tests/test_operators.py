"""Matrices, operators, Schulz's inverse."""
import re

import numpy
import pytest
import scipy.io
import scipy.sparse
import scipy.sparse.linalg
import wavecurve


@pytest.mark.parametrize("name, levels", [("db4", 6), ("coif2", 2), ("bspline4.4", 0)])
def test_stiffness_is_the_programs(program, tmp_path, name, levels):
    file = tmp_path / "k.mtx"
    text = program("stiffness", name, "--samples", 64, "--levels", levels, "--output", file, text=True)
    k = wavecurve.stiffness(name, 64, levels)
    assert scipy.sparse.issparse(k) and (abs(k - scipy.io.mmread(file)) > 0).nnz == 0
    smallest, largest = wavecurve.extreme_eigenvalues(name, 64, levels)
    shown = dict(re.findall(r"^(smallest non-zero eigenvalue|largest eigenvalue) +([\d.e+]+)", text, re.M))
    # The program prints 8 significant digits; eigenvalues are found to 1e-6, mostly to 1e-10.
    assert smallest == pytest.approx(float(shown["smallest non-zero eigenvalue"]), rel=1e-7)
    assert largest == pytest.approx(float(shown["largest eigenvalue"]), rel=1e-7)


@pytest.mark.parametrize("derivatives", [(0, 0), (1, 1), (0, 1), (2, 2)])
def test_the_operator_is_the_matrix(derivatives):
    matrix = wavecurve.multiscale_matrix("bspline4.4", 64, 4, derivatives)
    operator = wavecurve.linear_operator("bspline4.4", 64, 4, derivatives)
    assert isinstance(operator, scipy.sparse.linalg.LinearOperator)
    x = numpy.random.default_rng(1).uniform(-1, 1, (64, 3))
    scale = abs(matrix).max()
    assert numpy.max(numpy.abs(operator @ x - matrix @ x)) < 1e-12 * scale
    assert numpy.max(numpy.abs(operator.H @ x[:, 0] - matrix.T @ x[:, 0])) < 1e-12 * scale


@pytest.mark.parametrize("form", ["galerkin", "collocation", "nonstandard"])
def test_derivatives_are_the_programs(form, program, tmp_path):
    file = tmp_path / "d.mtx"
    program("matrix", "db4", "--samples", 32, "--form", form, "--output", file, text=True)
    found = (wavecurve.nonstandard_matrix("db4", 32) if form == "nonstandard"
             else wavecurve.differentiation_matrix("db4", 32, collocation=form == "collocation"))
    assert scipy.sparse.issparse(found) and (abs(found - scipy.io.mmread(file)) > 0).nnz == 0


def test_scipy_solves_with_the_operator():
    operator, gram = wavecurve.linear_operator("db4", 256), wavecurve.gram("db4", 256)
    assert (gram != scipy.sparse.identity(256)).nnz == 0
    shifted = operator + scipy.sparse.linalg.aslinearoperator(gram)
    b = numpy.random.default_rng(2).uniform(-1, 1, 256)
    # Its tolerance is 1e-5 by default; the argument's name is another since scipy 1.14.
    x, failed = scipy.sparse.linalg.cg(shifted, b, maxiter=5000)
    assert failed == 0 and numpy.linalg.norm(shifted @ x - b) < 1.1e-5 * numpy.linalg.norm(b)


def test_damping_is_composed():
    m, k = wavecurve.gram("cdf9.7", 32), wavecurve.stiffness("cdf9.7", 32)
    c = wavecurve.damping("cdf9.7", 32, s1=0.5, s2=0.25)
    assert abs(c - (0.5 * m + 0.25 * k)).max() < 1e-12 * abs(k).max()


def test_vibrations_tend_to_those_of_a_string():
    found = wavecurve.vibration_eigenvalues("coif2", 256)
    assert found[1] == pytest.approx((2 * numpy.pi) ** 2, rel=1e-8)


def test_schulz_inverts():
    c = wavecurve.damping("db4", 64, s1=1, s2=1e-3)
    for matrix in (c.toarray(), c, c.tocsr()):
        found = wavecurve.schulz_inverse(matrix, 1e-9)
        inverse = found.inverse.toarray() if scipy.sparse.issparse(found.inverse) else found.inverse
        assert found.status == "converged" and found.residuals[-1] <= 1e-9
        # The bound, and the rounding of numpy's own inverse: condition number times the unit.
        exact = numpy.linalg.inv(c.toarray())
        allowed = found.error_bound + 64 * numpy.linalg.cond(c.toarray()) * 2.3e-16 * numpy.linalg.norm(exact)
        assert numpy.linalg.norm(inverse - exact) <= allowed
        assert repr(found).startswith("<SchulzInverse converged")


def test_schulz_tells_of_a_singular_matrix():
    assert wavecurve.schulz_inverse(wavecurve.stiffness("db4", 16).toarray()).status == "singular"
    for bad in (numpy.zeros((2, 3)), numpy.zeros((0, 0)), [[numpy.nan]]):
        with pytest.raises(ValueError):
            wavecurve.schulz_inverse(bad)


@pytest.mark.parametrize("call, error", [
    (lambda: wavecurve.stiffness("db2", 16), ArithmeticError),
    (lambda: wavecurve.stiffness("db4", 12), ValueError),
    (lambda: wavecurve.stiffness("db4", 16, 5), ValueError),
    (lambda: wavecurve.multiscale_matrix("db4", 16, 2, (9, 0)), ValueError),
    (lambda: wavecurve.differentiation_matrix("db4", 0), ValueError),
    (lambda: wavecurve.differentiation_matrix("haar", 8), ArithmeticError),
    (lambda: wavecurve.nonstandard_matrix("cdf9.7", 16), ValueError),
    (lambda: wavecurve.linear_operator("db4", 16) @ numpy.zeros(8), ValueError),
    (lambda: wavecurve.extreme_eigenvalues("db4", 16, 2, 7), ValueError),
])
def test_bad_arguments_have_messages(call, error):
    with pytest.raises(error) as caught:
        call()
    assert str(caught.value)
