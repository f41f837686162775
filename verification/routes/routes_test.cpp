#include "verification/routes/routes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "wavecurve/operators/two_scale_system.hpp"

#include "verification/prints/true_value.hpp"
#include "verification/quantities/filter_values.hpp"
#include "verification/tables/published_taps.hpp"

namespace wavecurve::verification {
namespace {

Eigen::VectorXd true_column(FilterValues& values, const Quantity& quantity, int first, int size) {
  Eigen::VectorXd column(size);
  for (int i = 0; i < size; ++i) column[i] = values.value(quantity, first + i).to_double();
  return column;
}

RouteInput input_for(FilterValues& values, int decimals) {
  RouteInput input;
  for (int i = 0; i < values.number_of_taps(); ++i) {
    input.taps.push_back(values.value(Quantity::taps, values.first_tap() + i));
  }
  input.orthonormal = values.is_orthonormal();
  input.decimals = decimals;
  return input;
}

TEST(Routes, TheSystemHasTheTrueCoefficientsAsNullVector) {
  for (const char* filter : {"D8", "K2", "bspline4.4"}) {
    FilterValues values(find_table_filter(filter));
    const int n = values.number_of_taps();
    const Eigen::VectorXd alpha = true_column(values, Quantity::autocorrelation, 0, n);
    const Eigen::MatrixXd a = two_scale_matrix(alpha);
    const Eigen::VectorXd mu = true_column(values, Quantity::mu, 0, n - 1);
    EXPECT_LT((a * mu).cwiseAbs().maxCoeff(), 1e-13 * mu.cwiseAbs().maxCoeff()) << filter;
    EXPECT_LT(std::abs(eigenvalue_nearest_zero(a)), 1e-12) << filter;
  }
}

TEST(Routes, EverySolverFindsTheTrueCoefficientsFromTheTrueTapsButOne) {
  FilterValues values(find_table_filter("K2"));
  for (const Quantity& quantity :
       {Quantity::mu, Quantity::nu, Quantity::mu_normalized, Quantity::nu_normalized}) {
    const Eigen::VectorXd right = true_column(values, quantity, 0, 11);
    int from_true_taps = 0;
    for (const Route& route : run_routes(quantity, input_for(values, 12))) {
      if (!route.name.starts_with("alpha from the true taps; ")) continue;
      ++from_true_taps;
      // (l^2) is the left null vector, so the equation l = 0 follows from no others.
      if (route.name.ends_with("l = 0 dropped")) continue;
      EXPECT_LT((route.doubles - right).cwiseAbs().maxCoeff(), 1e-10) << route.name;
    }
    EXPECT_GE(from_true_taps, 4 + 10);
  }
}

TEST(Routes, ToCoefficientsShareTheirHabits) {
  FilterValues values(find_table_filter("D8"));
  const std::string source = "alpha from taps in single precision";
  const std::string solver = "mu by least squares with mu_0 = 1";
  int found = 0;
  for (const Route& route : run_routes(Quantity::mu, input_for(values, 9))) {
    if (!route.name.starts_with(source) || !route.name.ends_with(solver)) continue;
    ++found;  // alpha as it comes out, and rounded
    EXPECT_EQ(route.habits, (std::vector<std::string>{source, solver}));
  }
  EXPECT_EQ(found, 2);
  const auto to_alpha = run_routes(Quantity::autocorrelation, input_for(values, 9));
  EXPECT_TRUE(std::any_of(to_alpha.begin(), to_alpha.end(),
                          [&](const Route& route) { return route.habits[0] == source; }));
}

TEST(Routes, BoundTheErrorsOfAlpha) {
  for (const char* filter : {"db10", "coif5"}) {
    FilterValues values(find_table_filter(filter));
    RouteInput input = input_for(values, 12);
    input.orthonormal = false;  // so that every alpha is computed
    const auto routes = run_routes(Quantity::autocorrelation, input);
    ASSERT_EQ(routes[0].name, "alpha from the true taps");
    const Eigen::VectorXd bounds = routes[0].rounding_errors();
    for (int n = 0; n < values.number_of_taps(); ++n) {
      const double alpha = values.value(Quantity::autocorrelation, n).to_double();
      EXPECT_LE(std::abs(routes[0].doubles[n] - alpha), bounds[n] + 1e-16 * std::abs(alpha));
    }
    EXPECT_LT(bounds.maxCoeff(), 1e-14);
  }
}

TEST(Routes, SkipWhatDoesNotFollowFromAlpha) {
  FilterValues values(find_table_filter("bspline4.4"));
  EXPECT_TRUE(run_routes(Quantity::nu, input_for(values, 12)).empty());
  EXPECT_FALSE(run_routes(Quantity::mu, input_for(values, 12)).empty());
}

TEST(PublishedTaps, AreThoseOfTheFilterInTheUsualNormalization) {
  const auto published = find_published_taps("coif2");
  ASSERT_TRUE(published);
  FilterValues values(find_table_filter("K2"));
  const Eigen::VectorXd right = true_column(values, Quantity::taps, -4, 12);
  EXPECT_LT((published->taps() - right).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_GT((published->taps() - right).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_FALSE(find_published_taps("db4"));
}

}  // namespace
}  // namespace wavecurve::verification
