#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/certified/detail/ball_matrix.hpp"
#include "wavecurve/certified/detail/families/family.hpp"
#include "wavecurve/certified/detail/polynomial.hpp"
#include "wavecurve/certified/linear_solve.hpp"

// Coiflets of order K: 6K taps h_n, n = -2K .. 4K-1; psi has 2K vanishing moments and phi the
// moments int x^j phi = 0 for j = 1 .. 2K-1.
//
// The system. With y = sin^2(w/2), every filter with these moments and this support is
//   h / sqrt 2  <->  m(w) = (1-y)^K [P_K(y) + y^K f(w)],   f(w) = sum_{n=0}^{2K-1} f_n e^{-inw}
// (Daubechies 1993). Orthonormality demands E(w) = |m(w)|^2 + |m(w+pi)|^2 - 1 = 0, an even
// trigonometric polynomial in 2w of degree 3K-1. Since (1-y)^K P_K(y) = 1 - y^K P_K(1-y), E
// vanishes at w = 0 to the order 2K, so that E = sin^{2K}(w) e(cos 2w) with e of degree 2K-1. Hence
// E = 0 follows from its highest 2K Fourier coefficients alone:
//   F_j(f) = sum_n m_n m_{n+2j} = 0,   j = K .. 3K-1:                  2K equations, 2K unknowns.
//
// The solution. Newton's iteration from f = 0, the symmetric interpolating filter, converges to the
// coiflet of the established tables, the solution nearest to that filter. An interval Newton step
// then proves that a box around the result holds exactly one solution, and encloses it.

namespace wavecurve::certified {

namespace {

constexpr int highest_coiflet_order = 17;

class CoifletSystem {
 public:
  explicit CoifletSystem(int order) : K_(order) {
    const auto cosine = in_sine_squared(power(Polynomial<Rational>{1, -1}, K_));  // (1-y)^K
    const auto fixed = cosine * in_sine_squared(halfband_polynomial(K_));
    fixed_ = {1 - 2 * K_, {fixed.begin(), fixed.end()}};
    Polynomial<Rational> y_power(static_cast<std::size_t>(K_) + 1, Rational(0));
    y_power.back() = 1;
    const auto direction = cosine * in_sine_squared(y_power);
    direction_ = {-2 * K_, {direction.begin(), direction.end()}};
  }

  int unknowns() const { return 2 * K_; }

  /// m_n for n = -2K .. 4K-1.
  Filter<Ball> mask(const std::vector<Ball>& f) const {
    Filter<Ball> m{-2 * K_, std::vector<Ball>(static_cast<std::size_t>(6 * K_))};
    for (int n = m.first_index; n <= m.last_index(); ++n) {
      Ball& tap = m.taps[static_cast<std::size_t>(n - m.first_index)];
      tap = fixed_[n];
      for (int k = 0; k < unknowns(); ++k)
        tap += direction_[n - k] * f[static_cast<std::size_t>(k)];
    }
    return m;
  }

  std::vector<Ball> residual(const std::vector<Ball>& f) const {
    const Filter<Ball> m = mask(f);
    std::vector<Ball> values;
    for (int j = K_; j < 3 * K_; ++j) {
      Ball sum(0);
      for (int n = m.first_index; n + 2 * j <= m.last_index(); ++n) sum += m[n] * m[n + 2 * j];
      values.push_back(sum);
    }
    return values;
  }

  /// dF_j / df_k = c_{k+2j} + c_{k-2j}, c_s = sum_i d_i m_{i+s}, d the direction of f.
  SquareMatrix<Ball> jacobian(const std::vector<Ball>& f) const {
    const Filter<Ball> m = mask(f);
    Filter<Ball> c{m.first_index - direction_.last_index(), {}};
    for (int s = c.first_index; s + direction_.first_index <= m.last_index(); ++s) {
      Ball sum(0);
      for (int i = direction_.first_index; i <= direction_.last_index(); ++i) {
        sum += direction_[i] * m[i + s];
      }
      c.taps.push_back(sum);
    }
    SquareMatrix<Ball> derivative(unknowns());
    for (int row = 0; row < unknowns(); ++row) {
      const int lag = 2 * (K_ + row);
      for (int k = 0; k < unknowns(); ++k) derivative(row, k) = c[k + lag] + c[k - lag];
    }
    return derivative;
  }

 private:
  int K_;
  Filter<Ball> fixed_, direction_;
};

std::vector<Ball> newton_step(const CoifletSystem& system, const std::vector<Ball>& at,
                              const std::vector<Ball>& box) {
  const auto step = solve(system.jacobian(box), system.residual(at));
  if (!step) throw std::domain_error("the Jacobian of the coiflet system is not provably regular");
  std::vector<Ball> next = at;
  for (std::size_t k = 0; k < next.size(); ++k) next[k] -= (*step)[k];
  return next;
}

/// x -= M y on midpoints, at the working precision. The binary exponent of the largest step; none if all
/// are zero.
std::optional<long> subtract_product(std::vector<Ball>& x, const BallMatrix& m,
                                     const std::vector<Ball>& y) {
  const long n = static_cast<long>(x.size());
  BallMatrix right(n, 1), step(n, 1);
  for (long i = 0; i < n; ++i) right.set(i, 0, y[static_cast<std::size_t>(i)].midpoint());
  arb_mat_approx_mul(step.value, m.value, right.value, WorkingPrecision::bits());
  std::optional<long> exponent;
  for (long i = 0; i < n; ++i) {
    Ball& value = x[static_cast<std::size_t>(i)];
    value = (value - step.get(i, 0)).midpoint();
    arf_srcptr middle = arb_midref(arb_mat_entry(step.value, i, 0));
    if (arf_is_zero(middle)) continue;
    exponent = std::max(exponent.value_or(ARF_EXP(middle)), ARF_EXP(middle));
  }
  return exponent;
}

/// An approximate inverse of the Jacobian at f.
BallMatrix inverse_jacobian(const CoifletSystem& system, const std::vector<Ball>& f) {
  BallMatrix inverse(system.unknowns(), system.unknowns());
  if (!arb_mat_approx_inv(inverse.value, BallMatrix(system.jacobian(f)).value,
                          WorkingPrecision::bits())) {
    throw std::domain_error("the Jacobian of the coiflet system is not regular");
  }
  return inverse;
}

/// Newton from f = 0 on midpoints, at a precision of which 64 bits are left when the conditioning has
/// taken its 12 K; then the same steps at the working precision, with the inverse of the last Jacobian, each of
/// which multiplies the error by that of this inverse, until they no longer shrink.
std::vector<Ball> approximate_solution(const CoifletSystem& system) {
  std::vector<Ball> f(static_cast<std::size_t>(system.unknowns()), Ball(0));
  std::optional<BallMatrix> inverse;
  {
    const WorkingPrecision rough(std::min(WorkingPrecision::bits(), 64 + 6L * system.unknowns()));
    constexpr int most_steps = 16;
    constexpr long small_step = -32;  // the square of it is far below what is kept
    for (int i = 0; i < most_steps; ++i) {
      inverse.emplace(inverse_jacobian(system, f));
      const auto exponent = subtract_product(f, *inverse, system.residual(f));
      if (!exponent || *exponent < small_step) break;
    }
  }
  for (std::optional<long> before;;) {
    const auto exponent = subtract_product(f, *inverse, system.residual(f));
    if (!exponent || (before && *exponent >= *before - 1)) return f;
    before = exponent;
  }
}

/// The enclosure of the one solution in a box around the approximation, by interval Newton:
/// N(X) = f - J(X)^{-1} F(f) inside X proves existence and uniqueness in X.
std::optional<std::vector<Ball>> unique_solution(const CoifletSystem& system) {
  const std::vector<Ball> f = approximate_solution(system);
  const Rational radius = Rational::power_of_two(-WorkingPrecision::bits() / 2);
  std::vector<Ball> box = f;
  for (Ball& value : box) arb_add_error(value.get(), Ball(radius).get());
  const std::vector<Ball> enclosure = newton_step(system, f, box);
  for (std::size_t k = 0; k < box.size(); ++k) {
    if (!arb_contains_interior(box[k].get(), enclosure[k].get())) return std::nullopt;
  }
  return newton_step(system, f, enclosure);
}

FilterBank<Ball> coiflet_bank(const std::string& name, int order) {
  // The monomial basis makes J ill-conditioned: the enclosures lose about 12 K bits, and the box,
  // of half the bits, must stay wider than that loss.
  const WorkingPrecision precision(WorkingPrecision::bits() + 24 * order);
  const CoifletSystem system(order);
  const auto f = unique_solution(system);
  if (!f)
    throw std::runtime_error("interval Newton did not enclose the coiflet of order " +
                             std::to_string(order));
  return orthonormal_bank(name, system.mask(*f), 2 * order);
}

std::optional<FilterDefinition> define_coiflet(std::string_view name) {
  return define_by_order("coif", name, 1, highest_coiflet_order, coiflet_bank);
}

}  // namespace

Family coiflet_family() {
  Family family{"coif1-coif17 (aliases K1-K17, c6-c102)", {}, {}, define_coiflet};
  for (int order = 1; order <= highest_coiflet_order; ++order) {
    const std::string name = fmt::format("coif{}", order);
    family.members.push_back(name);
    family.aliases.emplace_back(fmt::format("K{}", order), name);
    family.aliases.emplace_back(fmt::format("c{}", 6 * order), name);
  }
  return family;
}

}  // namespace wavecurve::certified
