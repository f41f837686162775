#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The closed curve f(t) = sum_n c_n phi(N t - n), indices of period N, at any parameter t.
///
/// phi is not known in closed form but for splines; yet f(t) needs only the finest coefficients
/// over whose phi the t lies. (2.1) turns them into those of half the spacing, those over whose phi
/// t still lies are kept, and after as many halvings as N t has bits behind the point, t is a point
/// of the grid. So f is evaluated at the double t itself, in O(support^2) a bit, at most 64 of
/// them. Derivatives are taken of the differences of c, as scaling_values does it, and hence lose
/// no accuracy in the halvings.
class WaveletCurve {
 public:
  /// The coefficients of the finest level, one a row. Throws std::domain_error where phi is not
  /// continuous (Haar).
  WaveletCurve(const FilterBank<double>& bank, const Contour& finest);

  Eigen::Vector2d point(double t) const { return derivative(t, 0); }
  /// d^order f / dt^order. Throws std::domain_error naming the Sobolev exponent where phi has no
  /// such derivative; up to exponents of order + 1/2 continuity is not assured.
  Eigen::Vector2d derivative(double t, int order) const;
  /// The unit vector along the curve; zero where f' vanishes. Throws as derivative of order 1.
  Eigen::Vector2d tangent(double t) const;
  /// (x' y'' - y' x'') / |f'|^3, in 1 / unit of length: positive where the curve turns clockwise as
  /// seen; not finite where f' vanishes. Throws as derivative of order 2.
  double curvature(double t) const;

 private:
  /// sum_n coefficients_n chi(N t - n), phi^(d) the d-fold backward difference of chi.
  struct Refinable {
    Contour coefficients;
    std::vector<double> mask;
    Eigen::VectorXd integers;

    Eigen::Vector2d value(double position, int first_index) const;
  };
  Refinable refinable(int order) const;

  FilterBank<double> bank_;
  Contour finest_;
  std::vector<Refinable> orders_;  ///< of the orders 0, 1, 2 that exist
};

}  // namespace wavecurve
