#include "verification/prints/print_verdict.hpp"

#include <stdexcept>
#include <string>

namespace wavecurve::verification {

std::string_view to_string(PrintVerdict verdict) {
  switch (verdict) {
    case PrintVerdict::certified:
      return "certified";
    case PrintVerdict::form:
      return "form";
    case PrintVerdict::misprint:
      return "misprint";
    case PrintVerdict::published_route:
      return "published-route";
    case PrintVerdict::agrees_to_digits:
      return "agrees-to-digits";
    case PrintVerdict::discrepant:
      return "discrepant";
    case PrintVerdict::undecided:
      return "undecided";
  }
  throw std::invalid_argument("no verdict of a printed number has the number " +
                              std::to_string(static_cast<int>(verdict)));
}

}  // namespace wavecurve::verification
