#include "reports/verdict_style.hpp"

#include <stdexcept>

namespace wavecurve::reports {

using verification::Verdict;

VerdictStyle style_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::certified:
      return {"✓", "good", "Proved: the printed decimal is the correctly rounded true value."};
    case Verdict::form:
      return {"=", "good", "The right value, printed with more or fewer decimals than its column."};
    case Verdict::misprint:
      return {"≠", "partial", "One edit of the print turns it into the certified rounding."};
    case Verdict::published_route:
      return {"→", "partial",
              "A named computation yields the printed digits; the true value differs."};
    case Verdict::agrees_to_digits:
      return {"≈", "partial", "At least the first three significant digits are right."};
    case Verdict::discrepant:
      return {"✗", "bad", "Fewer than three significant digits are right."};
    case Verdict::undecided:
      return {"?", "open",
              "The enclosure straddles a rounding boundary at the highest precision tried, or the "
              "computation failed; the section says which."};
    case Verdict::holds:
      return {"✓", "good", "The claim holds."};
    case Verdict::depends_on_definition:
      return {"◐", "partial", "True under one reading and not under another; each has its figure."};
    case Verdict::does_not_hold:
      return {"✗", "bad", "The claim does not hold as printed."};
    case Verdict::stand_in:
      return {"◇", "open", "The source data are lost; shown on other data, which are named."};
  }
  throw std::invalid_argument("no style for this verdict");
}

}  // namespace wavecurve::reports
