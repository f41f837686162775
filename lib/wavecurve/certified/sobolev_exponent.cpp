#include "wavecurve/certified/sobolev_exponent.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "wavecurve/certified/detail/flint_matrices.hpp"
#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/square_matrix.hpp"

namespace wavecurve::certified {

namespace {

/// q(x) of low(x) = sqrt 2 ((1 + x)/2)^N q(x), by repeated division by (1 + x)/2.
std::vector<Ball> without_zeros_at_pi(const Filter<Ball>& low, int zeros_at_pi) {
  std::vector<Ball> quotient = low.taps;
  const Ball root_two = sqrt(Ball(2));
  for (Ball& tap : quotient) tap /= root_two;
  for (int i = 0; i < zeros_at_pi; ++i) {
    for (std::size_t k = 1; k < quotient.size(); ++k) quotient[k] -= quotient[k - 1];
    if (!quotient.back().contains_zero()) {
      throw std::domain_error("the filter has fewer than " + std::to_string(zeros_at_pi) +
                              " zeros at pi: remainder " + magnitude_bound(quotient.back()));
    }
    quotient.pop_back();
    for (Ball& c : quotient) c *= Ball(2);
  }
  return quotient;
}

/// T on symmetric sequences u_0 .. u_{n-1}, n = deg q (at least 1).
SquareMatrix<Ball> transition_operator(const std::vector<Ball>& q) {
  const int degree = static_cast<int>(q.size()) - 1;
  const auto a = [&](int k) {
    Ball sum(0);
    if (k < 0) k = -k;
    for (int i = 0; i + k <= degree; ++i) {
      sum += q[static_cast<std::size_t>(i)] * q[static_cast<std::size_t>(i + k)];
    }
    return sum;
  };
  std::vector<Ball> table;
  for (int k = 0; k <= 3 * degree + 1; ++k) table.push_back(a(k));
  const auto at = [&](int k) { return table[static_cast<std::size_t>(k < 0 ? -k : k)]; };
  const int n = degree < 1 ? 1 : degree;
  SquareMatrix<Ball> t(n);
  for (int i = 0; i < n; ++i) {
    t(i, 0) = Ball(2) * at(2 * i);
    for (int j = 1; j < n; ++j) t(i, j) = Ball(2) * (at(2 * i - j) + at(2 * i + j));
  }
  return t;
}

/// The spectral radius rho from T^k, k = 2^squarings: |tr T^k| / n <= rho^k <= norm(T^k).
/// T maps non-negative functions to such, so that rho itself is an eigenvalue and the trace is no
/// small sum of large terms; the two bounds differ by a factor that the k-th root brings to 1.
Ball spectral_radius(const SquareMatrix<Ball>& t, int squarings) {
  const int n = t.size();
  const long bits = WorkingPrecision::bits();
  arb_mat_t power;
  arb_mat_init(power, n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) arb_set(arb_mat_entry(power, i, j), t(i, j).get());
  }
  for (int m = 0; m < squarings; ++m) arb_mat_sqr(power, power, bits);
  Ball trace, norm;
  arb_mat_trace(trace.get(), power, bits);
  arb_mat_frobenius_norm(norm.get(), power, bits);
  arb_mat_clear(power);
  if (!trace.is_positive()) {
    throw std::domain_error("the spectral radius of the transition operator was not enclosed");
  }
  const Ball k(Rational::power_of_two(squarings));
  return hull(exp(log(trace / Ball(n)) / k), exp(log(norm) / k));
}

/// The exponent of phi, at rising precision until it can be enclosed.
Ball exponent_of(const FilterDefinition& definition, int squarings) {
  constexpr long first_bits = 128;
  try {
    return *refine(first_bits, [&](long bits) {
      const FilterBank<Ball> bank = definition.bank(bits);
      return std::optional(sobolev_exponent(bank.synthesis_low, bank.vanishing_moments, squarings));
    });
  } catch (const std::domain_error& error) {
    throw std::domain_error("the Sobolev exponent of filter " + definition.name +
                            " is not known; its taps have too few digits: " + error.what());
  }
}

constexpr int accurate_squarings = 45;  // leaves a radius of 1e-13 for the longest filters

}  // namespace

Ball sobolev_exponent(const Filter<Ball>& low, int zeros_at_pi, int squarings) {
  const auto t = transition_operator(without_zeros_at_pi(low, zeros_at_pi));
  const Ball rho = spectral_radius(t, squarings);
  return Ball(zeros_at_pi) - log(rho) / log(Ball(4));
}

Ball sobolev_exponent(const FilterDefinition& definition) {
  return exponent_of(definition, accurate_squarings);
}

void require_smoothness(const FilterDefinition& definition, int p, int q) {
  const Rational needed(p + q, 2);
  Ball found;
  for (const int squarings : {4, 10, 20, accurate_squarings}) {  // a rough bound mostly decides
    found = exponent_of(definition, squarings);
    if (certainly_less(Ball(needed), found)) return;
    if (certainly_less(found, Ball(needed))) break;
  }
  if (certainly_less(found, Ball(needed))) found = sobolev_exponent(definition);
  constexpr int shown = 4;
  throw std::domain_error("filter " + definition.name + " is not smooth enough for derivatives " +
                          std::to_string(p) + "," + std::to_string(q) +
                          ": its Sobolev exponent is " +
                          round_to_digits(found, shown).value_or("not known well enough") +
                          ", needed is more than " + round_to_decimals(needed, 1));
}

}  // namespace wavecurve::certified
