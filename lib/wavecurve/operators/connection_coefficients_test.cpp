#include "wavecurve/operators/connection_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/filters/autocorrelation.hpp"
#include "wavecurve/filters/find_filter_bank.hpp"

namespace wavecurve {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Eigen::VectorXd alpha_of(const FilterBank<double>& bank) {
  const auto alpha = autocorrelation(bank.synthesis_low);
  return Eigen::Map<const Eigen::VectorXd>(alpha.taps.data(), alpha.size());
}

/// How much a perturbation of A, relative to its norm, can move the null vector: ||A|| over the
/// smallest singular value but one.
double condition(const FilterBank<double>& bank, int d) {
  const Eigen::MatrixXd a = two_scale_matrix(alpha_of(bank), d);
  const Eigen::VectorXd s = a.jacobiSvd().singularValues();
  return s.size() < 2 ? 1.0 : s[0] / s[s.size() - 2];
}

struct Case {
  const char* name;
  int p, q;
};

class EveryMethod : public testing::TestWithParam<Case> {};

TEST_P(EveryMethod, AgreesWithTheCertifiedValues) {
  const auto [name, p, q] = GetParam();
  const auto bank = find_filter_bank(name);
  const auto truth = certified::connection_coefficients(certified::find_filter(name), p, q, 120);
  double largest = 0;
  for (const auto& value : truth.mu.taps) largest = std::max(largest, std::abs(value.to_double()));
  // alpha carries L rounding errors of size epsilon and A is 2^(d-1) alpha; the moment condition
  // then divides by a sum of P terms. One factor 4 covers the solvers' own constants.
  const int taps = bank.synthesis_low.size();
  const double tolerance = 4 * taps * epsilon * condition(bank, p + q) * largest * taps;
  for (const auto method : {NullVectorMethod::singular_vector, NullVectorMethod::eigenvector,
                            NullVectorMethod::shift_invert, NullVectorMethod::constrained}) {
    const auto c = connection_coefficients(bank, p, q, method);
    ASSERT_EQ(c.mu.last_index(), truth.mu.last_index());
    ASSERT_EQ(c.nu.last_index(), truth.nu.last_index());
    for (int l = c.mu.first_index; l <= c.mu.last_index(); ++l) {
      EXPECT_NEAR(c.mu[l], truth.mu[l].to_double(), tolerance)
          << static_cast<int>(method) << " " << l;
    }
    // nu is a sum of 2 L products 2^(d-1) beta mu.
    const double scale = std::exp2(p + q) * 2 * taps;
    for (int l = c.nu.first_index; l <= c.nu.last_index(); ++l) {
      EXPECT_NEAR(c.nu[l], truth.nu[l].to_double(), scale * tolerance) << static_cast<int>(method);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, EveryMethod,
                         testing::Values(Case{"db3", 1, 1}, Case{"db4", 1, 1}, Case{"db10", 1, 1},
                                         Case{"db10", 2, 2}, Case{"coif2", 1, 1},
                                         Case{"coif4", 0, 1}, Case{"sym8", 1, 2},
                                         Case{"cdf9.7", 1, 1}, Case{"db2", 0, 0},
                                         Case{"bspline4.4", 1, 1}, Case{"bspline4.4", 2, 2},
                                         Case{"bspline3.3", 0, 0}));

TEST(ConnectionCoefficients, HaarHasAMassMatrix) {
  const auto c = connection_coefficients(find_filter_bank("haar"), 0, 0);
  EXPECT_EQ(c.mu.size(), 1);
  EXPECT_DOUBLE_EQ(c.mu[0], 1.0);
  EXPECT_NEAR(c.nu[0], 1.0, 4 * epsilon);
}

TEST(ConnectionCoefficients, RefuseTooLittleSmoothness) {
  EXPECT_THROW(connection_coefficients(find_filter_bank("haar")), std::domain_error);
  EXPECT_THROW(connection_coefficients(find_filter_bank("db2")), std::domain_error);
  EXPECT_THROW(connection_coefficients(find_filter_bank("db3"), 1, 2), std::domain_error);
  EXPECT_THROW(connection_coefficients(find_filter_bank("db3"), 9, 0), std::invalid_argument);
}

TEST(TwoScaleSystem, LeftNullVectorIsTheSquareOfTheIndex) {
  const auto bank = find_filter_bank("db4");
  const Eigen::MatrixXd a = two_scale_matrix(alpha_of(bank));
  Eigen::VectorXd squares(a.rows());
  for (Eigen::Index l = 0; l < squares.size(); ++l) squares[l] = static_cast<double>(l * l);
  // Rows counted once; l and -l are the same equation, so that the weights stay l^2. Each entry is
  // a sum of P products of numbers below 4 * 36.
  EXPECT_LT((squares.transpose() * a).cwiseAbs().maxCoeff(), 7 * 4 * 36 * epsilon);
}

TEST(TwoScaleSystem, RefusesBadInput) {
  EXPECT_THROW(two_scale_matrix(Eigen::VectorXd::Ones(1)), std::invalid_argument);
  EXPECT_THROW(two_scale_matrix(Eigen::VectorXd::Ones(2), 1), std::invalid_argument);
  EXPECT_THROW(two_scale_matrix(Eigen::VectorXd::Ones(8), -1), std::invalid_argument);
  EXPECT_THROW(two_scale_matrix(Eigen::VectorXd::Ones(8), 17), std::invalid_argument);
}

}  // namespace
}  // namespace wavecurve
