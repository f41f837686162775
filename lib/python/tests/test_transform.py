"""The transform: against the matrices of the library, against PyWavelets, for any layout, on any number of threads."""
import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy
import pytest
import pywt
import wavecurve
from hypothesis import given
from hypothesis import strategies as st

NAMES = ["haar", "db4", "coif2", "bspline4.4", "cdf9.7", "rbio2.2", "sym20"]


def relative(a, b):
    return numpy.linalg.norm(a - b) / numpy.linalg.norm(b)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("levels", [0, 1, 5])
def test_inverse_is_the_synthesis_matrix(name, levels):
    s = wavecurve.synthesis_matrix(name, 32, levels)
    c = numpy.random.default_rng(1).uniform(-1, 1, 32)
    assert relative(wavecurve.inverse(c, name, levels), s @ c) < 1e-13
    transform = wavecurve.Transform(name, 32, levels)
    assert relative(transform.inverse_adjoint(c), s.T @ c) < 1e-13
    assert relative(s.T @ transform.forward_adjoint(c), c) < 1e-13


PEERS = [name for family in ("haar", "db", "sym", "coif", "bior", "rbio") for name in pywt.wavelist(family, kind="discrete")]


@pytest.mark.parametrize("name", PEERS)
def test_periodization_of_pywavelets_is_the_mapped_transform(name):
    """c'_n = c_n[x(. + s)], d'_n = sign d_{n+t}[x(. + s)] with s = 1 - F/2 - f, t = F/2 - 1 + f (docs/conventions.md)."""
    bank = wavecurve.FilterBank(name)
    size = len(bank.dec_lo)
    first = min(bank.analysis_low.first_index, bank.synthesis_low.first_index)
    s, t, sign = 1 - size // 2 - first, size // 2 - 1 + first, -1 if first % 2 else 1
    x = numpy.sin(1.0 + numpy.arange(64.0) ** 2)
    c, levels = x, 3
    theirs = pywt.wavedec(x, pywt.Wavelet("ours", filter_bank=bank), "periodization", levels)
    for detail in reversed(theirs[1:]):
        both = wavecurve.forward(numpy.roll(c, -s), bank, 1)
        c, d = both[: len(both) // 2], both[len(both) // 2 :]
        assert numpy.max(numpy.abs(sign * numpy.roll(d, -t) - detail)) < 1e-12
    assert numpy.max(numpy.abs(c - theirs[0])) < 1e-12


def test_a_level_after_the_other_is_the_whole():
    x = numpy.random.default_rng(2).uniform(-1, 1, 64)
    whole = wavecurve.forward(x, "coif2")
    by_level, coarse = x.copy(), 64
    while coarse > 1:
        by_level[:coarse] = wavecurve.forward(by_level[:coarse], "coif2", 1)
        coarse //= 2
    assert relative(by_level, whole) < 1e-13


@given(shape=st.lists(st.integers(1, 4), min_size=0, max_size=3), axis=st.integers(0, 3), exponent=st.integers(0, 6),
       name=st.sampled_from(NAMES), single=st.booleans(), order=st.sampled_from("CF"), steps=st.lists(st.sampled_from([1, 2, -1, 3]), min_size=4, max_size=4),
       seed=st.integers(0, 1000))
def test_any_layout_gives_the_same_numbers(shape, axis, exponent, name, single, order, steps, seed):
    axis = min(axis, len(shape))
    shape = [*shape[:axis], 1 << exponent, *shape[axis:]]
    whole = numpy.random.default_rng(seed).uniform(-1, 1, [size * abs(step) for size, step in zip(shape, steps)])
    whole = numpy.asarray(whole, dtype=numpy.float32 if single else numpy.float64, order=order)
    x = whole[tuple(slice(None, None, step) for step in steps[: whole.ndim])]
    before = x.copy()
    y = wavecurve.forward(x, name, axis=axis)
    assert y.dtype == x.dtype and y.shape == x.shape and numpy.array_equal(x, before)
    plain = numpy.stack([wavecurve.forward(numpy.ascontiguousarray(signal), name)
                         for signal in numpy.moveaxis(x, axis, -1).reshape(-1, 1 << exponent)])
    assert numpy.array_equal(numpy.moveaxis(y, axis, -1).reshape(-1, 1 << exponent), plain)
    # The rounding of a level is below 30 units of the precision for these filters (C++ tests prove less).
    again = wavecurve.inverse(y, name, axis=axis - x.ndim)
    unit = numpy.finfo(x.dtype).eps
    assert numpy.max(numpy.abs(again - x)) <= 200 * (exponent + 1) * unit * max(numpy.max(numpy.abs(y)), numpy.max(numpy.abs(x)))


@given(name=st.sampled_from(["db4", "coif2", "sym20"]), seed=st.integers(0, 1000))
def test_orthonormal_transforms_keep_energy_and_are_linear(name, seed):
    random = numpy.random.default_rng(seed)
    x, y = random.uniform(-1, 1, (2, 128))
    a, b = wavecurve.forward(x, name), wavecurve.forward(y, name)
    assert numpy.linalg.norm(a) == pytest.approx(numpy.linalg.norm(x), rel=1e-13)
    assert numpy.max(numpy.abs(wavecurve.forward(2 * x - y, name) - (2 * a - b))) < 1e-13


@pytest.mark.parametrize("dtype", [numpy.float64, numpy.float32])
@pytest.mark.parametrize("shape, axis", [((1000, 64), -1), ((64, 1000), 0), ((5, 64, 40), 1)])
def test_threads_give_the_same_bits(dtype, shape, axis):
    x = numpy.random.default_rng(3).uniform(-1, 1, shape).astype(dtype)
    one = wavecurve.forward(x, "db4", axis=axis)
    for threads in (2, 3, 8):
        assert numpy.array_equal(wavecurve.forward(x, "db4", axis=axis, threads=threads), one)
        assert numpy.array_equal(wavecurve.inverse(one, "db4", axis=axis, threads=threads),
                                 wavecurve.inverse(one, "db4", axis=axis))


def test_one_transform_serves_eight_threads():
    transform = wavecurve.Transform("coif2", 512)
    signals = numpy.random.default_rng(4).uniform(-1, 1, (400, 512))
    expected = [transform.forward(x) for x in signals]
    with ThreadPoolExecutor(8) as pool:
        found = list(pool.map(transform.forward, signals))
    assert all(numpy.array_equal(a, b) for a, b in zip(found, expected))


def test_out_takes_the_result():
    transform = wavecurve.Transform("db4", 64)
    x = numpy.random.default_rng(5).uniform(-1, 1, (10, 64))
    expected, out = transform.forward(x), numpy.empty((64, 10)).T
    assert transform.forward(x, out=out) is out and numpy.array_equal(out, expected)
    y = x.copy()
    assert transform.forward(y, out=y) is y
    assert relative(y, expected) < 1e-14
    for bad in (numpy.empty((10, 32)), numpy.empty((10, 64), numpy.float32), x[::-1], numpy.empty(64)):
        with pytest.raises(ValueError):
            transform.forward(x, out=bad)
    fixed = numpy.empty((10, 64))
    fixed.flags.writeable = False
    with pytest.raises(ValueError):
        transform.forward(x, out=fixed)
    long = numpy.zeros(80)
    with pytest.raises(ValueError, match="memory"):
        transform.forward(long[:64], out=long[16:])


@pytest.mark.parametrize("call", [
    lambda: wavecurve.forward(numpy.zeros(12), "db4", 3),
    lambda: wavecurve.forward(numpy.zeros(8), "db4", -1),
    lambda: wavecurve.forward(numpy.zeros(8), "db4", axis=1),
    lambda: wavecurve.forward(numpy.zeros(8), "db4", axis=-2),
    lambda: wavecurve.forward(numpy.float64(1), "db4"),
    lambda: wavecurve.forward(numpy.zeros(8), "db4", threads=0),
    lambda: wavecurve.forward(numpy.zeros(0), "db4"),
    lambda: wavecurve.Transform("db4", 8).forward(numpy.zeros(4)),
    lambda: wavecurve.Transform("db4", 0),
    lambda: wavecurve.bands(12, 3),
])
def test_bad_arguments_are_value_errors(call):
    with pytest.raises(ValueError) as caught:
        call()
    assert str(caught.value)


def test_other_types_are_taken_or_refused():
    assert wavecurve.forward([1, 2, 3, 4], "haar").dtype == numpy.float64
    swapped = numpy.arange(8, dtype=">f4")
    assert numpy.array_equal(wavecurve.forward(swapped, "db2"), wavecurve.forward(swapped.astype(numpy.float32), "db2"))
    for bad in (numpy.zeros(4, complex), ["a", "b"]):
        with pytest.raises(TypeError):
            wavecurve.forward(bad, "haar")
    assert wavecurve.forward(numpy.zeros((0, 8)), "db4").shape == (0, 8)


def test_bands_are_those_of_wavedec():
    assert wavecurve.bands(16, 2) == [slice(0, 4), slice(4, 8), slice(8, 16)]
    assert wavecurve.bands(8) == [slice(0, 1), slice(1, 2), slice(2, 4), slice(4, 8)]


def test_transforms_are_pickled():
    transform = wavecurve.Transform("cdf9.7", 32, 3)
    again = pickle.loads(pickle.dumps(transform))
    assert repr(again) == repr(transform) == "Transform('cdf9.7', 32, 3)"
    x = numpy.arange(32.0)
    assert numpy.array_equal(again.forward(x), transform.forward(x))
