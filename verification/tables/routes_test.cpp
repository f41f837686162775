#include "verification/tables/routes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "wavecurve/operators/two_scale_system.hpp"

#include "verification/tables/published_taps.hpp"
#include "verification/tables/filter_values.hpp"
#include "verification/tables/true_value.hpp"

namespace wavecurve::verification {
namespace {

Eigen::VectorXd true_column(FilterValues& values, const Quantity& quantity, int first, int size) {
  Eigen::VectorXd column(size);
  for (int i = 0; i < size; ++i) column[i] = values.value(quantity, first + i).to_double();
  return column;
}

RouteInput input_for(FilterValues& values, int decimals) {
  RouteInput input;
  input.taps = true_column(values, Quantity::taps, values.first_tap(), values.number_of_taps());
  input.orthonormal = values.is_orthonormal();
  input.decimals = decimals;
  return input;
}

const RouteValues* find(const std::vector<RouteValues>& routes, const std::string& name) {
  const auto found = std::find_if(routes.begin(), routes.end(),
                                  [&](const RouteValues& route) { return route.name == name; });
  return found == routes.end() ? nullptr : &*found;
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
    for (const RouteValues& route : run_routes(quantity, input_for(values, 12))) {
      if (!route.name.starts_with("alpha from the true taps; ")) continue;
      ++from_true_taps;
      // (l^2) is the left null vector, so the equation l = 0 follows from no others.
      if (route.name.ends_with("l = 0 dropped")) continue;
      EXPECT_LT((route.values - right).cwiseAbs().maxCoeff(), 1e-10) << route.name;
    }
    EXPECT_GE(from_true_taps, 4 + 10);
  }
}

TEST(Routes, RoundTheTapsInTheNormalizationNamed) {
  FilterValues values(find_table_filter("D8"));
  const auto routes = run_routes(Quantity::taps_sum_1, input_for(values, 8));
  const RouteValues* route = find(routes, "h/sqrt2 rounded to 8 decimals");
  ASSERT_NE(route, nullptr);
  for (int n = 0; n < 8; ++n) {
    const double scaled = route->values[n] * 1e8;
    EXPECT_NEAR(scaled, std::nearbyint(scaled), 1e-6);
    EXPECT_NEAR(route->values[n], values.value(Quantity::taps_sum_1, n).to_double(), 0.51e-8);
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
  EXPECT_LT((published->taps - right).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_GT((published->taps - right).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_FALSE(find_published_taps("db4"));
}

}  // namespace
}  // namespace wavecurve::verification
