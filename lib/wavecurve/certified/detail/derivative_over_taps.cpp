#include "wavecurve/certified/detail/derivative_over_taps.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "wavecurve/certified/detail/ball_matrix.hpp"
#include "wavecurve/certified/detail/two_scale_moments.hpp"
#include "wavecurve/certified/linear_solve.hpp"
#include "wavecurve/filters/autocorrelation.hpp"

namespace wavecurve::certified {

namespace {

/// The largest magnitude in the enclosure.
Ball largest(const Ball& x) {
  Ball upper;
  arb_get_ubound_arf(arb_midref(upper.get()), abs(x).get(), WorkingPrecision::bits());
  return upper;
}

/// All numbers of at most that magnitude.
Ball up_to(const Ball& x) {
  Ball result;
  arb_add_error(result.get(), largest(x).get());
  return result;
}

Ball larger(const Ball& a, const Ball& b) {
  const Ball of_a = largest(a), of_b = largest(b);
  return certainly_less(of_a, of_b) ? of_b : of_a;
}

/// One row for each alpha_k: its slope by each tap, and last its value in the middle, widened by
/// what is of second order.
BallMatrix autocorrelation_by_taps(const Filter<Ball>& taps) {
  const int n = taps.size();
  Filter<Ball> middle, radii;
  for (const Ball& tap : taps.taps) {
    middle.taps.push_back(tap.midpoint());
    radii.taps.push_back(tap.radius());
  }
  const Filter<Ball> alpha = autocorrelation(middle), second = autocorrelation(radii);
  BallMatrix by_taps(n, n + 1);
  for (int k = 0; k < n; ++k) {
    for (int i = 0; i < n; ++i) {
      by_taps.set(k, i, Ball(2) * radii[i] * (middle[i + k] + middle[i - k]));
    }
    by_taps.set(k, n, alpha[k] + up_to(second[k]));
  }
  return by_taps;
}

/// The system M(alpha) x = b for the x_m = F^(d)(m), m = first .. last.
class System {
 public:
  System(int taps, int d) : d_(d), first_(first_two_scale_unknown(d)), last_(taps - 2) {
    if (last_ < first_) {
      throw std::domain_error("the support is too short for a derivative of order " +
                              std::to_string(d));
    }
    weights_ = moment_weights<Ball>(last_, d);
  }

  int size() const { return last_ - first_ + 1; }
  int last() const { return last_; }

  SquareMatrix<Ball> matrix(const Filter<Ball>& alpha) const {
    SquareMatrix<Ball> m = two_scale_matrix(alpha, d_);
    for (int j = 0; j < size(); ++j) m(size() - 1, j) = weights_[static_cast<std::size_t>(j)];
    return m;
  }

  std::vector<Ball> right_hand_side() const {
    std::vector<Ball> b(weights_.size(), Ball(0));
    b.back() = moment<Ball>(d_);
    return b;
  }

  /// b - M(alpha) x, where the columns say how alpha depends on the taps; the last is its value.
  BallMatrix residual(const std::vector<Ball>& x, const BallMatrix& alpha_by_taps) const {
    const long taps = arb_mat_nrows(alpha_by_taps.value), columns = taps + 1;
    BallMatrix residual(size(), columns);
    arb_mat_mul(residual.value, minus_by_autocorrelation(x, taps).value, alpha_by_taps.value,
                WorkingPrecision::bits());
    Ball last = moment<Ball>(d_);
    for (int j = 0; j < size(); ++j) {
      const auto at = static_cast<std::size_t>(j);
      last -= weights_[at] * x[at];
      if (j + 1 < size()) residual.set(j, taps, residual.get(j, taps) + x[at]);
    }
    residual.set(size() - 1, taps, last);
    return residual;
  }

 private:
  /// The linear map from alpha to -(M(alpha) + 1) x, filters/two_scale_matrix.hpp. The last
  /// equation is that of (S), in which there is no alpha.
  BallMatrix minus_by_autocorrelation(const std::vector<Ball>& x, long taps) const {
    BallMatrix map(size(), taps);
    const Ball scale = integer_power<Ball>(2, d_) / Ball(2);
    const auto subtract = [&](int row, int k, const Ball& term) {
      if (k < taps) map.set(row, k, map.get(row, k) - term);
    };
    for (int l = first_; l < last_; ++l) {
      for (int m = first_; m <= last_; ++m) {
        const Ball term = scale * x[static_cast<std::size_t>(m - first_)];
        subtract(l - first_, std::abs(2 * l - m), term);
        if (m > 0) subtract(l - first_, 2 * l + m, d_ % 2 == 0 ? term : -term);
      }
    }
    return map;
  }

  int d_, first_, last_;
  std::vector<Ball> weights_;
};

/// 1 - Y M, added up along each row.
std::vector<Ball> row_sums_of_defect(const BallMatrix& inverse, const SquareMatrix<Ball>& matrix) {
  const int n = matrix.size();
  BallMatrix product(n, n);
  arb_mat_mul(product.value, inverse.value, BallMatrix(matrix).value, WorkingPrecision::bits());
  std::vector<Ball> sums(static_cast<std::size_t>(n), Ball(0));
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      sums[static_cast<std::size_t>(i)] += abs(Ball(i == j ? 1 : 0) - product.get(i, j));
    }
  }
  return sums;
}

/// x~ + z + (y - z), see the header.
std::vector<Ball> solution_over(const std::vector<Ball>& middle, const BallMatrix& z_by_taps,
                                const std::vector<Ball>& defects) {
  const long last_column = arb_mat_ncols(z_by_taps.value) - 1;
  std::vector<Ball> z;
  Ball largest_z(0), largest_defect(0);
  for (std::size_t l = 0; l < middle.size(); ++l) {
    const auto row = static_cast<long>(l);
    z.push_back(z_by_taps.get(row, last_column));
    for (long i = 0; i < last_column; ++i) z.back() += up_to(z_by_taps.get(row, i));
    largest_z = larger(largest_z, z.back());
    largest_defect = larger(largest_defect, defects[l]);
  }
  if (!certainly_less(largest_defect, Ball(1))) {
    throw std::domain_error(
        "the taps have too few digits to prove that the two-scale system has one solution");
  }
  std::vector<Ball> x = middle;
  for (std::size_t l = 0; l < x.size(); ++l) {
    x[l] += z[l] + up_to(defects[l] * largest_z / (Ball(1) - largest_defect));
  }
  return x;
}

}  // namespace

Filter<Ball> autocorrelation_derivative_over(const Filter<Ball>& taps, int d) {
  const System system(taps.size(), d);
  // The longer the filter, the worse conditioned is its system.
  const WorkingPrecision precision(WorkingPrecision::bits() + 4 * taps.size());
  const long bits = WorkingPrecision::bits();
  const int n = system.size();
  const BallMatrix alpha_by_taps = autocorrelation_by_taps(taps);
  Filter<Ball> middle_alpha;
  for (int k = 0; k < taps.size(); ++k) {
    middle_alpha.taps.push_back(alpha_by_taps.get(k, taps.size()).midpoint());
  }
  const SquareMatrix<Ball> middle_matrix = system.matrix(middle_alpha);
  const auto middle_solution = solve(middle_matrix, system.right_hand_side());
  BallMatrix inverse(n, n);
  if (!middle_solution || !arb_mat_inv(inverse.value, BallMatrix(middle_matrix).value, bits)) {
    throw std::domain_error("the two-scale system of the printed taps is not provably regular");
  }
  std::vector<Ball> x;
  for (const Ball& value : *middle_solution) x.push_back(value.midpoint());
  arb_mat_get_mid(inverse.value, inverse.value);
  const BallMatrix residual = system.residual(x, alpha_by_taps);
  BallMatrix z(n, taps.size() + 1);
  arb_mat_mul(z.value, inverse.value, residual.value, bits);
  const auto defects = row_sums_of_defect(inverse, system.matrix(autocorrelation(taps)));
  return mirrored(solution_over(x, z, defects), system.last(), d);
}

}  // namespace wavecurve::certified
