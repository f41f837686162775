#include "wavecurve/certified/integrals/homogeneous_operator.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/certified/basis_function.hpp"
#include "wavecurve/certified/detail/is_accurate.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/certified/linear_solve.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

/// The correlation F of phi with itself.
struct Correlation {
  Filter<Ball> mask;          ///< c_k, k = -W .. W
  std::vector<Ball> moments;  ///< int u^m F(u) du, m < M
  Ball absolute_integral;     ///< at least int |F|
  int reach() const { return mask.last_index(); }
};

/// M_p (2^p - 1) = sum_{k=1}^p binomial(p, k) m_k M_{p-k}, m_k = 1/2 sum_n n^k c_n.
std::vector<Ball> moments_of(const Filter<Ball>& mask, int count) {
  std::vector<Ball> discrete, result;
  std::vector<Ball> powers = mask.taps;
  for (int k = 0; k < count; ++k) {
    Ball sum(0);
    for (int n = mask.first_index; n <= mask.last_index(); ++n) {
      Ball& power = powers[static_cast<std::size_t>(n - mask.first_index)];
      sum += power;
      power *= Ball(n);
    }
    discrete.push_back(sum / Ball(2));
  }
  std::vector<Ball> binomials{Ball(1)};  // the row p of Pascal's triangle
  for (int p = 0; p < count; ++p) {
    if (p == 0) {
      result.push_back(Ball(1));
      continue;
    }
    binomials.push_back(Ball(0));
    for (std::size_t k = binomials.size() - 1; k > 0; --k) binomials[k] += binomials[k - 1];
    Ball sum(0);
    for (std::size_t k = 1; k <= static_cast<std::size_t>(p); ++k) {
      sum += binomials[k] * discrete[k] * result[static_cast<std::size_t>(p) - k];
    }
    result.push_back(sum / (Ball(Rational::power_of_two(p)) - Ball(1)));
  }
  return result;
}

Correlation correlation_of(const FilterBank<Ball>& bank, const Ball& norm_squared, int terms) {
  const Filter<Ball> a = two_scale_coefficients(bank, {});
  const int reach = a.size() - 1;
  Correlation result;
  result.mask.first_index = -reach;
  for (int k = -reach; k <= reach; ++k) {
    Ball sum(0);
    for (int i = a.first_index; i <= a.last_index(); ++i) sum += a[i] * a[i + k];
    result.mask.taps.push_back(sum / Ball(2));
  }
  result.moments = moments_of(result.mask, terms);
  result.absolute_integral = Ball(reach) * norm_squared;
  return result;
}

/// zeta(sigma, a) = sum_{j >= 0} (a + j)^-sigma, continued to all sigma but 1.
Ball hurwitz_zeta(const Rational& sigma, const Ball& a) {
  Ball result;
  arb_hurwitz_zeta(result.get(), Ball(sigma).get(), a.get(), WorkingPrecision::bits());
  return result;
}

Ball gamma_function(const Rational& x) {
  Ball result;
  arb_gamma_fmpq(result.get(), x.get(), WorkingPrecision::bits());
  return result;
}

/// K(t) t^(s+1) for t > 0.
Ball kernel_coefficient(const HomogeneousOperator& op) {
  using Kind = HomogeneousOperator::Kind;
  if (op.kind == Kind::fractional) return Ball(1) / gamma_function(-op.order);
  const Ball angle = Ball::pi() * Ball(op.order / Rational(2));
  const Ball size = gamma_function(op.order + Rational(1)) / Ball::pi();
  return op.kind == Kind::riesz ? -size * sin(angle) : size * cos(angle);
}

/// How K(-t) follows from K(t).
enum class Parity { even, odd, one_sided };

Parity parity_of(HomogeneousOperator::Kind kind) {
  using Kind = HomogeneousOperator::Kind;
  if (kind == Kind::fractional) return Parity::one_sided;
  return kind == Kind::riesz ? Parity::even : Parity::odd;
}

class OperatorSystem {
 public:
  OperatorSystem(const HomogeneousOperator& op, const Correlation& f)
      : f_(f), order_(op.order), parity_(parity_of(op.kind)) {
    scale_ = exp(Ball(order_) * log(Ball(2)));
    Ball coefficient = kernel_coefficient(op);  // of K^(m)(t) / m! = coefficient t^(-s-1-m)
    for (std::size_t m = 0; m <= f.moments.size(); ++m) {
      taylor_.push_back(coefficient);
      const long next = static_cast<long>(m) + 1;
      coefficient *= Ball(-order_ - Rational(next)) / Ball(next);
    }
  }

  /// r_l for |l| <= largest, the series being used from `far` on.
  Filter<Ball> solve(int largest, int far) const {
    const int reach = f_.reach();
    const int end = std::max(2 * far + reach, largest);
    std::vector<Ball> right_side(static_cast<std::size_t>(end + 1), Ball(0));  // r_l, l >= 0
    for (int l = end; l > reach; --l) {
      right_side[static_cast<std::size_t>(l)] = l >= far ? series(l) : two_scale(right_side, l);
    }
    Filter<Ball> result{-largest, {}};
    const Filter<Ball> middle = solve_middle(right_side);
    for (int l = -largest; l <= largest; ++l) {
      const Ball& beyond = right_side[static_cast<std::size_t>(std::abs(l))];
      if (std::abs(l) <= reach) {
        result.taps.push_back(middle[l]);
      } else if (l > 0) {
        result.taps.push_back(beyond);
      } else {
        result.taps.push_back(reflected(beyond));
      }
    }
    return result;
  }

  /// sum_j r_{l + n j}, l = 0 .. n - 1: one by one below `end`, and beyond it by the zeta functions, to this many
  /// bits. Behind them stands |r_0| + |r_1|, the scale of what is added: the sums themselves may vanish.
  Filter<Ball> solve_periodic(int n, int far, long bits) const {
    const int end = n * (distant_reaches * f_.reach() / n + 2);  // at least a period more
    const Filter<Ball> near = solve(end - 1, far);
    Filter<Ball> result{0, {}};
    for (int l = 0; l < n; ++l) {
      const bool is_own_opposite = parity_ == Parity::odd && 2 * l % n == 0;  // r_l = -r_{n-l}
      if (n == 1 || is_own_opposite) {                                        // constants vanish
        result.taps.emplace_back(0);
        continue;
      }
      const int before = l == 0 ? end : end + n - l;
      Ball sum(0);
      for (int i = n - before; i < end; i += n) sum += near[i];
      const WorkingPrecision precision(bits);
      sum += distant_sum(l + end, n);
      if (parity_ != Parity::one_sided) sum += reflected(distant_sum(before, n));
      result.taps.push_back(std::move(sum));
    }
    result.taps.push_back(abs(near[0]) + abs(near[1]));
    return result;
  }

 private:
  /// From so many times W on, terms of the series fall by six bits each.
  static constexpr int distant_reaches = 64;

  /// sum_{j >= 0} r_{start + n j}, the series being summed term by term: K^(m) gives zeta(s + 1 + m, start / n).
  /// For m = 0 of an odd kernel of order 0 that is infinite, and -digamma(start / n) stands for it: both differ by the
  /// same from the sum up to any j, so that the difference of two sums is right.
  Ball distant_sum(int start, int n) const {
    const long bits = WorkingPrecision::bits();
    const std::size_t terms = std::min(f_.moments.size(), static_cast<std::size_t>(bits / 6 + 8));
    const Ball a(Rational(start, n));
    const Rational sigma = order_ + Rational(1);
    const Ball inverse = Ball(1) / Ball(n);
    Ball power = exp(-Ball(sigma) * log(Ball(n)));
    Ball sum(0);
    for (std::size_t m = 0; m < terms; ++m) {
      const Rational exponent = sigma + Rational(static_cast<long>(m));
      if (exponent == Rational(1) && parity_ == Parity::odd) {
        Ball digamma;
        arb_digamma(digamma.get(), a.get(), bits);
        sum -= taylor_[m] * power * f_.moments[m] * digamma;
      } else if (!taylor_[m].contains_zero()) {  // K is a polynomial of a degree below m
        sum += taylor_[m] * power * f_.moments[m] * hurwitz_zeta(exponent, a);
      }
      power *= inverse;
    }
    // The remainders of all r_l, as in series.
    const Ball nearest(Rational(start - f_.reach(), n));
    const Ball remainder = abs(taylor_[terms]) * power *
                           hurwitz_zeta(sigma + Rational(static_cast<long>(terms)), nearest) *
                           pow(Ball(f_.reach()), static_cast<unsigned long>(terms)) *
                           f_.absolute_integral;
    arb_add_error(sum.get(), remainder.get());
    return sum;
  }

  /// r_{-l} of r_l, l > W.
  Ball reflected(const Ball& value) const {
    if (parity_ == Parity::one_sided) return Ball(0);
    return parity_ == Parity::odd ? -value : value;
  }

  Ball series(int l) const {
    const Ball inverse = Ball(1) / Ball(l);
    Ball power = exp(-(Ball(order_) + Ball(1)) * log(Ball(l)));
    Ball sum(0);
    for (std::size_t m = 0; m < f_.moments.size(); ++m) {
      sum += taylor_[m] * power * f_.moments[m];
      power *= inverse;
    }
    // The remainder, at the end of [l - W, l + W] where t^(-s-1-M) is largest.
    const Ball nearest = log(Ball(l - f_.reach()));
    const long terms = static_cast<long>(f_.moments.size());
    const Ball steepest = exp(-(Ball(order_) + Ball(1 + terms)) * nearest);
    const Ball remainder = abs(taylor_.back()) * steepest *
                           pow(Ball(f_.reach()), static_cast<unsigned long>(terms)) *
                           f_.absolute_integral;
    arb_add_error(sum.get(), remainder.get());
    return sum;
  }

  Ball two_scale(const std::vector<Ball>& known, int l) const {
    Ball sum(0);
    for (int k = -f_.reach(); k <= f_.reach(); ++k) {
      sum += f_.mask[k] * known[static_cast<std::size_t>(2 * l + k)];
    }
    return scale_ * sum;
  }

  /// The least l of an unknown: of odd and even sequences one side is enough, and where K(t) vanishes for
  /// t < 0 it vanishes from -W on.
  int first_unknown() const {
    if (parity_ == Parity::one_sided) return 1 - f_.reach();
    return parity_ == Parity::odd ? 1 : 0;
  }

  /// r_l for |l| <= W.
  Filter<Ball> solve_middle(const std::vector<Ball>& known) const {
    const int reach = f_.reach();
    const int first = first_unknown();
    SquareMatrix<Ball> matrix(reach - first + 1);
    std::vector<Ball> right(static_cast<std::size_t>(matrix.size()), Ball(0));
    for (int l = first; l <= reach; ++l) {
      const int row = l - first;
      matrix(row, row) += Ball(1);
      for (int k = -reach; k <= reach; ++k) {
        const int j = 2 * l + k;
        const Ball factor = scale_ * f_.mask[k];
        if (j > reach) {
          right[static_cast<std::size_t>(row)] += factor * known[static_cast<std::size_t>(j)];
        } else if (j >= first) {
          matrix(row, j - first) -= factor;
        } else if (parity_ != Parity::one_sided && j < 0) {
          matrix(row, -j - first) -= reflected(factor);
        }
      }
    }
    const auto solution = certified::solve(matrix, right);
    if (!solution) {
      throw std::domain_error("the two-scale system of an operator of order " + order_.to_string() +
                              " could not be proved regular");
    }
    Filter<Ball> result{-reach, {}};
    for (int l = -reach; l <= reach; ++l) {
      if (l >= first) {
        result.taps.push_back((*solution)[static_cast<std::size_t>(l - first)]);
      } else if (l < 0 && -l - first < matrix.size()) {
        result.taps.push_back(reflected((*solution)[static_cast<std::size_t>(-l - first)]));
      } else {
        result.taps.push_back(Ball(0));
      }
    }
    return result;
  }

  const Correlation& f_;
  Rational order_;
  Parity parity_;
  Ball scale_;
  std::vector<Ball> taylor_;
};

/// What the operator is where the two-scale system is singular for it: a derivative.
bool is_derivative(const HomogeneousOperator& op) {
  using Kind = HomogeneousOperator::Kind;
  const bool is_whole = fmpz_is_one(fmpq_denref(op.order.get())) != 0 && op.order.sign() >= 0;
  if (!is_whole) return false;
  const bool is_even = fmpz_is_even(fmpq_numref(op.order.get())) != 0;
  return op.kind == Kind::fractional || is_even == (op.kind == Kind::riesz);
}

void check_operator(const HomogeneousOperator& op) {
  using Kind = HomogeneousOperator::Kind;
  const std::string order = op.order.to_string();
  if (is_derivative(op)) {
    throw std::invalid_argument(fmt::format(
        "order of {} is {}, but must not be {}: the two-scale system is singular for it; "
        "derivative:{} is computed as an integral of a product",
        op.kind == Kind::fractional ? "a fractional derivative"
        : op.kind == Kind::riesz    ? "Riesz' derivative"
                                    : "a Hilbert transform",
        order,
        op.kind == Kind::fractional ? "a whole number >= 0"
        : op.kind == Kind::riesz    ? "an even number >= 0"
                                    : "an odd number",
        order));
  }
  const Rational most(highest_derivative);
  const bool is_one_sided = op.kind == Kind::fractional;
  const bool is_high_enough = is_one_sided ? op.order >= -most : op.order > Rational(-1);
  if (op.order <= most && is_high_enough) return;
  throw std::invalid_argument(
      must_be("order of an operator", order,
              is_one_sided ? fmt::format("from -{0} to {0}", highest_derivative)
                           : fmt::format("above -1 and at most {}", highest_derivative)));
}

void require_smoothness(const FilterDefinition& definition, const HomogeneousOperator& op) {
  const Rational needed = std::max(op.order / Rational(2), Rational(0));
  if (is_proved_smoother(definition, needed)) return;
  const WorkingPrecision precision(128);
  throw std::domain_error(fmt::format(
      "filter {} is not smooth enough for an operator of order {}: its Sobolev exponent is {}, "
      "but it must exceed {}",
      definition.name, op.order.to_string(),
      round_to_digits(sobolev_exponent(definition), 4).value_or("not known well enough"),
      round_to_digits(needed, 4)));
}

/// solve(system, far, working bits) at rising precision, `far` the first l of the series.
template <class Solve>
Filter<Ball> solve_accurately(const FilterDefinition& definition, const HomogeneousOperator& op,
                              long bits, Solve solve) {
  check_operator(op);
  require_smoothness(definition, op);
  const Ball norm_squared = product_integrals(definition, {{{{}, false}, {{}}}}, bits + 64).at({0});
  return accurate_values(definition, bits, [&](const FilterBank<Ball>&) {
    // From 9 W on each term is an eighth of the one before: three bits.
    const long working = WorkingPrecision::bits();
    const int terms = static_cast<int>(working / 3) + 16;
    // Moments grow like W^m, and the sums for them cancel.
    const WorkingPrecision precision(working + 12L * terms);
    const Correlation f =
        correlation_of(definition.bank(working + 12L * terms), norm_squared, terms);
    const OperatorSystem system(op, f);
    return solve(system, 9 * f.reach() + 1, working);
  });
}

}  // namespace

Filter<Ball> operator_coefficients(const FilterDefinition& definition,
                                   const HomogeneousOperator& op, int largest, long bits) {
  check_between("largest shift of an operator", largest, 0, largest_shift);
  return solve_accurately(definition, op, bits,
                          [&](const OperatorSystem& system, int far, long /*working*/) {
                            return system.solve(largest, far);
                          });
}

Filter<Ball> periodic_operator_coefficients(const FilterDefinition& definition,
                                            const HomogeneousOperator& op, int period, long bits) {
  check_between("period of an operator", period, 1, largest_operator_period);
  Filter<Ball> result = solve_accurately(definition, op, bits,
                                         [&](const OperatorSystem& system, int far, long working) {
                                           return system.solve_periodic(period, far, working);
                                         });
  result.taps.pop_back();
  return result;
}

}  // namespace wavecurve::certified
