#pragma once

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// Values of a function at first + i 2^-level, i = 0 .. size - 1: its support, ends included.
struct DyadicValues {
  double first = 0;
  int level = 0;
  Eigen::VectorXd values;

  double point(Eigen::Index i) const;
};

/// The derivative of order d of the scaling function phi of the synthesis side, int phi = 1, at all
/// points of spacing 2^-level, to machine precision relative to its largest value; each derivative
/// may enlarge the rounding of the taps by half their number. Publication, (2.1).
///
/// phi^(d) is the d-fold backward difference of chi, whose mask is that of phi divided by
/// ((1 + z) / 2)^d. chi's values at the integers are the eigenvector of its mask for the eigenvalue
/// 1, those in between follow from (2.1) without enlarging errors, while a recursion for phi^(d)
/// itself would, by 2^d a level.
///
/// Throws std::domain_error where phi^(d) is not known to be a function: d at or above the Sobolev
/// exponent or the vanishing moments, or no inner integer (Haar). Up to exponents of d + 1/2
/// continuity is not assured. Throws std::invalid_argument for level < 0, level > 24 or d < 0.
DyadicValues scaling_values(const FilterBank<double>& bank, int level, int d = 0);

/// The same for the wavelet, psi(x) = sqrt 2 sum_n synthesis_high_n phi(2x - n).
DyadicValues wavelet_values(const FilterBank<double>& bank, int level, int d = 0);

}  // namespace wavecurve
