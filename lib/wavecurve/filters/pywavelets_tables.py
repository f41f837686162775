"""Prints what PyWavelets holds and computes, as JSON, for conventions_test.cpp.

For each filter: the four tables in PyWavelets' own order, and the periodized transform
[cA_J, cD_J, ..., cD_1] of one signal. Every number is printed so that it reads back bit for bit.
"""

import json
import random
import warnings

import pywt

SAMPLES = 128
LEVELS = 3

names = [f"db{n}" for n in range(1, 39)]
names += [f"sym{n}" for n in range(2, 21)]
names += [name for name in pywt.wavelist("coif")]
names += pywt.wavelist("bior") + pywt.wavelist("rbio")

generator = random.Random(1996)
signal = [generator.uniform(-1.0, 1.0) for _ in range(SAMPLES)]

filters = {}
warnings.simplefilter("ignore")  # of levels at which the support exceeds the period: wanted here
for name in names:
    wavelet = pywt.Wavelet(name)
    parts = pywt.wavedec(signal, wavelet, mode="periodization", level=LEVELS)
    filters[name] = {
        "dec_lo": wavelet.dec_lo,
        "dec_hi": wavelet.dec_hi,
        "rec_lo": wavelet.rec_lo,
        "rec_hi": wavelet.rec_hi,
        "transform": [float(value) for part in parts for value in part],
    }

print(json.dumps({"version": pywt.__version__, "levels": LEVELS, "signal": signal, "filters": filters}))
