// Which equation of A mu = 0 may be replaced by the one that fixes the scale. Decided by exact
// rational elimination: a system that `solve` refuses is singular.
#include <string>

#include <fmt/format.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/linear_solve.hpp"
#include "wavecurve/filters/two_scale_matrix.hpp"

#include "verification/routes/moment_condition.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::verification::dropped_equation_claim {

namespace {

Outcome evaluate() {
  const auto definition = certified::find_filter("D8");
  const auto mu = certified::exact_connection_coefficients(definition, 1, 1)->mu;
  const auto a = two_scale_matrix(definition.exact->synthesis);
  Table choices{"D8: the equation of index l replaced by the moment condition",
                {"l", "its weight l^2 in the null combination", "system", "μ_0"},
                {}};
  int regular = 0, right = 0;
  int kept = -1;  // the equation without which the system is singular
  for (int l = 0; l < a.size(); ++l) {
    auto changed = a;
    const auto right_hand_side = replace_by_moment_condition(changed, l);
    const auto solution = certified::solve(changed, right_hand_side);
    if (solution) ++regular;
    if (solution && solution->front() == mu[0]) ++right;
    if (!solution) kept = l;
    choices.rows.push_back({std::to_string(l), std::to_string(l * l),
                            solution ? "regular" : "singular",
                            solution ? solution->front().to_string() : "none"});
  }
  const bool as_expected = kept == 0 && regular == a.size() - 1 && right == regular;
  return {
      as_expected ? ClaimVerdict::depends_on_definition : ClaimVerdict::undecided,
      {"any equation but that of l = {} ({} of {} choices)",
       {counted("the equation that must stay, l", kept), counted("regular systems", regular),
        counted("choices", a.size())}},
      "The publication does not say which equation makes room for the one that fixes the scale. "
      "The equations weighted by l^2 add up to zero. The equation l = 0 has no part in that, so "
      "without it the others are still dependent and the system stays singular.",
      {choices}};
}

const RegisterClaim registered({"dropped-equation",
                                "Which equation the scale condition may replace",
                                "Section 3.2, below (3.11)",
                                "we need another equation to determine the scale of μ", evaluate});

}  // namespace

}  // namespace wavecurve::verification::dropped_equation_claim
