"""PyWavelets beside transform_benchmark: seconds a sample of processor time, D8, double, all levels.

core: pywt's compiled dwt on arrays, one level after another, periodized; what a user would call is
wavedec and waverec. Start it right after transform_benchmark, with Debian's own python3.
"""

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


def nanoseconds(function, samples):
    """The fastest of several runs."""
    repetitions = max(1, (1 << 18) // samples)
    best = float("inf")
    for _ in range(9):
        start = time.process_time_ns()
        for _ in range(repetitions):
            function()
        best = min(best, (time.process_time_ns() - start) / repetitions / samples)
    return best


def main():
    print(f"{'samples':>8} {'dwt':>8} {'idwt':>8} {'wavedec':>8} {'waverec':>8}   ns a sample")
    for exponent in (8, 10, 12, 14, 16, 18, 20, 22):
        samples = 1 << exponent
        signal = numpy.random.default_rng(1).uniform(-1, 1, samples)
        coarse, details = core_forward(signal, exponent)
        coefficients = [coarse, *reversed(details)]
        figures = [
            nanoseconds(lambda: core_forward(signal, exponent), samples),
            nanoseconds(lambda: core_inverse(coarse, details), samples),
            nanoseconds(lambda: pywt.wavedec(signal, WAVELET, MODE, exponent), samples),
            nanoseconds(lambda: pywt.waverec(coefficients, WAVELET, MODE), samples),
        ]
        print(f"{samples:8d} " + " ".join(f"{figure:8.3f}" for figure in figures))


if __name__ == "__main__":
    import warnings

    warnings.simplefilter("ignore")  # more levels than the filter's length recommends
    main()
