#pragma once

namespace wavecurve::elementary {

/// The error of the rounded product a b, which is a double itself unless it underflows (Dekker and
/// Veltkamp, 1971): by halves of 26 bits, without a fused operation. |a| and |b| below 2^970.
inline double product_error(double a, double b, double product) {
  const auto upper = [](double x) {
    const double scaled = 0x1.0000002p27 * x;  // 2^27 + 1
    return scaled - (scaled - x);
  };
  const double a_high = upper(a), a_low = a - a_high, b_high = upper(b), b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

}  // namespace wavecurve::elementary
