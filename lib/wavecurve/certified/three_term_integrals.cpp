#include "wavecurve/certified/three_term_integrals.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

#include "wavecurve/certified/detail/is_accurate.hpp"
#include "wavecurve/certified/linear_solve.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

using Functions = std::array<BasisFunction, 3>;
using Place = std::pair<int, int>;

/// The pairs (l, m) where all three supports meet in more than a point, each with its number.
std::map<Place, int> unknowns_of(const std::array<Support, 3>& supports) {
  const auto& [f, g, k] = supports;
  std::map<Place, int> unknowns;
  for (int l = int(f.first - g.last); l <= int(f.last - g.first); ++l) {
    for (int m = int(f.first - k.last); m <= int(f.last - k.first); ++m) {
      const double first = std::max({f.first, g.first + l, k.first + m});
      const double last = std::min({f.last, g.last + l, k.last + m});
      if (first < last) unknowns.emplace(Place(l, m), int(unknowns.size()));
    }
  }
  return unknowns;
}

/// sum_i a_i b_{i+s} c_{i+t}: the coefficient of G(2l + s, 2m + t) in (R).
class Mask {
 public:
  Mask(const FilterBank<Ball>& bank, const Functions& functions) {
    for (std::size_t i = 0; i < functions.size(); ++i) {
      factors_[i] = two_scale_coefficients(bank, functions[i]);
    }
  }

  const Ball& operator()(int s, int t) {
    const auto [known, is_new] = sums_.try_emplace({s, t});
    if (is_new) known->second = sum(s, t);
    return known->second;
  }

 private:
  Ball sum(int s, int t) const {
    const auto& [a, b, c] = factors_;
    Ball result(0);
    for (int i = a.first_index; i <= a.last_index(); ++i) {
      const bool inside = i + s >= b.first_index && i + s <= b.last_index() &&
                          i + t >= c.first_index && i + t <= c.last_index();
      if (inside) result += a[i] * b[i + s] * c[i + t];
    }
    return result;
  }

  std::array<Filter<Ball>, 3> factors_;
  std::map<Place, Ball> sums_;
};

/// i (i-1) .. (i-q+1), zero for i < q.
Rational falling_factorial(int i, int q) {
  Rational result(1);
  for (int j = 0; j < q; ++j) result *= Rational(i - j);
  return result;
}

Rational integer_power(int base, int exponent) {
  Rational result(1);
  for (int i = 0; i < exponent; ++i) result *= Rational(base);
  return result;
}

/// (R) as rows of a square matrix: G - 2^(d-1) sum = 0.
SquareMatrix<Ball> two_scale_rows(const std::map<Place, int>& unknowns, Mask& mask, int d) {
  SquareMatrix<Ball> system(int(unknowns.size()));
  const Ball scale(Rational::power_of_two(d - 1));
  for (const auto& [row_place, row] : unknowns) {
    for (const auto& [place, column] : unknowns) {
      const Ball& entry =
          mask(place.first - 2 * row_place.first, place.second - 2 * row_place.second);
      system(row, column) = Ball(row == column ? 1 : 0) - scale * entry;
    }
  }
  return system;
}

/// Adds the moment equation of l^i m^j, weighted by the same monomial: the rows that it completes
/// are those whose combinations with such weights vanish.
void add_moment(SquareMatrix<Ball>& system, std::vector<Ball>& right,
                const std::map<Place, int>& unknowns, int i, int j, const Rational& moment) {
  std::vector<Rational> weights(unknowns.size(), Rational(0));
  Rational largest(1);
  for (const auto& [place, row] : unknowns) {
    Rational weight = integer_power(place.first, i) * integer_power(place.second, j);
    if (largest < weight.abs()) largest = weight.abs();
    weights[std::size_t(row)] = std::move(weight);
  }
  const int n = system.size();
  for (int row = 0; row < n; ++row) {
    const Rational factor = weights[std::size_t(row)] / (largest * largest);
    for (int column = 0; column < n; ++column) {
      system(row, column) += Ball(factor * weights[std::size_t(column)]);
    }
    right[std::size_t(row)] += Ball(factor * moment);
  }
}

std::vector<Ball> solve_at(const FilterBank<Ball>& bank, const Functions& functions,
                           const std::map<Place, int>& unknowns) {
  const auto [p, q, r] =
      std::array{functions[0].derivative, functions[1].derivative, functions[2].derivative};
  const int d = p + q + r;
  Mask mask(bank, functions);
  SquareMatrix<Ball> system = two_scale_rows(unknowns, mask, d);
  std::vector<Ball> right(unknowns.size(), Ball(0));
  const Rational by_parts = falling_factorial(p, p) * Rational(p % 2 == 0 ? 1 : -1);
  for (int i = 0; i <= d; ++i) {
    add_moment(system, right, unknowns, i, d - i,
               by_parts * falling_factorial(i, q) * falling_factorial(d - i, r));
  }
  const auto solution = solve(system, right);
  if (!solution) {
    throw std::domain_error("the three-term system could not be proved regular");
  }
  return *solution;
}

void require_existence(const FilterDefinition& definition, const Functions& functions) {
  int square_integrable = 0, continuous = 0;
  for (const BasisFunction& f : functions) {
    if (f.wavelet) throw std::invalid_argument("three-term integrals are known for phi, not psi");
    check_between("derivative order", f.derivative, 0, highest_derivative);
    const Ball exponent = sobolev_exponent(definition, f);
    square_integrable += certainly_less(Ball(0), exponent) ? 1 : 0;
    continuous += certainly_less(Ball(Rational(1, 2)), exponent) ? 1 : 0;
  }
  if (square_integrable == 3 && continuous >= 1) return;
  throw std::domain_error("the integral of " + name_of(functions[0]) + " " + name_of(functions[1]) +
                          " " + name_of(functions[2]) + " of filter " + definition.name +
                          " is not known to exist: all three factors must be square integrable, "
                          "and one of them continuous (Sobolev exponents above 0, and above 0.5)");
}

void require_degrees(const FilterBank<Ball>& bank, const Functions& functions) {
  const int d = functions[0].derivative + functions[1].derivative + functions[2].derivative;
  for (const std::size_t i : {1u, 2u}) {
    const int degrees = functions[i].dual ? bank.dual_vanishing_moments : bank.vanishing_moments;
    if (degrees > d) continue;
    throw std::domain_error("three-term integrals with " + std::to_string(d) +
                            " derivatives need polynomials up to degree " + std::to_string(d) +
                            ", but " + name_of({false, functions[i].dual, 0}) + " of filter " +
                            bank.name + " reproduces degrees up to " + std::to_string(degrees - 1));
  }
}

}  // namespace

Ball ThreeTermIntegrals::at(int l, int m) const {
  if (l < first || l > last || m < first || m > last) return Ball(0);
  return values[std::size_t(l - first) * std::size_t(last - first + 1) + std::size_t(m - first)];
}

ThreeTermIntegrals three_term_integrals(const FilterDefinition& definition, const BasisFunction& f,
                                        const BasisFunction& g, const BasisFunction& k, long bits) {
  const Functions functions{f, g, k};
  require_existence(definition, functions);
  constexpr long first_bits = 64;
  const FilterBank<Ball> rough = definition.bank(first_bits);
  require_degrees(rough, functions);
  const auto unknowns = unknowns_of({support(rough, f), support(rough, g), support(rough, k)});
  check_between("number of unknown three-term integrals", long(unknowns.size()), 1,
                most_three_term_unknowns);
  const Filter<Ball> solution =
      accurate_values(definition, bits, [&](const FilterBank<Ball>& bank) {
        return Filter<Ball>{0, solve_at(bank, functions, unknowns)};
      });
  ThreeTermIntegrals result;
  for (const auto& [place, number] : unknowns) {
    result.first = std::min({result.first, place.first, place.second});
    result.last = std::max({result.last, place.first, place.second});
  }
  const auto side = std::size_t(result.last - result.first + 1);
  result.values.assign(side * side, Ball(0));
  for (const auto& [place, number] : unknowns) {
    result.values[std::size_t(place.first - result.first) * side +
                  std::size_t(place.second - result.first)] = solution.taps[std::size_t(number)];
  }
  return result;
}

}  // namespace wavecurve::certified
