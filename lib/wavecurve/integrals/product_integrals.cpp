#include "wavecurve/integrals/product_integrals.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/LU>
#include <fmt/format.h>

#include "wavecurve/integrals/detail/integrate_product.hpp"
#include "wavecurve/integrals/detail/needed_exponent.hpp"
#include "wavecurve/integrals/detail/product_matrix.hpp"

namespace wavecurve {

namespace {

Filter<double> times_root_two(Filter<double> taps) {
  for (double& tap : taps.taps) tap *= std::numbers::sqrt2;
  return taps;
}

/// The exponent of phi~ is not known here.
void require_known_existence(const FilterBank<double>& bank, const ProductIntegral& integral) {
  const bool is_moment = integral.factors.size() == 1 && !integral.interval;
  for (const IntegralFactor& factor : integral.factors) {
    if (is_moment || (factor.function.dual && !bank.is_orthonormal())) return;
  }
  const auto [numerator, denominator] = needed_exponent(integral);
  const double needed = static_cast<double>(numerator) / denominator;
  if (!(bank.sobolev_exponent <= needed)) return;
  throw std::domain_error(fmt::format(
      "filter {} is not smooth enough for {}: its Sobolev exponent is {:.4g}, but it must exceed "
      "{:.4g}",
      bank.name, name_of(integral), bank.sobolev_exponent, needed));
}

std::vector<double> solve_product_system(const ShiftSpace& space, const ProductMask<double>& mask,
                                         int power, const std::vector<double>& right) {
  const Eigen::PartialPivLU<Eigen::MatrixXd> factors(product_matrix(space, mask, power));
  const Eigen::Map<const Eigen::VectorXd> b(right.data(), space.size());
  const Eigen::VectorXd x = factors.solve(b);
  if (!x.allFinite()) throw std::domain_error("the two-scale system of the integrals is singular");
  return {x.begin(), x.end()};
}

}  // namespace

ShiftTensor<double> product_integrals(const FilterBank<double>& bank,
                                      const ProductIntegral& integral) {
  check_integral(integral);
  require_known_existence(bank, integral);
  const TwoScaleSides<double> sides{
      {times_root_two(bank.synthesis_low), times_root_two(bank.synthesis_high),
       bank.vanishing_moments},
      {times_root_two(bank.analysis_low), times_root_two(bank.analysis_high),
       bank.dual_vanishing_moments}};
  return integrate_product(sides, integral, solve_product_system);
}

}  // namespace wavecurve
