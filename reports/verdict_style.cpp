#include "reports/verdict_style.hpp"

#include <stdexcept>

namespace wavecurve::reports {

using verification::ClaimVerdict;
using verification::PrintVerdict;

namespace {

std::string styled(std::string_view word, const VerdictStyle& style) {
  return "<span class=\"verdict " + std::string(style.tone) + "\"><span aria-hidden=\"true\">" +
         std::string(style.symbol) + "</span> " + std::string(word) + "</span>";
}

}  // namespace

VerdictStyle style_of(PrintVerdict verdict) {
  switch (verdict) {
    case PrintVerdict::certified:
      return {"✓", "good", "Proved: the printed decimal is the correctly rounded true value."};
    case PrintVerdict::form:
      return {"=", "good",
              "The right value in another form than its column's, or filled up with zeros."};
    case PrintVerdict::misprint:
      return {"≠", "partial", "One edit of the print turns it into the certified rounding."};
    case PrintVerdict::published_route:
      return {"→", "partial",
              "A named computation yields the printed digits; the true value differs."};
    case PrintVerdict::agrees_to_digits:
      return {"≈", "partial",
              "Less than one unit of its last digit off, or three significant digits are right."};
    case PrintVerdict::discrepant:
      return {"✗", "bad",
              "Neither within a unit of its last digit nor right to three significant digits."};
    case PrintVerdict::undecided:
      return {"?", "open",
              "The enclosure straddles a rounding boundary at the highest precision tried."};
  }
  throw std::invalid_argument("no style for this verdict of a printed number");
}

VerdictStyle style_of(ClaimVerdict verdict) {
  switch (verdict) {
    case ClaimVerdict::certified:
      return {"✓", "good",
              "Proved: every number of the table is the correctly rounded true value."};
    case ClaimVerdict::form:
      return {"=", "good",
              "Every number of the table is right, some with more or fewer decimals than their "
              "column."};
    case ClaimVerdict::published_route:
      return {"→", "partial",
              "Every number of the table is explained, some by a named computation that yields "
              "their digits; their true values differ."};
    case ClaimVerdict::discrepant:
      return {"✗", "bad", "Some number of the table is neither right nor explained."};
    case ClaimVerdict::undecided:
      return {"?", "open",
              "The figures leave it open, or the computation failed; the section says which."};
    case ClaimVerdict::holds:
      return {"✓", "good", "The claim holds."};
    case ClaimVerdict::depends_on_definition:
      return {"◐", "partial", "True under one reading and not under another; each has its figure."};
    case ClaimVerdict::does_not_hold:
      return {"✗", "bad", "The claim does not hold as printed."};
    case ClaimVerdict::stand_in:
      return {"◇", "open", "The source data are lost; shown on other data, which are named."};
  }
  throw std::invalid_argument("no style for this verdict of a claim");
}

std::string badge(ClaimVerdict verdict) { return styled(to_string(verdict), style_of(verdict)); }
std::string badge(PrintVerdict verdict) { return styled(to_string(verdict), style_of(verdict)); }

}  // namespace wavecurve::reports
