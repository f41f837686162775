#include "wavecurve/dynamics/schulz_inverse.hpp"

#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <Eigen/QR>
#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

namespace wavecurve::dynamics {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Eigen::MatrixXd random_orthogonal(Eigen::Index size) {
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(Eigen::MatrixXd::Random(size, size));
  return qr.householderQ();
}

/// U S V^T with singular values from 1 down to 1 / condition.
Eigen::MatrixXd matrix_of_condition(Eigen::Index size, double condition) {
  Eigen::VectorXd values(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    values[i] = std::pow(condition, -static_cast<double>(i) / static_cast<double>(size - 1));
  }
  return random_orthogonal(size) * values.asDiagonal() * random_orthogonal(size);
}

TEST(SchulzInverse, SquaresTheResidualAtAnyCondition) {
  for (const double condition : {2.0, 1e2, 1e4, 1e6, 1e8}) {
    const Eigen::MatrixXd c = matrix_of_condition(24, condition);
    // Rounding leaves about the condition number times the unit, times the root of the size or so.
    const double floor = 24 * condition * epsilon;
    const auto result = schulz_inverse(c, floor);
    EXPECT_EQ(result.status, SchulzStatus::converged) << condition;
    EXPECT_LE((Eigen::MatrixXd::Identity(24, 24) - result.inverse * c).norm(), floor);
    const auto& r = result.residuals;
    for (std::size_t n = 0; n + 1 < r.size(); ++n) {
      // ||R^2||_F <= ||R||_F^2 while rounding is small beside it.
      EXPECT_LE(r[n + 1], r[n] * r[n] + floor) << condition << " step " << n;
    }
    // 2 log2(condition), 6 for the last digits, and what X_0 costs: at most log2 of the size.
    EXPECT_LE(r.size(), 2 * std::log2(condition) + 6 + 5 + 3) << condition;
    const Eigen::MatrixXd exact = c.fullPivHouseholderQr().inverse();
    EXPECT_LE((result.inverse - exact).norm(), result.error_bound + floor * exact.norm());
  }
}

TEST(SchulzInverse, SaysWhereRoundingEndsIt) {
  const auto result = schulz_inverse(matrix_of_condition(16, 1e6), 1e-15);
  EXPECT_EQ(result.status, SchulzStatus::stagnated);
  EXPECT_LT(result.residuals.back(), 1e-6);
  EXPECT_LT(result.residuals.size(), 60u);
}

TEST(SchulzInverse, IsThePseudoInverseOfASingularMatrix) {
  Eigen::MatrixXd c = Eigen::MatrixXd::Zero(12, 12);
  const Eigen::MatrixXd u = random_orthogonal(12), v = random_orthogonal(12);
  Eigen::MatrixXd pseudo = c;
  for (Eigen::Index i = 0; i < 9; ++i) {
    c += (1.0 + static_cast<double>(i)) * u.col(i) * v.col(i).transpose();
    pseudo += 1 / (1.0 + static_cast<double>(i)) * v.col(i) * u.col(i).transpose();
  }
  const auto result = schulz_inverse(c, 1e-12);
  EXPECT_EQ(result.status, SchulzStatus::singular);
  EXPECT_NEAR(result.residuals.back(), std::sqrt(3), 1e-10);
  EXPECT_TRUE(std::isinf(result.error_bound));
  EXPECT_LT((result.inverse - pseudo).norm(), 1e-10);
  const auto zero = schulz_inverse(Eigen::MatrixXd::Zero(3, 3), 1e-12);
  EXPECT_EQ(zero.status, SchulzStatus::singular);
  EXPECT_EQ(zero.inverse.norm(), 0);
  const auto stiffness = wavecurve::stiffness(find_filter_bank<double>("db4"), 32, 5);
  EXPECT_EQ(schulz_inverse(stiffness, 1e-12, 0).status, SchulzStatus::singular);
}

TEST(SchulzInverse, SparseIsDenseButForWhatItDrops) {
  const auto bank = find_filter_bank<double>("db4");
  const Eigen::SparseMatrix<double> c = damping(bank, 128, 4, 1, 1e-5);
  const Eigen::MatrixXd exact = Eigen::MatrixXd(c).inverse();
  const auto whole = schulz_inverse(c, 1e-13, 0);
  EXPECT_EQ(whole.status, SchulzStatus::converged);
  EXPECT_LT((Eigen::MatrixXd(whole.inverse) - exact).norm(), 1e-12 * exact.norm());
  for (const double threshold : {1e-4, 1e-8}) {
    const auto result = schulz_inverse(c, 1e-13, threshold);
    EXPECT_EQ(result.status, SchulzStatus::stagnated);
    EXPECT_LT(result.inverse.nonZeros(), whole.inverse.nonZeros());
    const double error = (Eigen::MatrixXd(result.inverse) - exact).norm();
    EXPECT_LE(error, result.error_bound * (1 + 1e-6)) << threshold;
    EXPECT_LE(result.error_bound, 1e4 * threshold);
    EXPECT_GT(result.dropped.back(), 0);
  }
}

TEST(SchulzInverse, RefusesWhatHasNoInverse) {
  EXPECT_THROW(schulz_inverse(Eigen::MatrixXd::Ones(2, 3), 1e-9), std::invalid_argument);
  EXPECT_THROW(schulz_inverse(Eigen::MatrixXd(), 1e-9), std::invalid_argument);
  EXPECT_THROW(schulz_inverse(Eigen::MatrixXd::Constant(2, 2, NAN), 1e-9), std::invalid_argument);
  EXPECT_THROW(schulz_inverse(Eigen::MatrixXd::Ones(2, 2), 0), std::invalid_argument);
  EXPECT_THROW(schulz_inverse(Eigen::SparseMatrix<double>(2, 2), 1e-9, 1), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::dynamics
