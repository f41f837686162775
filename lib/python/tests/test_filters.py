"""Filter banks, in the library's order and in PyWavelets'."""
import pickle
from decimal import Decimal
from fractions import Fraction

import numpy
import pytest
import pywt
import wavecurve

PEERS = [name for family in ("haar", "db", "sym", "coif", "bior", "rbio") for name in pywt.wavelist(family, kind="discrete")]


def known_deviation(name):
    """How far PyWavelets' own tables lie from the correctly rounded values (docs/conventions.md): half a unit of the last
    decimal that is right."""
    if name.startswith("sym"):
        return 0.5e-10
    if name[4:] in ("4.4", "5.5", "6.8"):
        return 0.5e-11
    return 2.0**-53 if name.startswith("coif") else 0


@pytest.mark.parametrize("name", PEERS)
def test_tables_are_those_of_pywavelets(name):
    peer, bank = pywt.Wavelet(name), wavecurve.FilterBank(name)
    for ours, theirs in zip(bank.filter_bank, peer.filter_bank):
        assert len(ours) == len(theirs)
        assert numpy.max(numpy.abs(numpy.subtract(ours, theirs))) <= known_deviation(name)


@pytest.mark.parametrize("name", ["db4", "coif2", "bspline4.4", "cdf9.7", "rbio2.4"])
def test_a_bank_is_a_wavelet_of_pywavelets(name):
    wavelet = pywt.Wavelet("ours", filter_bank=wavecurve.FilterBank(name))
    x = numpy.sin(numpy.arange(64.0) ** 2)
    again = pywt.waverec(pywt.wavedec(x, wavelet, "periodization", 3), wavelet, "periodization")
    assert numpy.max(numpy.abs(again - x)) < 1e-12


@pytest.mark.parametrize("name", ["db4", "coif2", "bspline4.4", "cdf9.7", "sym10"])
def test_taps_are_the_programs(program, name):
    shown, bank = program("filter", name, "--format", "json", "--digits", 25), wavecurve.FilterBank(name)
    assert shown["filter"] == bank.name
    for which in ("analysis_low", "analysis_high", "synthesis_low", "synthesis_high"):
        filter = shown[which]
        first = filter["first_index"]
        texts = filter["taps"]
        first_index, taps = getattr(bank, which)
        assert first_index == first
        assert [float(text) for text in texts] == pytest.approx(list(taps), rel=0, abs=2e-16)
        decimals = bank.decimals(which, 25)
        assert [number.value for number in decimals.values()] == [Decimal(text) for text in texts]
        assert list(decimals) == list(range(first, first + len(texts)))


def test_aliases_name_the_same_bank():
    assert wavecurve.FilterBank("D8").name == "db4"
    assert wavecurve.filter_aliases()["D8"] == "db4"
    assert wavecurve.FilterBank("D8") != wavecurve.FilterBank("db5")
    assert "coif2" in wavecurve.filter_names()


def test_own_taps_are_a_bank():
    haar = wavecurve.FilterBank.from_taps([1, 1], sum="2", name="mine")
    assert haar.name == "mine" and haar.is_orthonormal
    assert haar.synthesis_low.taps == pytest.approx([0.5**0.5] * 2, abs=1e-16)
    spline = wavecurve.FilterBank.from_taps(
        [Fraction(1, 2), 1, Fraction(1, 2)], first_index=-1, sum="2",
        analysis=["-0.25", "0.5", "1.5", "0.5", "-0.25"], analysis_first_index=-2)
    assert spline.filter_bank == wavecurve.FilterBank("bior2.2").filter_bank
    with pytest.raises(ValueError, match="taps"):
        wavecurve.FilterBank.from_taps([1, 2, 3])
    with pytest.raises(ValueError, match="characters of the filter's name is 5000"):
        wavecurve.FilterBank.from_taps([1, 1], sum="2", name="n" * 5000)


def test_unknown_names_are_refused_with_what_is_known():
    with pytest.raises(ValueError, match="nonsense"):
        wavecurve.FilterBank("nonsense")
    with pytest.raises(ValueError, match="fk8"):
        wavecurve.FilterBank("fk8")
    with pytest.raises(ValueError, match="missing.json"):
        wavecurve.FilterBank("missing.json")
    with pytest.raises(ValueError, match="which"):
        wavecurve.FilterBank("db2").decimals("which", 10)


@pytest.mark.parametrize("bank", [wavecurve.FilterBank("coif2"), wavecurve.FilterBank.from_taps(["1", "1"], sum="2")])
def test_banks_are_pickled(bank):
    again = pickle.loads(pickle.dumps(bank))
    assert again == bank and again.filter_bank == bank.filter_bank


def test_representations_help():
    bank = wavecurve.FilterBank("db2")
    assert repr(bank) == "FilterBank('db2')"
    assert "db2" in bank._repr_html_() and "0.482963" in bank._repr_html_()
