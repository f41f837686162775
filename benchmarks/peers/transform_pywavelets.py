"""PyWavelets beside transform_benchmark: seconds a sample of processor time, D8, double, all levels.

core: pywt's compiled dwt on arrays, one level after another, periodized; what a user would call is
wavedec and waverec. With Debian's own python3. First, as transform_benchmark does for its own, the
round trip of every family that PyWavelets has. With arguments NAME SAMPLES, NAME one of dwt, idwt,
wavedec and waverec, only the seconds that one such transform takes.
"""

import sys
import time

import numpy
import pywt

# Named here, since the tables' wavelet of 8 taps is found by its name once and not in the loop.
WAVELET = pywt.Wavelet("db4")
MODE = "periodization"


def core_forward(signal, levels):
    details = []
    for _ in range(levels):
        signal, detail = pywt.dwt(signal, WAVELET, MODE)
        details.append(detail)
    return signal, details


def core_inverse(signal, details):
    for detail in reversed(details):
        signal = pywt.idwt(signal, detail, WAVELET, MODE)
    return signal


def units_per_level(name, samples=256, levels=8, sequences=8):
    """|inverse(forward(x)) - x| / |x| in units of 2^-52 a level, the largest of the sequences."""
    random = numpy.random.default_rng(1)
    worst = 0.0
    for _ in range(sequences):
        signal = random.uniform(-1, 1, samples)
        again = pywt.waverec(pywt.wavedec(signal, name, MODE, levels), name, MODE)
        worst = max(worst, numpy.linalg.norm(again - signal) / numpy.linalg.norm(signal))
    return worst * 2**52 / levels


def print_round_trips():
    print("round trip, units of 2^-52 a level")
    for family in ("haar", "db", "sym", "coif", "bior"):
        for name in pywt.wavelist(family, kind="discrete"):
            print(f"{name:12} {units_per_level(name):10.2g}")


def nanoseconds(function, samples, runs=9):
    """The fastest of several runs."""
    repetitions = max(1, (1 << 18) // samples)
    best = float("inf")
    for _ in range(runs):
        start = time.process_time_ns()
        for _ in range(repetitions):
            function()
        best = min(best, (time.process_time_ns() - start) / repetitions / samples)
    return best


def transforms(samples):
    """What is measured, by name."""
    levels = samples.bit_length() - 1
    signal = numpy.random.default_rng(1).uniform(-1, 1, samples)
    coarse, details = core_forward(signal, levels)
    coefficients = [coarse, *reversed(details)]
    return {
        "dwt": lambda: core_forward(signal, levels),
        "idwt": lambda: core_inverse(coarse, details),
        "wavedec": lambda: pywt.wavedec(signal, WAVELET, MODE, levels),
        "waverec": lambda: pywt.waverec(coefficients, WAVELET, MODE),
    }


def main():
    if len(sys.argv) == 3:
        samples = int(sys.argv[2])
        print(nanoseconds(transforms(samples)[sys.argv[1]], samples, 3) * samples * 1e-9)
        return
    print_round_trips()
    print(f"{'samples':>8} {'dwt':>8} {'idwt':>8} {'wavedec':>8} {'waverec':>8}   ns a sample")
    for exponent in (8, 10, 12, 14, 16, 18, 20, 22):
        samples = 1 << exponent
        figures = [nanoseconds(run, samples) for run in transforms(samples).values()]
        print(f"{samples:8d} " + " ".join(f"{figure:8.3f}" for figure in figures))


if __name__ == "__main__":
    import warnings

    warnings.simplefilter("ignore")  # more levels than the filter's length recommends
    main()
