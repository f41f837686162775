#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "verification/tables/published_table.hpp"

namespace wavecurve::verification {

// A route is a computation that a published column may have come from: where the taps come from,
// whether alpha was rounded on the way, and how the null vector of (3.11) was found. All are run in
// double precision, as a program of the time would. To add one, add a line to one of the three
// lists in routes.cpp (tap_sources, alpha_sources, null_vector_solvers).

/// What the routes of one column start from.
struct RouteInput {
  Eigen::VectorXd taps;  ///< the true taps of phi's filter, sum sqrt 2
  Eigen::VectorXd
      published_taps;  ///< another publication's, brought to the sum sqrt 2; may be empty
  std::string published_taps_name;  ///< that publication
  Eigen::VectorXd printed_alpha;    ///< alpha_0.. as the table prints them; may be empty
  bool orthonormal = true;          ///< then the even alpha are set to 2, 0, 0, ...
  int decimals = 12;                ///< of the column
};

/// A named vector: taps in order, or alpha, mu, nu for the indices 0, 1, .. and zero beyond.
struct RouteValues {
  std::string name;
  Eigen::VectorXd values;
};

/// Every route to a column of this quantity, the simplest first. Routes that do not apply are left
/// out: nu of a filter that is not orthonormal does not follow from alpha alone, (3.14).
std::vector<RouteValues> run_routes(const Quantity& quantity, const RouteInput& input);

/// The eigenvalue of A that is nearest zero (its magnitude, should it be complex).
double eigenvalue_nearest_zero(const Eigen::Ref<const Eigen::MatrixXd>& a);

}  // namespace wavecurve::verification
