#include "wavecurve/transform/detail/refinement_mask.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/LU>
#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

namespace {

void check(const FilterBank<double>& bank, int d) {
  check_at_least("d", d, 0);
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

}  // namespace

std::vector<double> refinement_mask(const FilterBank<double>& bank, int d) {
  check(bank, d);
  std::vector<double> mask = bank.synthesis_low.taps;
  for (double& tap : mask) tap *= std::sqrt(2.0);
  for (int i = 0; i < d; ++i) mask = divide_by_average(mask);
  return mask;
}

Eigen::VectorXd integer_values(const std::vector<double>& mask) {
  const Eigen::Index size = static_cast<Eigen::Index>(mask.size()), inner = size - 2;
  if (inner < 1) {
    throw std::domain_error(
        fmt::format("a refinable function of {} coefficients is not continuous", size));
  }
  Eigen::MatrixXd system(inner, inner);
  for (Eigen::Index l = 1; l <= inner; ++l) {
    for (Eigen::Index m = 1; m <= inner; ++m) {
      const Eigen::Index k = 2 * l - m;
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

}  // namespace wavecurve
