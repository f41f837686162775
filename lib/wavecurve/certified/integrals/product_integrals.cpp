#include "wavecurve/certified/integrals/product_integrals.hpp"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "wavecurve/certified/basis_function.hpp"
#include "wavecurve/certified/detail/is_accurate.hpp"
#include "wavecurve/certified/detail/verified_inverse.hpp"
#include "wavecurve/integrals/detail/integrate_product.hpp"
#include "wavecurve/integrals/detail/product_matrix.hpp"

namespace wavecurve::certified {

// Found by the templates of integrals/detail, before the one for any scalar.
void add_product(Ball& sum, const Ball& a, const Ball& b) {
  arb_addmul(sum.get(), a.get(), b.get(), WorkingPrecision::bits());
}

namespace {

constexpr double double_spacing = 0x1p-52;

/// A mask in double precision, and what the system made from it is off at most: the sum of a row's
/// differences.
struct RoundedMask {
  ProductMask<double> mask;
  double row_error = 0;
};

RoundedMask rounded(const ShiftSpace& space, const ProductMask<Ball>& exact) {
  RoundedMask result;
  double magnitudes = 2;  // of the identity, and of a row of u 1^T
  double errors = 0;
  for (const auto& [shift, value] : exact.entries) {
    const double nearest = value.to_double();
    result.mask.entries.push_back({shift, nearest});
    magnitudes += std::abs(nearest);
    errors += std::abs(nearest) * double_spacing + value.radius_double();
  }
  // An entry of the matrix adds up as many numbers as its unknown has tuples, and two more.
  result.row_error =
      1.01 * (errors + (space.largest_multiplicity() + 2) * double_spacing * magnitudes);
  return result;
}

/// Solves (I - 2^-p A_0 [+ u 1^T]) D = right, with proof.
std::vector<Ball> solve_product_system(const ShiftSpace& space, const ProductMask<Ball>& mask,
                                       int power, const std::vector<Ball>& right) {
  const RoundedMask approximate = rounded(space, mask);
  const auto inverse =
      VerifiedInverse::of(product_matrix(space, approximate.mask, power), approximate.row_error);
  if (!inverse) {
    throw std::domain_error("the two-scale system of " + std::to_string(space.size()) +
                            " integrals of products could not be proved regular");
  }
  const Ball scale(Rational::power_of_two(-power));
  return inverse->solve([&](const std::vector<Ball>& d) {
    std::vector<Ball> residual = apply(space, mask, d);
    Ball total(0);
    if (power == 0) {
      for (int i = 0; i < space.size(); ++i) {
        total += Ball(space.multiplicity(i)) * d[static_cast<std::size_t>(i)];
      }
      total /= Ball::from_double(tuples_rounded_up(space));
    }
    for (std::size_t i = 0; i < d.size(); ++i) {
      residual[i] = right[i] - d[i] + scale * residual[i] - total;
    }
    return residual;
  });
}

TwoScaleSides<Ball> two_scale_sides(const FilterBank<Ball>& bank) {
  const auto side = [&](bool dual, int zeros) {
    return TwoScaleSides<Ball>::Side{two_scale_coefficients(bank, {false, dual, 0}),
                                     two_scale_coefficients(bank, {true, dual, 0}), zeros};
  };
  return {side(false, bank.vanishing_moments), side(true, bank.dual_vanishing_moments)};
}

}  // namespace

ShiftTensor<Ball> product_integrals(const FilterDefinition& definition,
                                    const ProductIntegral& integral, long bits) {
  check_integral(integral);
  require_existence(definition, integral);
  ShiftTensor<Ball> result;
  const Filter<Ball> values = accurate_values(definition, bits, [&](const FilterBank<Ball>& bank) {
    result = integrate_product(two_scale_sides(bank), integral, solve_product_system);
    return Filter<Ball>{0, std::move(result.values)};
  });
  result.values = values.taps;
  return result;
}

}  // namespace wavecurve::certified
