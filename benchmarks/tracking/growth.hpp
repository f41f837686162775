#pragma once

#include <string>
#include <vector>

namespace wavecurve::tracking {

/// The exponent p of cost = c g(N)^p, g the growth that is stated, with its 95 % interval: 1 where
/// the cost grows as stated.
struct GrowthFit {
  double exponent, lower, upper;

  /// More than what is stated: the whole interval lies above 1 by more than a twentieth.
  /// Lower-order terms, which matter at small sizes, bend an exponent less; another logarithm is
  /// worth 0.1.
  bool exceeds_stated() const { return lower > 1.05; }
};

/// Least squares of ln cost over ln g(N), and Student's interval of the slope (it holds the bend of
/// a cost that is no power too). `stated` is "N" or "N log N".
/// Throws std::invalid_argument for another growth, for fewer than three sizes, or where a size is
/// below 2 or a cost not above 0.
GrowthFit fit_growth(const std::vector<double>& sizes, const std::vector<double>& costs,
                     const std::string& stated);

}  // namespace wavecurve::tracking
