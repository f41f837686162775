#include "circulant_stiffness.hpp"

#include <limits>
#include <numbers>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve::verification {
namespace {

class CirculantStiffness : public testing::TestWithParam<int> {};

TEST_P(CirculantStiffness, IsSymmetricAndAnnihilatesConstants) {
  const int samples = GetParam();
  const Eigen::MatrixXd stiffness = circulant_stiffness(find_filter_bank("db4"), samples);
  // Rows sum at most 13 terms, each rounded to within its own size times epsilon.
  const double tolerance = 32 * std::numeric_limits<double>::epsilon() * samples * samples * 8;
  EXPECT_LE((stiffness - stiffness.transpose()).cwiseAbs().maxCoeff(), tolerance);
  EXPECT_LE(stiffness.rowwise().sum().cwiseAbs().maxCoeff(), tolerance);
}

INSTANTIATE_TEST_SUITE_P(Sizes, CirculantStiffness, testing::Values(1, 2, 4, 8, 16, 64));

TEST(CirculantStiffnessMatrix, FirstEigenvalueTendsToThatOfTheSecondDerivative) {
  const double exact = 4 * std::numbers::pi * std::numbers::pi;
  double last = 1;
  for (int samples = 8; samples <= 64; samples *= 2) {
    const Eigen::MatrixXd stiffness = circulant_stiffness(find_filter_bank("db4"), samples);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, Eigen::EigenvaluesOnly);
    const double error = std::abs(solver.eigenvalues()(1) - exact) / exact;
    EXPECT_LT(error, last / 8) << samples;
    last = error;
  }
}

TEST(CirculantStiffnessMatrix, RefusesNoSamples) {
  EXPECT_THROW(circulant_stiffness(find_filter_bank("db4"), 0), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve::verification
