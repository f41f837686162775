"""Three-term connection coefficients of a Daubechies filter by mpmath, as one would write them down.

three_terms_mpmath.py ORDER DIGITS: the taps by the roots of Daubechies' polynomial, the two-scale system of
D(l, m) = int phi(x) phi(x - l) phi(x - m) dx with one row replaced by sum D = 1, mpmath's LU. Prints JSON: the processor
time in seconds and D(0, 0).
"""

import json
import sys
import time

from mpmath import binomial, lu_solve, matrix, mp, mpf, polyroots, sqrt


def product(a, b):
    result = [mpf(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def two_scale_coefficients(order):
    """a_n of phi(x) = sum a_n phi(2x - n): ((1 + z) / 2)^order times the factor of the roots within the circle."""
    inside = []
    for y in polyroots([binomial(order - 1 + k, k) for k in reversed(range(order))], maxsteps=500, extraprec=300):
        for sign in (1, -1):  # z + 1/z = 2 - 4 y
            z = (1 - 2 * y) + sign * sqrt((1 - 2 * y) ** 2 - 1)
            if abs(z) < 1:
                inside.append(z)
    a = [mpf(1)]
    for _ in range(order):
        a = product(a, [mpf(1), mpf(1)])
    for z in inside:
        a = product(a, [mpf(1), -z])
    a = [x.real for x in a]
    total = sum(a)
    return [2 * x / total for x in a]


def coefficients(order):
    """D(l, m) = 1/2 sum a_i a_j a_k D(2l + j - i, 2m + k - i), |l|, |m|, |l - m| < the length of the support."""
    a = two_scale_coefficients(order)
    last = len(a) - 2
    places = {}
    for l in range(-last, last + 1):
        for m in range(-last, last + 1):
            if abs(l - m) <= last:
                places[l, m] = len(places)
    size = len(places)
    system, right = matrix(size, size), matrix(size, 1)
    for (l, m), row in places.items():
        system[row, row] += 1
        for i, x in enumerate(a):
            for j, y in enumerate(a):
                for k, z in enumerate(a):
                    column = places.get((2 * l + j - i, 2 * m + k - i))
                    if column is not None:
                        system[row, column] -= x * y * z / 2
    for column in range(size):
        system[0, column] = mpf(1)
    right[0] = mpf(1)
    return lu_solve(system, right)[places[0, 0]]


def main():
    order, digits = int(sys.argv[1]), int(sys.argv[2])
    mp.dps = digits
    start = time.process_time()
    value = coefficients(order)
    seconds = time.process_time() - start
    print(json.dumps({"seconds": seconds, "value": mp.nstr(value, digits)}))


if __name__ == "__main__":
    main()
