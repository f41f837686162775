#include "wavecurve/operators/differentiation.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/dyadic_values.hpp"
#include "wavecurve/transform/plain_transform.hpp"

namespace wavecurve {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

VectorXd wave(Index samples, double phase) {
  return VectorXd::NullaryExpr(samples, [&](Index i) {
    return std::sin(2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(samples) +
                    phase);
  });
}

/// The largest error of the d-th derivative of sin(2 pi x) at the samples.
double error_of(const VectorXd& column, int d) {
  const Index n = column.size();
  const VectorXd expected = std::pow(2 * std::numbers::pi, d) * wave(n, 0.5 * std::numbers::pi * d);
  return (circulant_matrix(column) * wave(n, 0) - expected).cwiseAbs().maxCoeff();
}

/// The circulant of phi^(d) at the integers.
MatrixXd values_matrix(const FilterBank<double>& bank, Index samples, int d) {
  const DyadicValues values = scaling_values(bank, 0, d);
  return circulant_matrix(plain::periodized(
      Filter<double>{static_cast<int>(values.first), {values.values.begin(), values.values.end()}},
      samples));
}

TEST(Differentiation, GalerkinConvergesAtItsOrder) {
  struct Case {
    std::string filter;
    int d, order;
  };
  for (const auto& [filter, d, order] :
       {Case{"db3", 1, 6}, Case{"db3", 2, 4}, Case{"db4", 3, 6}, Case{"bspline3.3", 1, 6}}) {
    const FilterBank<double> bank = find_filter_bank(filter);
    const double coarse = error_of(galerkin_differentiation(bank, 16, d), d);
    const double fine = error_of(galerkin_differentiation(bank, 32, d), d);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.2) << filter << ", " << d;
  }
}

TEST(Differentiation, CollocationDifferentiatesTheSpaceExactly) {
  for (const std::string name : {"db3", "sym5", "bspline4.4", "coif2"}) {
    const FilterBank<double> bank = find_filter_bank(name);
    for (const Index samples : {3, 15, 32}) {
      const VectorXd coefficients = wave(samples, 0.3) + wave(samples, 1.1).cwiseAbs2();
      const VectorXd values = values_matrix(bank, samples, 0) * coefficients;
      const VectorXd expected =
          static_cast<double>(samples) * (values_matrix(bank, samples, 1) * coefficients);
      const VectorXd column = collocation_differentiation(bank, samples, 1);
      // The condition of the values' circulant bounds what the division loses.
      const double condition =
          values_matrix(bank, samples, 0).inverse().cwiseAbs().rowwise().sum().maxCoeff();
      const double bound =
          100 * epsilon * condition * static_cast<double>(samples) * (1 + column.cwiseAbs().sum());
      EXPECT_LT((circulant_matrix(column) * values - expected).cwiseAbs().maxCoeff(), bound)
          << name;
    }
  }
}

// The cubic spline through values v has the slopes s of (s_{i-1} + 4 s_i + s_{i+1}) / 6 = N (v_{i+1} -
// v_{i-1}) / 2.
TEST(Differentiation, CollocationOfCubicSplinesIsTheSplinesSlope) {
  constexpr Index samples = 11;
  VectorXd mean = VectorXd::Zero(samples), difference = VectorXd::Zero(samples);
  mean[0] = 4.0 / 6;
  mean[1] = mean[samples - 1] = 1.0 / 6;
  difference[1] = -0.5 * samples;
  difference[samples - 1] = 0.5 * samples;
  const MatrixXd expected =
      MatrixXd(circulant_matrix(mean)).inverse() * MatrixXd(circulant_matrix(difference));
  const MatrixXd found =
      circulant_matrix(collocation_differentiation(find_filter_bank("bspline4.4"), samples, 1));
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1000 * epsilon * samples);
}

// Time and memory go with the entries, not with the square of the samples.
TEST(Differentiation, WithManySamplesTheCirculantIsSparse) {
  constexpr Index samples = 1 << 18;
  const VectorXd column = galerkin_differentiation(find_filter_bank("db4"), samples, 1);
  EXPECT_EQ(circulant_matrix(column).nonZeros(), samples * (column.array() != 0).count());
}

TEST(Differentiation, AtOrderZeroBothAreTheIdentity) {
  const FilterBank<double> bank = find_filter_bank("db4");
  for (const Index samples : {1, 2, 9}) {
    const VectorXd unit = VectorXd::Unit(samples, 0);
    EXPECT_LT((galerkin_differentiation(bank, samples, 0) - unit).norm(), 100 * epsilon);
    EXPECT_LT((collocation_differentiation(bank, samples, 0) - unit).norm(), 100 * epsilon);
  }
}

TEST(Differentiation, RefusesWhatDoesNotExist) {
  const FilterBank<double> smooth = find_filter_bank("db4"), rough = find_filter_bank("db1");
  EXPECT_THROW(galerkin_differentiation(smooth, 0, 1), std::invalid_argument);
  EXPECT_THROW(galerkin_differentiation(smooth, 8, -1), std::invalid_argument);
  EXPECT_THROW(collocation_differentiation(smooth, 8, 9), std::invalid_argument);
  EXPECT_THROW(galerkin_differentiation(rough, 8, 1), std::domain_error);
  EXPECT_THROW(collocation_differentiation(rough, 8, 1), std::domain_error);
  // Quadratic splines at the integers, 1/2 and 1/2, vanish at the highest frequency.
  EXPECT_THROW(collocation_differentiation(find_filter_bank("bspline3.3"), 8, 1),
               std::domain_error);
  EXPECT_NO_THROW(collocation_differentiation(find_filter_bank("bspline3.3"), 9, 1));
}

}  // namespace
}  // namespace wavecurve
