#pragma once

#include <Eigen/Core>

namespace wavecurve {

/// Sine and cosine of an angle in radians.
struct SineCosine {
  double sine, cosine;
};

/// Both, each within one unit in the last place of the true value (the bounds that are proved are
/// smaller: elementary/detail/elementary_tables.hpp), and the same bits on every processor, which
/// the C library does not promise. Every double is taken: angles beyond 2^20 are reduced in whole
/// numbers, by Payne and Hanek (1983). Infinities and NaN give NaN; the sine of -0 is -0.
SineCosine sine_cosine(double x);
double sine(double x);
double cosine(double x);

/// The same bits for every entry of an array, on Highway's vectors. Either result may be stored
/// in the place of x. Throws std::invalid_argument if the sizes differ.
void sine_cosine(const Eigen::Ref<const Eigen::ArrayXd>& x, Eigen::Ref<Eigen::ArrayXd> sine,
                 Eigen::Ref<Eigen::ArrayXd> cosine);

}  // namespace wavecurve
