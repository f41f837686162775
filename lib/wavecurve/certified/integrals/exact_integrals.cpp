#include "wavecurve/certified/integrals/exact_integrals.hpp"

#include <utility>
#include <vector>

#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/certified/linear_solve.hpp"
#include "wavecurve/filters/square_matrix.hpp"
#include "wavecurve/integrals/detail/integrate_product.hpp"

namespace wavecurve::certified {

namespace {

/// What solve_exactly throws, and exact_product_integrals answers with nothing.
struct NoExactSolution {};

/// I - 2^-p A_0, for p = 0 + u 1^T (integrals/detail/product_system.hpp).
SquareMatrix<Rational> exact_matrix(const ShiftSpace& space, const ProductMask<Rational>& mask,
                                    int power) {
  SquareMatrix<Rational> matrix(space.size());
  const Rational scale = Rational::power_of_two(-power);
  const Rational u(1, static_cast<long>(tuples_rounded_up(space)));
  for (int row = 0; row < space.size(); ++row) {
    visit_row(space, mask, row,
              [&](int unknown, const Rational& value) { matrix(row, unknown) -= scale * value; });
    matrix(row, row) += Rational(1);
    for (int column = 0; power == 0 && column < space.size(); ++column) {
      matrix(row, column) += u * Rational(space.multiplicity(column));
    }
  }
  return matrix;
}

std::vector<Rational> solve_exactly(const ShiftSpace& space, const ProductMask<Rational>& mask,
                                    int power, const std::vector<Rational>& right) {
  if (space.size() > most_exact_unknowns) throw NoExactSolution{};
  auto solution = solve(exact_matrix(space, mask, power), right);
  if (!solution) throw NoExactSolution{};
  return *std::move(solution);
}

}  // namespace

std::optional<ShiftTensor<Rational>> exact_product_integrals(const FilterDefinition& definition,
                                                             const ProductIntegral& integral) {
  check_integral(integral);
  require_existence(definition, integral);
  if (!definition.two_scale) return std::nullopt;
  const FilterBank<Rational>& bank = *definition.two_scale;
  const TwoScaleSides<Rational> sides{
      {bank.synthesis_low, bank.synthesis_high, bank.vanishing_moments},
      {bank.analysis_low, bank.analysis_high, bank.dual_vanishing_moments}};
  try {
    return integrate_product(sides, integral, solve_exactly);
  } catch (const NoExactSolution&) {
    return std::nullopt;
  }
}

}  // namespace wavecurve::certified
