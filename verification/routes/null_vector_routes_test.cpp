#include "verification/routes/null_vector_routes.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "verification/prints/true_value.hpp"
#include "verification/quantities/filter_values.hpp"

namespace wavecurve::verification {
namespace {

Eigen::VectorXd true_column(FilterValues& values, const Quantity& quantity, int size) {
  Eigen::VectorXd column(size);
  for (int i = 0; i < size; ++i) column[i] = values.value(quantity, i).to_double();
  return column;
}

const std::vector<NullVectorRoute> all_kinds{
    {"", NullVector::eigenvector},        {"", NullVector::singular_vector},
    {"", NullVector::shift_invert},       {"", NullVector::constrained},
    {"", NullVector::least_squares},      {"", NullVector::least_squares_with_moment},
    {"", NullVector::without_equation, 3}};

TEST(NullVectorRoutes, HaveErrorsWithinTheirBounds) {
  for (const char* filter : {"db3", "db5", "db9", "coif1", "coif3", "sym6"}) {
    FilterValues values(find_table_filter(filter));
    const int n = values.number_of_taps();
    const Eigen::VectorXd alpha = true_column(values, Quantity::autocorrelation, n);
    // The doubles nearest the true alpha are half a unit of the last place away.
    const Eigen::VectorXd alpha_errors =
        alpha.cwiseAbs() * (std::numeric_limits<double>::epsilon() / 2);
    for (const Quantity& quantity :
         {Quantity::mu, Quantity::nu, Quantity::mu_normalized, Quantity::nu_normalized}) {
      const Eigen::VectorXd right = true_column(values, quantity, n - 1);
      for (const NullVectorRoute& route : all_kinds) {
        const auto column = coefficient_column(quantity, alpha, route);
        ASSERT_TRUE(column);
        const Eigen::VectorXd bounds = coefficient_errors(quantity, alpha, alpha_errors, route);
        for (int l = 0; l < n - 1; ++l) {
          // `right` is rounded to double as well.
          const double error = std::abs((*column)[l] - right[l]);
          EXPECT_LE(error, bounds[l] + 1e-16 * std::abs(right[l]))
              << filter << " " << to_string(quantity) << l << " " << static_cast<int>(route.kind);
        }
      }
    }
  }
}

TEST(NullVectorRoutes, AreBoundToAFewUnitsOfTable2) {
  // 12 decimals are printed there, up to 109 units off; a bound of as many would explain anything.
  FilterValues values(find_table_filter("coif2"));
  const Eigen::VectorXd alpha = true_column(values, Quantity::autocorrelation, 12);
  const Eigen::VectorXd bounds = coefficient_errors(
      Quantity::mu_normalized, alpha, Eigen::VectorXd::Zero(12), {"", NullVector::eigenvector});
  EXPECT_LT(bounds.maxCoeff(), 1e-11);
}

}  // namespace
}  // namespace wavecurve::verification
