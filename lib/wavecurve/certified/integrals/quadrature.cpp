#include "wavecurve/certified/integrals/quadrature.hpp"

#include <stdexcept>

#include "wavecurve/certified/moments.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

/// Sums over powers of nodes lose some bits a degree; enclosures stay right whatever this is.
constexpr long bits_a_degree = 8;

/// int x^p phi less the rule's sum.
Ball error_of(const QuadratureRule& rule, const Ball& moment, int p) {
  Ball error = moment;
  for (std::size_t k = 0; k < rule.nodes.size(); ++k) {
    error -= rule.weights[k] * pow(rule.nodes[k], static_cast<unsigned long>(p));
  }
  return error;
}

/// The coefficients of prod_{j != k} (x - x_j) / (x_k - x_j).
std::vector<Rational> lagrange_polynomial(const std::vector<Rational>& nodes, std::size_t k) {
  std::vector<Rational> result{Rational(1)};
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    if (j == k) continue;
    const Rational divisor = nodes[k] - nodes[j];
    result.emplace_back(0);
    for (std::size_t i = result.size(); i-- > 0;) {
      const Rational lower = i > 0 ? result[i - 1] : Rational(0);
      result[i] = (lower - nodes[j] * result[i]) / divisor;
    }
  }
  return result;
}

}  // namespace

QuadratureRule one_point_rule(const FilterDefinition& definition, long bits) {
  const WorkingPrecision precision(bits + 4 * bits_a_degree);
  const std::vector<Ball> known = moments(definition, {}, 3, WorkingPrecision::bits());
  const FilterBank<Ball> bank = definition.bank(bits);
  const bool gains = bank.is_orthonormal() && bank.vanishing_moments >= 2;
  QuadratureRule rule{{known[1]}, {Ball(1)}, gains ? 2 : 1, {}};
  rule.next_error =
      error_of(rule, known[static_cast<std::size_t>(rule.degree) + 1], rule.degree + 1);
  return rule;
}

QuadratureRule equidistant_rule(const FilterDefinition& definition, const Rational& first,
                                const Rational& step, int count, long bits) {
  check_between("number of nodes of a quadrature rule", count, 1, most_nodes);
  if (step.sign() <= 0) {
    throw std::invalid_argument(
        must_be("step of a quadrature rule", step.to_string(), "above zero"));
  }
  const WorkingPrecision precision(bits + bits_a_degree * (count + 1));
  const std::vector<Ball> known = moments(definition, {}, count, WorkingPrecision::bits());
  std::vector<Rational> nodes;
  QuadratureRule rule;
  rule.degree = count - 1;
  for (int k = 0; k < count; ++k) {
    nodes.push_back(first + Rational(k) * step);
    rule.nodes.emplace_back(nodes.back());
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const std::vector<Rational> polynomial = lagrange_polynomial(nodes, k);
    Ball weight(0);
    for (std::size_t p = 0; p < polynomial.size(); ++p) weight += Ball(polynomial[p]) * known[p];
    rule.weights.push_back(weight);
  }
  rule.next_error = error_of(rule, known.back(), count);
  return rule;
}

std::vector<Ball> reproduction_coefficients(const FilterDefinition& definition, long bits) {
  const int degrees = definition.bank(bits).vanishing_moments;
  return moments(definition, {false, true, 0}, degrees - 1, bits);
}

}  // namespace wavecurve::certified
