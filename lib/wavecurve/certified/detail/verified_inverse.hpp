#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/certified/ball.hpp"

namespace wavecurve::certified {

/// The approximate inverse R of a matrix B in double precision, with proof that B is regular.
///
/// B is known up to a bound e of the row sums of |B - B'|, B' being the matrix of doubles given. If
///   delta = ||I - R B'|| + ||R|| e < 1   (row sums; the rounding of each step is bounded, too),
/// then B is regular, and for every b and every x' (Rump, "Verification methods", Acta Numerica
/// 2010)
///   |x - x'| <= |R r| + delta / (1 - delta) ||R r||,   B x = b,   r = b - B x'.
/// So a solution of any precision costs products with B at that precision and with R in double, one
/// for every 40 bits or so, instead of an elimination on enclosures.
class VerifiedInverse {
 public:
  /// Empty if delta < 1 could not be proved.
  static std::optional<VerifiedInverse> of(const Eigen::MatrixXd& matrix, double row_error);

  /// Each step of solve() leaves this part of the error at most.
  double delta() const { return delta_; }

  /// x with B x = b. residual(x') is r, as enclosures at the working precision, which is what
  /// bounds the accuracy of x.
  std::vector<Ball> solve(
      const std::function<std::vector<Ball>(const std::vector<Ball>&)>& residual) const;

 private:
  VerifiedInverse(Eigen::MatrixXd inverse, double delta)
      : inverse_(std::move(inverse)), delta_(delta) {}
  std::vector<Ball> within_bounds(std::vector<Ball> x, const std::vector<Ball>& residual) const;

  Eigen::MatrixXd inverse_;
  double delta_;
};

}  // namespace wavecurve::certified
