#pragma once

#include <complex>

namespace wavecurve::dynamics {

/// Divided differences of the exponential function,
///   exp[x, y] = (e^x - e^y) / (x - y),   exp[x, y, z] = (exp[x, y] - exp[y, z]) / (x - z),
/// with the limits where points coincide: exp[x, x] = e^x, exp[x, x, x] = e^x / 2. Symmetric in the
/// points. The absolute error is a few units of rounding of max(|e^x|, |e^y|, |e^z|), wherever the
/// points lie; near coincidence, where the quotients would cancel, the relative error is.
///
/// All solutions of linear equations with constant coefficients are made of them: with roots r_1,
/// r_2 the response to an impulse is t exp[r_1 t, r_2 t], to a constant force t^2 exp[r_1 t, r_2 t,
/// 0], to a harmonic one t^2 exp[r_1 t, r_2 t, i Omega t], at a repeated root and at resonance too.
std::complex<double> exponential_difference(std::complex<double> x, std::complex<double> y);
std::complex<double> exponential_difference(std::complex<double> x, std::complex<double> y,
                                            std::complex<double> z);

/// phi_k(x) = exp[x, 0, ..., 0] with k zeros, k = 0 .. 3, for x <= 0: e^x, (e^x - 1) / x, ...
double phi_function(int k, double x);

}  // namespace wavecurve::dynamics
