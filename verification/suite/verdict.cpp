#include "verification/suite/verdict.hpp"

#include <stdexcept>
#include <string>

namespace wavecurve::verification {

std::string_view to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return "certified";
    case Verdict::form:
      return "form";
    case Verdict::misprint:
      return "misprint";
    case Verdict::published_route:
      return "published-route";
    case Verdict::agrees_to_digits:
      return "agrees-to-digits";
    case Verdict::discrepant:
      return "discrepant";
    case Verdict::undecided:
      return "undecided";
    case Verdict::holds:
      return "holds";
    case Verdict::depends_on_definition:
      return "depends-on-definition";
    case Verdict::does_not_hold:
      return "does-not-hold";
    case Verdict::stand_in:
      return "stand-in";
  }
  throw std::invalid_argument("no verdict has the number " +
                              std::to_string(static_cast<int>(verdict)));
}

}  // namespace wavecurve::verification
