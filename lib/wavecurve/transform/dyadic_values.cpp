#include "wavecurve/transform/dyadic_values.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>

namespace wavecurve {

namespace {

using Eigen::Index;

constexpr int largest_level = 24;

void check(const FilterBank<double>& bank, int level, int d) {
  if (level < 0 || level > largest_level) {
    throw std::invalid_argument(
        fmt::format("level is {}, but must be from 0 to {}", level, largest_level));
  }
  if (d < 0) throw std::invalid_argument(fmt::format("d is {}, but must be at least 0", d));
  if (d >= bank.vanishing_moments || d >= bank.sobolev_exponent) {
    throw std::domain_error(fmt::format(
        "{}: the derivative of order {} is no function: the Sobolev exponent is {:.4g}, and {} "
        "polynomial degrees are reproduced",
        bank.name, d, bank.sobolev_exponent, bank.vanishing_moments));
  }
}

/// mask / ((1 + z) / 2). Both ends are divided towards the middle, which halves the longest sum.
std::vector<double> divide_by_average(const std::vector<double>& mask) {
  const std::size_t size = mask.size() - 1;
  std::vector<double> quotient(size);
  for (std::size_t k = 0; k < size / 2; ++k) {
    quotient[k] = 2 * mask[k] - (k == 0 ? 0 : quotient[k - 1]);
  }
  for (std::size_t k = size; k-- > size / 2;) {
    quotient[k] = 2 * mask[k + 1] - (k + 1 == size ? 0 : quotient[k + 1]);
  }
  return quotient;
}

/// chi at 0 .. size - 1 for chi(x) = sum_k mask_k chi(2x - k), sum_l chi(l) = 1.
Eigen::VectorXd integer_values(const std::vector<double>& mask) {
  const Index size = static_cast<Index>(mask.size()), inner = size - 2;
  if (inner < 1) {
    throw std::domain_error(
        fmt::format("a refinable function of {} coefficients is not continuous", size));
  }
  Eigen::MatrixXd system(inner, inner);
  for (Index l = 1; l <= inner; ++l) {
    for (Index m = 1; m <= inner; ++m) {
      const Index k = 2 * l - m;
      const double coefficient = k >= 0 && k < size ? mask[static_cast<std::size_t>(k)] : 0;
      system(l - 1, m - 1) = coefficient - (l == m ? 1 : 0);
    }
  }
  // The columns sum to zero, so that any equation can give way to the scale.
  system.row(inner - 1).setOnes();
  Eigen::VectorXd values = Eigen::VectorXd::Zero(size);
  values.segment(1, inner) = system.fullPivLu().solve(Eigen::VectorXd::Unit(inner, inner - 1));
  return values;
}

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
  check(bank, level, d);
  std::vector<double> mask = bank.synthesis_low.taps;
  for (double& tap : mask) tap *= std::sqrt(2.0);
  for (int i = 0; i < d; ++i) mask = divide_by_average(mask);
  Eigen::VectorXd values = integer_values(mask);
  for (int j = 0; j < level; ++j) values = refine(values, mask, j);
  for (int i = 0; i < d; ++i) values = backward_difference(values, level);
  return {static_cast<double>(bank.synthesis_low.first_index), level, values};
}

DyadicValues wavelet_values(const FilterBank<double>& bank, int level, int d) {
  check(bank, level, d);
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
