"""The transform from Python beside pywt.wavedec(mode="periodization"): seconds of one call.

usage: PYTHONPATH=build/release/python /usr/bin/python3 benchmarks/peers/transform_python.py [FILTER]
All levels, float64. Times are processor time of one thread, and of the batch on all cores, time on the wall; the minimum of
the runs that fit into two seconds, both sides by turns.
The overhead of a call is the time of the transform of 2 samples by one level, Python's own loop taken off.
"""

import os
import sys
import time
import warnings

import numpy
import pywt
import wavecurve

warnings.simplefilter("ignore")  # more levels than the filter's length recommends


def best_of(functions, clock=time.process_time, seconds=2.0):
    """The least seconds of a call of each."""
    calls = []
    for function in functions:
        start = clock()
        function()
        calls.append(max(1, int(1e-3 / (clock() - start + 1e-6))))
    best = [float("inf")] * len(functions)
    end, runs = time.perf_counter() + seconds, 0
    while time.perf_counter() < end or runs < 3:
        runs += 1
        for i, function in enumerate(functions):
            start = clock()
            for _ in range(calls[i]):
                function()
            best[i] = min(best[i], (clock() - start) / calls[i])
    return best


def main():
    name = sys.argv[1] if len(sys.argv) > 1 else "db4"
    wavelet, random = pywt.Wavelet(name), numpy.random.default_rng(1)
    print(f"{name}, numpy {numpy.__version__}, PyWavelets {pywt.__version__}, {os.cpu_count()} cores")
    print(f"{'signals':>20} {'pywt.wavedec':>14} {'forward()':>12} {'times':>6} {'Transform':>12} {'times':>6}")
    for shape in ((1 << 8,), (1 << 14,), (1 << 20,), (10_000, 256)):
        x, levels = random.uniform(-1, 1, shape), shape[-1].bit_length() - 1
        transform, cores = wavecurve.Transform(name, shape[-1]), os.cpu_count()
        functions = [lambda: pywt.wavedec(x, wavelet, "periodization", levels, axis=-1),
                     lambda: wavecurve.forward(x, name), lambda: transform.forward(x)]
        theirs, *ours = best_of(functions)
        cells = " ".join(f"{seconds:12.3e} {theirs / seconds:6.1f}" for seconds in ours)
        print(f"{' x '.join(map(str, shape)):>20} {theirs:14.3e} {cells}")
        if len(shape) > 1:
            theirs, ours = best_of([functions[0], lambda: wavecurve.forward(x, name, threads=cores)], time.perf_counter)
            print(f"{'on all cores':>20} {theirs:14.3e} {ours:12.3e} {theirs / ours:6.1f}")
    x, transform = numpy.zeros(2), wavecurve.Transform("haar", 2)
    nothing, method, function = best_of([lambda: None, lambda: transform.forward(x), lambda: wavecurve.forward(x, "haar")])
    print(f"overhead of a call: {1e6 * (method - nothing):.2f} us (Transform.forward), {1e6 * (function - nothing):.2f} us (forward)")


if __name__ == "__main__":
    main()
