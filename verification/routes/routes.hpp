#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "verification/prints/true_value.hpp"
#include "verification/quantities/quantity.hpp"
#include "verification/tables/published_taps.hpp"

namespace wavecurve::verification {

// A route is a computation that a published column may have come from. There are two kinds. A
// rounding rule (tap_rules.hpp, print_rules.hpp) says which decimals stand there, and is decided
// exactly. A floating-point computation is run in double precision, as a program of the time would:
// where the taps come from, whether alpha was rounded on the way, how the null vector of (3.11) was
// found. To add one of the latter, add a line to one of the lists in routes.cpp (tap_sources,
// alpha_sources, null_vector_solvers).

/// How a route's numbers became print: correctly rounded at the print's last digit, or the further
/// digits left away.
enum class Printing { rounded, cut_off };

/// A named computation, and what it yields in the places of a column: taps in order, or what has
/// the indices 0, 1, .. and is zero beyond.
struct Route {
  std::string name;
  /// What it has in common with the routes to other columns of a table; the name, if nothing else.
  std::vector<std::string> habits;
  Printing printing = Printing::rounded;
  /// The numbers themselves, for a rounding rule; empty if they are the doubles.
  std::vector<TrueValue> exact;
  std::vector<Approximation> approximations;  ///< of `exact`
  Eigen::VectorXd doubles;
  /// Bounds, for a floating-point computation, of the rounding errors of `doubles` (or of another
  /// program's that does the same in another order); empty for a rounding rule. They are asked for
  /// only if they matter.
  std::function<Eigen::VectorXd()> rounding_errors;

  TrueValue value(std::size_t place) const;
  Approximation approximation(std::size_t place) const;
};

/// The route of a rule: all else follows from name and numbers.
Route rule(std::string name, std::vector<TrueValue> numbers, Printing printing = Printing::rounded);

/// What the routes of one column start from.
struct RouteInput {
  std::vector<TrueValue> taps;  ///< the true taps of phi's filter, sum sqrt 2
  std::optional<PublishedTaps> published_taps;
  Eigen::VectorXd printed_alpha;  ///< alpha_0.. as the table prints them; may be empty
  bool orthonormal = true;        ///< then the even alpha are set to 2, 0, 0, ...
  int decimals = 12;              ///< of the column
};

/// Every route to a column of this quantity, the simplest first, but for those that need its true
/// values alone (print_rules.hpp). Routes that do not apply are left out: nu of a filter that is
/// not orthonormal does not follow from alpha alone, (3.14).
std::vector<Route> run_routes(const Quantity& quantity, const RouteInput& input);

/// The eigenvalue of A that is nearest zero (its magnitude, should it be complex).
double eigenvalue_nearest_zero(const Eigen::Ref<const Eigen::MatrixXd>& a);

}  // namespace wavecurve::verification
