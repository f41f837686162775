#include "wavecurve/operators/spectrum.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"

namespace wavecurve {
namespace {

constexpr double tolerance = 1e-6;  // what the header promises

// The multiscale matrix of an orthonormal bank is similar to the circulant of the finest level.
TEST(ExtremeEigenvalues, AreTheCirculantsForAnOrthonormalBank) {
  const FilterBank<double> bank = find_filter_bank<double>("db4");
  for (int p : {0, 1}) {
    for (int exponent : {1, 5, 6, 10}) {
      const int samples = 1 << exponent;
      const Eigen::VectorXd exact =
          circulant_eigenvalues(connection_coefficients(bank, p, p).mu, samples, 2 * p);
      for (int levels : {0, 1, exponent}) {
        const ExtremeEigenvalues found = extreme_eigenvalues(bank, samples, levels, p);
        const double smallest = exact.tail(samples - p).minCoeff();
        EXPECT_NEAR(found.smallest, smallest, tolerance * smallest);
        EXPECT_NEAR(found.largest, exact.maxCoeff(), tolerance * exact.maxCoeff());
      }
    }
  }
}

TEST(ExtremeEigenvalues, AreTheDenseMatrixsForABiorthogonalBank) {
  const FilterBank<double> bank = find_filter_bank<double>("bspline4.4");
  for (int p : {0, 1}) {
    for (int levels : {0, 2, 7}) {
      const Eigen::MatrixXd matrix = multiscale_matrix(bank, 128, levels, p, p);
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> dense(matrix, Eigen::EigenvaluesOnly);
      const ExtremeEigenvalues found = extreme_eigenvalues(bank, 128, levels, p);
      const double smallest = dense.eigenvalues()[p], largest = dense.eigenvalues()[127];
      EXPECT_NEAR(found.smallest, smallest, tolerance * smallest);
      EXPECT_NEAR(found.largest, largest, tolerance * largest);
      EXPECT_NEAR(found.condition_number(), largest / smallest, 2 * tolerance * largest / smallest);
    }
  }
}

/// Hats on every level; the analysis low-pass takes every second sample and has no zero at z = -1,
/// so that the dual functions do not reproduce constants.
FilterBank<double> hierarchical_hats() {
  const double root = std::numbers::sqrt2;
  auto bank =
      make_filter_bank<double>("hierarchical", {0, {root}}, {-1, {root / 4, root / 2, root / 4}});
  bank.vanishing_moments = 2;
  bank.sobolev_exponent = 1.5;
  return bank;
}

// With all levels, since fewer keep the modes apart by their symmetry.
TEST(ExtremeEigenvalues, NeedNoDualVanishingMoments) {
  const FilterBank<double> bank = hierarchical_hats();
  const Eigen::MatrixXd matrix = stiffness(bank, 128, 7);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> dense(matrix, Eigen::EigenvaluesOnly);
  const ExtremeEigenvalues found = extreme_eigenvalues(bank, 128, 7, 1);
  EXPECT_NEAR(found.smallest, dense.eigenvalues()[1], tolerance * dense.eigenvalues()[1]);
  EXPECT_NEAR(found.largest, dense.eigenvalues()[127], tolerance * dense.eigenvalues()[127]);
}

// In one dimension the hierarchical basis is orthogonal for the stiffness (a classic of finite
// elements): K is diagonal but for the scaling functions among themselves.
TEST(Stiffness, IsDiagonalInTheHierarchicalBasis) {
  const Eigen::MatrixXd k = stiffness(hierarchical_hats(), 64, 4);
  Eigen::MatrixXd rest = k;
  rest.topLeftCorner(4, 4).setZero();
  rest.diagonal().setZero();
  EXPECT_LE(rest.cwiseAbs().maxCoeff(), 1e-14 * k.cwiseAbs().maxCoeff());
  EXPECT_GT(k.diagonal().minCoeff(), 1);
}

TEST(CirculantEigenvalues, AreThoseOfTheDenseCirculant) {
  const auto mu = connection_coefficients(find_filter_bank<double>("db4"), 1, 1).mu;
  for (int samples : {1, 2, 4, 16}) {  // the support exceeds the period up to 8
    const Eigen::VectorXd column = circulant_column(mu, samples, 2);
    const Eigen::VectorXd values = circulant_eigenvalues(mu, samples, 2);
    for (int k = 0; k < samples; ++k) {
      double sum = 0;
      for (int r = 0; r < samples; ++r) {
        sum += column[r] * std::cos(2 * std::numbers::pi * k * r / samples);
      }
      EXPECT_NEAR(values[k], sum, 1e-13 * samples * samples);
    }
  }
  EXPECT_THROW(circulant_eigenvalues(mu, 8, 1), std::invalid_argument);
}

// The frequency k of the pencil (K, M) tends to (2 pi k)^2; each doubling of the samples divides
// the error by 2^(2s - 2) at least, s the number of polynomials reproduced (4 for both banks).
TEST(VibrationEigenvalues, ConvergeToThoseOfTheString) {
  for (const char* name : {"db4", "bspline4.4"}) {
    const FilterBank<double> bank = find_filter_bank<double>(name);
    for (int k : {1, 2}) {
      const double exact = std::pow(2 * std::numbers::pi * k, 2);
      const auto error = [&](int samples) {
        return std::abs(vibration_eigenvalues(bank, samples)[k] - exact) / exact;
      };
      EXPECT_LT(error(128), 1e-6);
      EXPECT_LT(error(32), error(16) / std::pow(2, 2 * 4 - 2 - 0.5));
      EXPECT_LT(error(64), error(32) / std::pow(2, 2 * 4 - 2 - 0.5));
    }
  }
}

TEST(ExtremeEigenvalues, RefuseWhatHasNone) {
  const FilterBank<double> bank = find_filter_bank<double>("db4");
  EXPECT_THROW(extreme_eigenvalues(bank, 1, 0, 1), std::invalid_argument);
  EXPECT_THROW(extreme_eigenvalues(bank, 64, 2, 2), std::invalid_argument);
  EXPECT_THROW(extreme_eigenvalues(bank, 64, 2, -1), std::invalid_argument);
  EXPECT_THROW(extreme_eigenvalues(bank, 48, 2, 1), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
