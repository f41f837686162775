#include "verification/suite/claim_verdict.hpp"

#include <stdexcept>
#include <string>

namespace wavecurve::verification {

std::string_view to_string(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::certified:
      return "certified";
    case ClaimVerdict::form:
      return "form";
    case ClaimVerdict::published_route:
      return "published-route";
    case ClaimVerdict::discrepant:
      return "discrepant";
    case ClaimVerdict::undecided:
      return "undecided";
    case ClaimVerdict::holds:
      return "holds";
    case ClaimVerdict::depends_on_definition:
      return "depends-on-definition";
    case ClaimVerdict::does_not_hold:
      return "does-not-hold";
    case ClaimVerdict::stand_in:
      return "stand-in";
  }
  throw std::invalid_argument("no verdict of a claim has the number " +
                              std::to_string(static_cast<int>(verdict)));
}

bool is_claim_verdict(std::string_view name) {
  for (int i = 0; i <= static_cast<int>(ClaimVerdict::stand_in); ++i) {
    if (to_string(static_cast<ClaimVerdict>(i)) == name) return true;
  }
  return false;
}

}  // namespace wavecurve::verification
