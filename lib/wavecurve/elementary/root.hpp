#pragma once

namespace wavecurve {

/// The n-th root of x >= 0, n = 2 .. 16, within two units in the last place of the true value: by
/// Newton's iteration, whose additions, multiplications and divisions give the same bits on every
/// processor. The n-th root of infinity is infinity. Throws std::domain_error for x < 0 and for what
/// is no number, std::invalid_argument for any other n.
double root(double x, int n);

/// x^n, n >= 0, by n - 1 multiplications.
double whole_power(double x, int n);

}  // namespace wavecurve
