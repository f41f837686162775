#include "wavecurve/transform/dyadic_values.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/transform/detail/refinement_mask.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;

constexpr int largest_level = 24;

void check(int level) { check_between("level", level, 0, largest_level); }

/// The values at half the spacing: the old points stay, those between follow from (2.1).
Eigen::VectorXd refine(const Eigen::VectorXd& coarse, const std::vector<double>& mask, int level) {
  const Index last = coarse.size() - 1;
  Eigen::VectorXd fine(2 * last + 1);
  for (Index i = 0; i <= last; ++i) fine[2 * i] = coarse[i];
  for (Index i = 1; i < 2 * last; i += 2) {
    double sum = 0;
    Index at = i;  // 2x - k on the coarse grid
    for (double coefficient : mask) {
      if (at >= 0 && at <= last) sum += coefficient * coarse[at];
      at -= Index{1} << level;
    }
    fine[i] = sum;
  }
  return fine;
}

/// values(x) - values(x - 1), one unit longer.
Eigen::VectorXd backward_difference(const Eigen::VectorXd& values, int level) {
  const Index unit = Index{1} << level;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values.size() + unit);
  result.head(values.size()) = values;
  result.tail(values.size()) -= values;
  return result;
}

}  // namespace

double DyadicValues::point(Index i) const {
  return first + std::ldexp(static_cast<double>(i), -level);
}

DyadicValues scaling_values(const FilterBank<double>& bank, int level, int d) {
  check(level);
  const std::vector<double> mask = refinement_mask(bank, d);
  Eigen::VectorXd values = integer_values(mask);
  for (int j = 0; j < level; ++j) values = refine(values, mask, j);
  for (int i = 0; i < d; ++i) values = backward_difference(values, level);
  return {static_cast<double>(bank.synthesis_low.first_index), level, values};
}

DyadicValues wavelet_values(const FilterBank<double>& bank, int level, int d) {
  check(level);
  const int phi_level = std::max(level - 1, 0);
  const DyadicValues phi = scaling_values(bank, phi_level, d);
  const Filter<double>& high = bank.synthesis_high;
  const int low_first = bank.synthesis_low.first_index, low_last = bank.synthesis_low.last_index();
  // Twice the ends of the support; in steps of 2^-level, rounded into the support if need be.
  const Index step = level == 0 ? 2 : 1, unit = Index{1} << phi_level;
  const Index begin = (low_first + high.first_index) * unit;
  const Index end = (low_last + high.last_index()) * unit;
  const Index first = begin + (step == 2 ? begin & 1 : 0);
  DyadicValues psi{std::ldexp(static_cast<double>(first), -phi_level - 1), level,
                   Eigen::VectorXd::Zero((end - first) / step + 1)};
  const double scale = std::ldexp(std::sqrt(2.0), d);
  for (Index i = 0; i < psi.values.size(); ++i) {
    double sum = 0;
    for (int n = high.first_index; n <= high.last_index(); ++n) {
      const Index at = first + i * step - (n + low_first) * unit;  // 2x - n, from phi's first point
      if (at >= 0 && at < phi.values.size()) sum += high[n] * phi.values[at];
    }
    psi.values[i] = scale * sum;
  }
  return psi;
}

}  // namespace wavecurve
