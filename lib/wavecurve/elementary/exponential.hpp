#pragma once

#include <complex>

#include <Eigen/Core>

namespace wavecurve {

/// e^x within one unit in the last place of the true value (the bound that is proved is smaller:
/// elementary/detail/elementary_tables.hpp), and the same bits on every processor, which the C
/// library does not promise. Every double is taken: the result is infinity beyond 709.78, 0 below -745.13,
/// rounded once more where it is subnormal, and NaN for NaN.
double exponential(double x);

/// e^x - 1, within 1.6 units in the last place, also where x is small.
double exponential_minus_one(double x);

/// e^x (cos y + i sin y) for z = x + i y, each part within four units: a unit
/// of each factor may be two of their product.
std::complex<double> exponential(const std::complex<double>& z);

/// sinh z = sinh x cos y + i cosh x sin y for z = x + i y, |x| < 709, each part within eight units.
std::complex<double> hyperbolic_sine(const std::complex<double>& z);

/// The same bits as of the first function for every entry of an array, on Highway's vectors; the
/// result may be stored in the place of x. Throws std::invalid_argument if the sizes differ.
void exponential(const Eigen::Ref<const Eigen::ArrayXd>& x, Eigen::Ref<Eigen::ArrayXd> result);

}  // namespace wavecurve
