"""Connection coefficients of a Daubechies filter by mpmath, as one would write them down.

connection_mpmath.py ORDER DIGITS: the autocorrelation in closed form (Beylkin, 1992, (3.50)), the
two-scale system of mu with one row replaced by the moment condition, mpmath's LU. Prints JSON: the
processor time in seconds and mu_0.
"""

import json
import sys
import time

from mpmath import factorial, lu_solve, matrix, mp, mpf


def autocorrelation(order):
    scale = (factorial(2 * order - 1) / (factorial(order - 1) * mpf(4) ** (order - 1))) ** 2
    alpha = {0: mpf(2)}
    for k in range(1, order + 1):
        value = (-1) ** (k - 1) * scale
        value /= factorial(order - k) * factorial(order + k - 1) * (2 * k - 1)
        alpha[2 * k - 1] = alpha[1 - 2 * k] = value
    return alpha


def coefficients(order):
    """mu_l = 2 sum_k alpha_k mu_{2l-k} for |l| <= 2 order - 2, and sum l^2 mu_l = -2."""
    alpha = autocorrelation(order)
    last = 2 * order - 2
    size = 2 * last + 1
    system, right = matrix(size, size), matrix(size, 1)
    for row in range(size):
        shift = row - last
        system[row, row] = mpf(-1)
        for k, value in alpha.items():
            column = 2 * shift - k + last
            if 0 <= column < size:
                system[row, column] += 2 * value
    # The left null vector is l^2, so the row of l = 0 must stay; another one goes.
    for column in range(size):
        system[last + 1, column] = mpf(column - last) ** 2
    right[last + 1] = mpf(-2)
    return lu_solve(system, right)[last]


def main():
    order, digits = int(sys.argv[1]), int(sys.argv[2])
    mp.dps = digits
    start = time.process_time()
    mu = coefficients(order)
    seconds = time.process_time() - start
    print(json.dumps({"seconds": seconds, "mu_0": mp.nstr(mu, digits)}))


if __name__ == "__main__":
    main()
