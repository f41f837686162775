#include "wavecurve/operators/multiscale_matrix.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/circulant.hpp"
#include "wavecurve/operators/matrix_measures.hpp"
#include "wavecurve/operators/multiscale_operator.hpp"

namespace wavecurve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// What rounding may do to an entry of S^T T S: the entries of T are of size `norm`, and a level of
/// either transform is a sum of at most 40 products with taps whose magnitudes sum to below 4.
/// Biorthogonal banks amplify by less than 2 a level on each side.
double rounding_bound(const Filter<double>& mu, int samples, int d, int levels, bool orthonormal) {
  double sum = 0;
  for (double x : mu.taps) sum += std::abs(x);
  const double norm = std::ldexp(sum, d * checked_log2(samples));
  const double growth = orthonormal ? 1 : std::pow(4, levels);
  return 40 * (2 * levels + 1) * growth * epsilon * norm;
}

struct Case {
  const char* bank;
  int p, q;
};

class MultiscaleMatrix : public testing::TestWithParam<Case> {
 protected:
  FilterBank<double> bank_ = find_filter_bank<double>(GetParam().bank);
  ConnectionCoefficients<double> coefficients_ =
      connection_coefficients(bank_, GetParam().p, GetParam().q);
  int d_ = GetParam().p + GetParam().q;
};

// From one sample on, so that every filter is longer than the period somewhere.
TEST_P(MultiscaleMatrix, EqualsThePlainTwinAndTheOperator) {
  for (int samples = 1; samples <= 128; samples *= 2) {
    for (int levels = 0; levels <= checked_log2(samples); ++levels) {
      const double tolerance =
          rounding_bound(coefficients_.mu, samples, d_, levels, bank_.is_orthonormal());
      const Eigen::MatrixXd plain = plain::multiscale_matrix(bank_, coefficients_, samples, levels);
      const Eigen::MatrixXd sparse = multiscale_matrix(bank_, coefficients_, samples, levels);
      EXPECT_LE((sparse - plain).cwiseAbs().maxCoeff(), tolerance) << samples << ' ' << levels;

      MultiscaleOperator matrix_free(bank_, coefficients_, samples, levels);
      Eigen::MatrixXd product(samples, samples);
      for (int j = 0; j < samples; ++j) {
        matrix_free.apply(Eigen::VectorXd::Unit(samples, j), product.col(j));
      }
      EXPECT_LE((product - plain).cwiseAbs().maxCoeff(), tolerance) << samples << ' ' << levels;
    }
  }
}

TEST_P(MultiscaleMatrix, IsExactlySymmetricOrAntisymmetricSortedAndFreeOfZeros) {
  const double sign = d_ % 2 == 0 ? 1 : -1;
  for (int samples : {2, 16, 512}) {
    const auto matrix = multiscale_matrix(bank_, coefficients_, samples, checked_log2(samples));
    const Eigen::MatrixXd dense = matrix;
    EXPECT_EQ((dense - sign * dense.transpose()).cwiseAbs().maxCoeff(), 0);
    EXPECT_EQ(matrix.nonZeros(), (dense.array() != 0).count());
    for (int j = 0; j < samples; ++j) {
      int last = -1;
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, j); entry; ++entry) {
        EXPECT_GT(entry.row(), last);
        last = static_cast<int>(entry.row());
      }
    }
  }
}

TEST_P(MultiscaleMatrix, HasTheConstantsInItsNullSpace) {
  if (GetParam().q == 0) return;
  for (int levels : {0, 3, 8}) {
    const auto matrix = multiscale_matrix(bank_, coefficients_, 256, levels);
    Eigen::VectorXd constant = Eigen::VectorXd::Zero(256);
    constant.head(256 >> levels).setOnes();
    const double tolerance =
        rounding_bound(coefficients_.mu, 256, d_, levels, bank_.is_orthonormal());
    EXPECT_LE((matrix * constant).cwiseAbs().maxCoeff(), 16 * tolerance);
  }
}

INSTANTIATE_TEST_SUITE_P(BanksAndOrders, MultiscaleMatrix,
                         testing::Values(Case{"haar", 0, 0}, Case{"db4", 0, 0}, Case{"db4", 1, 1},
                                         Case{"db4", 0, 1}, Case{"db4", 2, 1}, Case{"db4", 0, 2},
                                         Case{"db10", 1, 1}, Case{"db10", 2, 2},
                                         Case{"bspline4.4", 0, 0}, Case{"bspline4.4", 1, 1},
                                         Case{"bspline4.4", 1, 0}, Case{"bspline2.4", 1, 1}),
                         [](const auto& instance) {
                           std::string name = fmt::format("{}_{}{}", instance.param.bank,
                                                          instance.param.p, instance.param.q);
                           for (char& c : name) c = c == '.' ? '_' : c;
                           return name;
                         });

// (f, g) -> int f g' of f = sum a_i b_i against the exact derivative: the sign of odd orders.
TEST(MultiscaleMatrixTest, AdvectionHasTheSignOfTheDerivative) {
  const FilterBank<double> bank = find_filter_bank<double>("bspline4.4");
  const int n = 64;
  const auto advection = multiscale_matrix(bank, n, 0, 0, 1);
  const auto mass = multiscale_matrix(bank, n, 0, 0, 0);
  Eigen::VectorXd sine(n), cosine(n);
  const double step = 2 * std::acos(-1.0) / n;
  for (int i = 0; i < n; ++i) {
    sine[i] = std::sin(step * i);
    cosine[i] = std::cos(step * i);
  }
  // Both are in the discrete Fourier basis: (sin)' = 2 pi cos up to the splines' order 8 in 1/n.
  const Eigen::VectorXd left = advection * sine, right = 2 * std::acos(-1.0) * (mass * cosine);
  EXPECT_LE((left - right).norm(), std::pow(step, 6) * right.norm());
}

TEST(MultiscaleMatrixTest, HaarGramAndCubicSplineGramByHand) {
  const Eigen::MatrixXd haar = multiscale_matrix(find_filter_bank<double>("haar"), 4, 2, 0, 0);
  EXPECT_LE((haar - Eigen::MatrixXd::Identity(4, 4)).cwiseAbs().maxCoeff(), 8 * epsilon);
  // int B(x) B(x - l) dx of the cubic B-spline: 2416, 1191, 120, 1 over 5040.
  const Eigen::MatrixXd spline = gram(find_filter_bank<double>("bspline4.4"), 8, 0);
  EXPECT_NEAR(spline(0, 0), 2416.0 / 5040, 8 * epsilon);
  EXPECT_NEAR(spline(3, 2), 1191.0 / 5040, 8 * epsilon);
  EXPECT_NEAR(spline(0, 6), 120.0 / 5040, 8 * epsilon);
  EXPECT_NEAR(spline(1, 5), 0, epsilon);
}

TEST(MultiscaleMatrixTest, GramOfAnOrthonormalBankIsTheIdentityAndDampingTheSum) {
  const FilterBank<double> bank = find_filter_bank<double>("db4");
  EXPECT_EQ(Eigen::MatrixXd(gram(bank, 32, 3)), Eigen::MatrixXd::Identity(32, 32));
  const Eigen::MatrixXd c = damping(bank, 32, 3, 0.5, 0.25);
  const Eigen::MatrixXd k = stiffness(bank, 32, 3);
  EXPECT_EQ(c, Eigen::MatrixXd(0.5 * Eigen::MatrixXd::Identity(32, 32) + 0.25 * k));
}

TEST(MultiscaleMatrixTest, StoresNothingForASingleScalingFunction) {
  const auto k = stiffness(find_filter_bank<double>("db4"), 64, 6);
  EXPECT_EQ(k.col(0).nonZeros(), 0);
  EXPECT_EQ(k.coeff(1, 0), 0);
  EXPECT_GT(gram(find_filter_bank<double>("bspline4.4"), 64, 6).coeff(0, 0), 0.9);
}

// At N = 64, D8 with one level to K2 with two: facts measured by others.
TEST(MultiscaleMatrixTest, SharesOfNonZerosAreTheKnownOnes) {
  const auto share = [](const char* name, int levels) {
    const auto k = stiffness(find_filter_bank<double>(name), 64, levels);
    return 100 * static_cast<double>(count_above(k, 1e-12)) / (64 * 64);
  };
  EXPECT_NEAR(share("db4", 1), 41, 0.5);
  EXPECT_NEAR(share("coif2", 2), 83, 0.5);
}

// The transform of an orthonormal bank is orthogonal: trace and sum of squares do not change.
TEST(MultiscaleMatrixTest, LevelsPreserveTraceAndEnergyOfAnOrthonormalBank) {
  const FilterBank<double> bank = find_filter_bank<double>("db4");
  const auto single = stiffness(bank, 256, 0);
  for (int levels = 1; levels <= 8; ++levels) {
    const auto multi = stiffness(bank, 256, levels);
    const double trace = single.diagonal().sum();
    EXPECT_NEAR(multi.diagonal().sum(), trace, 64 * levels * epsilon * trace);
    EXPECT_NEAR(multi.norm(), single.norm(), 64 * levels * epsilon * single.norm());
  }
}

// Facts measured by others, at N = 64: the share of the off-diagonal entries in the sum of squares.
TEST(MultiscaleMatrixTest, OffDiagonalSharesAreTheKnownOnes) {
  const auto share = [](const char* name, int levels) {
    const auto k = stiffness(find_filter_bank<double>(name), 64, levels);
    return 100 * (1 - k.diagonal().squaredNorm() / k.squaredNorm());
  };
  EXPECT_NEAR(share("db4", 0), 46.3, 0.05);
  EXPECT_NEAR(share("db4", 1), 16.14, 0.005);
  EXPECT_NEAR(share("db4", 2), 15.19, 0.005);
  EXPECT_NEAR(share("db4", 6), 15.16, 0.005);
  EXPECT_NEAR(share("coif2", 1), 16.04, 0.005);
  EXPECT_NEAR(share("coif2", 2), 15.09, 0.005);
  EXPECT_NEAR(share("coif2", 6), 15.06, 0.005);
  EXPECT_NEAR(share("db10", 6), 14.5, 0.05);
  EXPECT_NEAR(share("coif1", 6), 18.4, 0.05);
  EXPECT_NEAR(share("bspline4.4", 6), 45.8, 0.05);
}

TEST(MultiscaleMatrixTest, NonZerosGrowLikeNLogN) {
  const FilterBank<double> bank = find_filter_bank<double>("db4");
  const auto small = stiffness(bank, 1 << 10, 10), large = stiffness(bank, 1 << 14, 14);
  const double per_sample_and_level = static_cast<double>(small.nonZeros()) / (1024 * 10);
  EXPECT_LT(static_cast<double>(large.nonZeros()), 1.1 * per_sample_and_level * (16384 * 14));
  EXPECT_EQ(large.data().allocatedSize(), large.nonZeros());
}

TEST(MultiscaleMatrixTest, RefusesWhatItCannotDo) {
  const FilterBank<double> bank = find_filter_bank<double>("db4");
  EXPECT_THROW(stiffness(bank, 0, 0), std::invalid_argument);
  EXPECT_THROW(stiffness(bank, 48, 1), std::invalid_argument);
  EXPECT_THROW(stiffness(bank, 64, 7), std::invalid_argument);
  EXPECT_THROW(stiffness(bank, 64, -1), std::invalid_argument);
  EXPECT_THROW(stiffness(bank, Eigen::Index{1} << 25, 1), std::invalid_argument);
  EXPECT_THROW(gram(bank, 64, 7), std::invalid_argument);
  EXPECT_THROW(stiffness(bank, Eigen::Index{1} << 24, 24), std::invalid_argument);  // non-zeros
  EXPECT_THROW(stiffness(find_filter_bank<double>("db2"), 64, 1), std::domain_error);
}

}  // namespace
}  // namespace wavecurve
