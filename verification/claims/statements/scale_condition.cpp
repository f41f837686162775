// The printed condition for the scale of mu, against the one that does fix it. Both sides of the
// printed one are computed with proof, and again for a null vector of another scale.
#include <string>

#include <fmt/format.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::scale_condition_claim {

namespace {

using certified::Rational;

Outcome evaluate() {
  const auto definition = certified::find_filter("D8");
  const auto mu = certified::exact_connection_coefficients(definition, 1, 1)->mu;
  const auto second = certified::exact_connection_coefficients(definition, 0, 2)->mu;
  Table sides{"D8: φ replaced by s φ, which keeps A μ = 0",
              {"s^2", "μ_0", "-∫ φ φ''", "difference", "sum of l^2 μ_l"},
              {}};
  bool moment_tells = true;
  int identities = 0;
  double own_moment = 0;  // of phi as it is
  for (const long square : {1L, 2L, 10L}) {
    const Rational scale(square);
    Rational moment;
    for (int l = mu.first_index; l <= mu.last_index(); ++l) {
      moment += scale * Rational(static_cast<long>(l) * l) * mu[l];
    }
    const Rational left = scale * mu[0], right = -(scale * second[0]);
    if (left == right) ++identities;
    if (square == 1) own_moment = certified::Ball(moment).to_double();
    moment_tells = moment_tells && (moment == Rational(-2)) == (square == 1);
    sides.rows.push_back({std::to_string(square), left.to_string(), right.to_string(),
                          (left - right).to_string(), moment.to_string()});
  }
  const auto scales = std::ssize(sides.rows);
  const bool as_expected = identities == scales && moment_tells;
  return {
      as_expected ? ClaimVerdict::depends_on_definition : ClaimVerdict::undecided,
      {"an identity at {} of {} scales; Σ l^2 μ_l = {} fixes the scale",
       {counted("scales at which the printed condition holds", identities),
        counted("scales", scales), to_decimals("Σ l^2 μ_l", own_moment, 0)}},
      "Integration by parts holds for every multiple of φ: as an equation for μ the printed "
      "condition reads 0 = 0. It serves only if the integral is known from elsewhere; the method "
      "cited for it fixes the scale by a moment condition, which gives all μ_l directly.",
      {sides}};
}

const RegisterClaim registered({"scale-condition", "The condition for the scale of μ",
                                "Section 3.2, above (3.12)",
                                "the scale of μ can be determined by μ_0 = -∫ φ φ''", evaluate});

}  // namespace

}  // namespace wavecurve::verification::scale_condition_claim
