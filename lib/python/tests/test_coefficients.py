"""Connection coefficients of every kind, held against the program's JSON."""
import pickle
from decimal import Decimal
from fractions import Fraction

import pytest
import wavecurve


def texts(rows):
    """(value, radius, exact) of the program's entries."""
    return [(Decimal(row["value"]), Decimal(row["radius"]),
             None if row["exact"] is None else Fraction(row["exact"])) for row in rows]


def numbers(table):
    return [(number.value, number.radius, number.exact) for number in table.values()]


@pytest.mark.parametrize("name, orders", [("db4", (1, 1)), ("coif2", (0, 1)), ("bspline4.4", (2, 2)), ("db3", (0, 0))])
@pytest.mark.parametrize("normalize", [False, True])
def test_coefficients_are_the_programs(program, name, orders, normalize):
    if normalize and sum(orders) % 2:
        with pytest.raises(ValueError):
            wavecurve.coefficients(name, orders, normalize=True)
        return
    shown = program("coefficients", name, "--derivatives", "{},{}".format(*orders), "--digits", 30, "--format", "json",
                    "--normalize", "first" if normalize else "none")
    found = wavecurve.coefficients(name, orders, digits=30, normalize=normalize)
    assert (found.filter, found.derivatives) == (shown["filter"], tuple(shown["derivatives"]))
    for sequence in ("alpha", "mu", "nu"):
        assert numbers(getattr(found, sequence)) == texts(shown[sequence])
        assert list(getattr(found, sequence)) == [row["index"] for row in shown[sequence]]


def indices(entries):
    return [entry["indices"][0] if len(entry["indices"]) == 1 else tuple(entry["indices"]) for entry in entries]


@pytest.mark.parametrize("arguments, keywords", [
    (["phi phi'(l)"], {}),
    (["phi' phi(l) phi(m)"], {}),
    (["phi(k) phi'(l)", "--on", "0,1"], {"on": (0, 1)}),
    (["phi psi(2x - l)", "--on", "0,1/2"], {"on": "0,1/2"}),
    (["phi phi'(l)", "--period", "4"], {"period": 4}),
    (["x phi~ phi(l)"], {}),
])
def test_integrals_are_the_programs(program, arguments, keywords):
    shown = program("coefficients", "db3", "--integral", *arguments, "--digits", 12, "--format", "json")
    found = wavecurve.integrals("db3", arguments[0], digits=12, **keywords)
    assert numbers(found) == texts(shown["entries"]) and list(found) == indices(shown["entries"])


@pytest.mark.parametrize("operator", ["hilbert", "fractional:1/2", "fractional:-0.5", "derivative:1", "fractional:1", "riesz:1/2",
                                      "hilbert:2"])
def test_operators_are_the_programs(program, operator):
    shown = program("coefficients", "db3", "--operator", operator, "--up-to", 3, "--digits", 10, "--format", "json")
    found = wavecurve.operator_coefficients("db3", operator, up_to=3, digits=10)
    assert numbers(found) == texts(shown["entries"]) and list(found) == indices(shown["entries"])


@pytest.mark.parametrize("name", ["db3", "bspline2.2"])
def test_moments_and_quadrature_are_the_programs(program, name):
    shown = program("coefficients", name, "--moments", 3, "--digits", 20, "--format", "json")["entries"]
    of = {}
    for entry in shown:
        of.setdefault(entry["quantity"], []).append(entry)
    for quantity, entries in of.items():
        if quantity.startswith("moment"):
            table = wavecurve.moments(name, 3, wavelet="psi" in quantity, dual="~" in quantity, digits=20)
        elif quantity.startswith("reproduction"):
            table = wavecurve.reproduction(name, digits=20)
        else:
            table = wavecurve.quadrature(name, len(entries), first=entries[0]["indices"][0], digits=20)
        assert numbers(table) == texts(entries), quantity
        assert list(table) == indices(entries)


@pytest.mark.parametrize("quantity", ["h*sqrt2", "mu/first", "int(phi, phi')", "sobolev(phi)", "int(phi, phi, phi)"])
def test_quantities_are_the_programs(program, quantity):
    shown = program("coefficients", "db3", "--quantity", quantity, "--digits", 15, "--format", "json")
    found = wavecurve.quantity("db3", quantity, digits=15)
    assert found.name == shown["quantity"] and numbers(found) == texts(shown["entries"])


def test_dyadic_points_are_fractions():
    assert list(wavecurve.quantity("db2", "phi", level=1))[0] == Fraction(1, 2)


def test_exact_values_are_fractions():
    mu = wavecurve.coefficients("db3", digits=50).mu
    assert mu[0].exact == Fraction(295, 56)
    for number in mu.values():
        assert abs(Fraction(number.value) - number.exact) <= Fraction(number.radius)
    assert wavecurve.coefficients("coif2", digits=20).mu[0].exact is None


def test_long_fractions_are_exact_and_shown():
    from wavecurve import numbers as made

    long = made.made_number(("0", "0", f"-1/3{'0' * 5000}"))
    assert long.exact == Fraction(-1, 3 * 10**5000) and str(long).endswith("0" * 5000)


def test_more_digits_lie_within_the_enclosure():
    for few, many in zip(wavecurve.coefficients("coif2", digits=8).nu.values(),
                         wavecurve.coefficients("coif2", digits=40).nu.values()):
        middle, radius = few.enclosure
        assert abs(many.value - middle) <= radius + many.radius


def test_names_are_not_taken_for_exponents():
    taps = ["0.4829629131", "0.8365163037", "0.2241438680", "-0.1294095226"]
    bank = wavecurve.FilterBank.from_taps(taps, name="Sobolev exponent is " + "1" * 180)
    with pytest.raises(ArithmeticError) as caught:
        wavecurve.coefficients(bank)
    assert (caught.value.found, caught.value.needed) == (1.0, 1.0)


def test_missing_smoothness_tells_both_exponents():
    with pytest.raises(ArithmeticError, match=r"Sobolev exponent is 1\.000, but it must exceed 1\.0") as caught:
        wavecurve.coefficients("D4")
    assert not isinstance(caught.value, ValueError)
    assert (caught.value.found, caught.value.needed) == (1.0, 1.0)
    with pytest.raises(ArithmeticError, match="must exceed"):
        wavecurve.integrals("db2", "phi' phi'(l)")


@pytest.mark.parametrize("call", [
    lambda: wavecurve.coefficients("db4", digits=0),
    lambda: wavecurve.coefficients("db4", digits=10**9),
    lambda: wavecurve.moments("db4", digits=10**9),
    lambda: wavecurve.FilterBank("db4").decimals(digits=10**9),
    lambda: wavecurve.coefficients("db4", (9, 0)),
    lambda: wavecurve.integrals("db4", "phi nonsense"),
    lambda: wavecurve.integrals("db4", "phi phi(l)", on="1,0"),
    lambda: wavecurve.integrals("db4", "phi phi(l)", period=0),
    lambda: wavecurve.operator_coefficients("db4", "laplace"),
    lambda: wavecurve.operator_coefficients("db4", "fractional:x"),
    lambda: wavecurve.operator_coefficients("db4", "derivative:9"),
    lambda: wavecurve.operator_coefficients("db4", "hilbert", up_to=-1),
    lambda: wavecurve.moments("db4", -1),
    lambda: wavecurve.quadrature("db4", 0),
    lambda: wavecurve.quantity("db4", "what"),
])
def test_bad_arguments_are_value_errors(call):
    with pytest.raises(ValueError) as caught:
        call()
    assert str(caught.value)


def test_numbers_are_pickled():
    found = wavecurve.coefficients("db3", digits=10)
    assert pickle.loads(pickle.dumps(found)) == found


def test_tables_show_themselves():
    mu = wavecurve.coefficients("db3", digits=10).mu
    assert repr(mu) == "<NumberTable mu of db3, 5 numbers>"
    assert "295/56" in str(mu) and "295/56" in mu._repr_html_()
    frame = mu.to_frame()
    assert list(frame.columns) == ["value", "radius", "exact", "float"] and frame["exact"][0] == Fraction(295, 56)
    assert list(mu.floats()) == [float(number) for number in mu.values()]
    pairs = wavecurve.integrals("db2", "phi phi(l) phi(m)", digits=5).to_frame()
    assert pairs.index[0] == (-2, -2)
