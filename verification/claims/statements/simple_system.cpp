// "reduces the operator, such as d/dx, fractional derivatives, Hilbert and Riesz transforms, to a simple system of
// linear algebraic equations": that of d/dx is finite. Those of the others have infinitely many unknowns that
// do not vanish, and are closed by the asymptotics of the kernel, with a proved remainder.
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/integrals/homogeneous_operator.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/certified/rounding.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::simple_system_claim {

namespace {

using certified::Ball;
using certified::FilterDefinition;
using certified::HomogeneousOperator;
using certified::Rational;

constexpr const char* filter = "db4";
constexpr int largest = 64;  // |l| that is looked at
constexpr long bits = 128;

struct OperatorRow {
  std::string name;
  Rational order;
  Filter<Ball> r;  // at least for |l| <= largest, where it does not vanish
};

std::vector<OperatorRow> operators(const FilterDefinition& definition) {
  using Kind = HomogeneousOperator::Kind;
  const auto homogeneous = [&](std::string name, const HomogeneousOperator& op) -> OperatorRow {
    return {std::move(name), op.order, operator_coefficients(definition, op, largest, bits)};
  };
  auto derivative =
      certified::product_integrals(definition, {{{{.derivative = 1}, false}, {{}}}}, bits);
  return {{"d/dx", Rational(1), {derivative.first[0], std::move(derivative.values)}},
          homogeneous("derivative of order 1/2", {Kind::fractional, Rational(1, 2)}),
          homogeneous("integral of order 1/2", {Kind::fractional, Rational(-1, 2)}),
          homogeneous("Hilbert (on a line, Riesz) transform", {Kind::hilbert})};
}

int proved_nonzero(const Filter<Ball>& r) {
  int count = 0;
  for (int l = -largest; l <= largest; ++l) count += r[l].contains_zero() ? 0 : 1;
  return count;
}

/// The largest |r_l - 2^s sum h_i h_j r_{2l+j-i}| for |l| <= 20, which the coefficients up to 2 * 20 + 7 give.
Ball largest_residual(const OperatorRow& op, const Filter<Ball>& h) {
  const Ball scale = exp(Ball(op.order) * log(Ball(2)));
  Ball all(0);
  for (int l = -20; l <= 20; ++l) {
    Ball sum(0);
    for (int i = h.first_index; i <= h.last_index(); ++i) {
      for (int j = h.first_index; j <= h.last_index(); ++j) {
        sum += h[i] * h[j] * op.r[2 * l + j - i];
      }
    }
    all = hull(all, op.r[l] - scale * sum);
  }
  return all;
}

Chart decay(const std::vector<OperatorRow>& rows) {
  Chart chart{
      "operator-coefficients",
      {fmt::format("|r_l| = |int φ(x-l) (Tφ)(x) dx| of {}; 0 where it vanishes", filter),
       {"l", rows[0].name, rows[1].name, rows[3].name},
       {}},
      "set xlabel 'l'\nset ylabel '|r_l|'\nset logscale xy\nset format y '10^{%T}'\n"
      "set key left bottom\n"
      "plot data using 1:($2 > 0 ? $2 : NaN) with linespoints lt -1 pt 7 title 'd/dx: none beyond the support', "
      "data using 1:3 with linespoints lt -1 dt 2 pt 6 title 'derivative of order 1/2: falls as 1/(l √l)', "
      "data using 1:4 with linespoints lt -1 dt 3 pt 4 title 'Hilbert transform: falls as 1/l'\n"};
  for (int l = 1; l <= largest; ++l) {
    const auto text = [&](const OperatorRow& row) {
      return fmt::format("{:.4g}", std::abs(row.r[l].to_double()));
    };
    chart.data.rows.push_back({std::to_string(l), text(rows[0]), text(rows[1]), text(rows[3])});
  }
  return chart;
}

Outcome evaluate() {
  const FilterDefinition definition = certified::find_filter(filter);
  const std::vector<OperatorRow> rows = operators(definition);
  const certified::WorkingPrecision precision(bits + 64);
  const Filter<Ball> h = definition.bank(bits + 64).synthesis_low;
  const int reach = h.size() - 1;
  Table table{fmt::format("r_l of {}, support of length {}; r_l = 2^s sum_k c_k r_(2l+k) for all l",
                          filter, reach),
              {"operator T", "r_l proved not to vanish, |l| ≤ 64",
               "unknowns of the system that is solved", "closed by", "largest residual, |l| ≤ 20"},
              {}};
  bool all_hold = true;
  for (const OperatorRow& row : rows) {
    const bool is_finite = &row == &rows[0];
    const bool is_odd = &row == &rows[3];
    const Ball residual = largest_residual(row, h);
    all_hold = all_hold && residual.contains_zero();
    const int unknowns = is_odd ? reach : is_finite ? 2 * reach - 1 : 2 * reach;
    table.rows.push_back({row.name, std::to_string(proved_nonzero(row.r)), std::to_string(unknowns),
                          is_finite ? "the sum of the integrals"
                                    : "the asymptotics for |l| > " + std::to_string(reach),
                          "0 within " + certified::magnitude_bound(residual)});
  }
  // Without the asymptotics: 1/(pi l) is what is left of them if only the first term is kept.
  const Ball l(reach + 1);
  const Ball first_term = Ball(1) / (Ball::pi() * l);
  const double relative = (rows[3].r[reach + 1] / first_term - Ball(1)).to_double();
  Outcome outcome;
  outcome.verdict = all_hold ? ClaimVerdict::depends_on_definition : ClaimVerdict::does_not_hold;
  outcome.finding = {
      "d/dx: {} coefficients, one finite system; Hilbert transform: {} of {} proved not to vanish, and so on without "
      "end; just beyond the support its r_l departs from 1/(π l) by {}",
      {counted("coefficients of d/dx", proved_nonzero(rows[0].r)),
       counted("Hilbert coefficients proved not to vanish", proved_nonzero(rows[3].r)),
       counted("Hilbert coefficients looked at", 2 * largest + 1),
       to_digits("departure from 1/(pi l) beyond the support", std::abs(relative), 2)}};
  outcome.summary =
      "For a derivative of whole order the system is finite, and one equation fixes the factor. For the others the two-scale "
      "relation links infinitely many coefficients; a finite system is left only where the asymptotics of the "
      "kernel, by the moments of the autocorrelation of φ, give those beyond the support. With them, and "
      "a proved remainder, the sentence holds for every operator that it names.";
  outcome.evidence = {table, decay(rows)};
  return outcome;
}

const RegisterClaim registered(
    {"simple-system", "Operators by a system of linear equations", "Section 3.2, before (3.9)",
     "a method that reduces the operator, such as d/dx, fractional derivatives, Hilbert and Reisz transforms, "
     "to a simple system of linear algebraic equations",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::simple_system_claim
