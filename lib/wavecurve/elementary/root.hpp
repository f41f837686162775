#pragma once

namespace wavecurve {

/// The n-th root of x, n = 2 .. 16, within 0.51 units in the last place of the true value: by
/// Newton's iteration, whose last step sees the power in twice the digits; additions,
/// multiplications and divisions give the same bits on every processor. The n-th root of infinity is infinity; of x < 0 it is -root(-x, n) for odd n, for even
/// n no number, as of what is none. Throws std::invalid_argument for any other n.
double root(double x, int n);

/// x^n, n >= 0, by n - 1 multiplications.
double whole_power(double x, int n);

/// 2^(k/2), rounded to nearest.
double power_of_root_two(int k);

}  // namespace wavecurve
