#pragma once

#include <string>
#include <string_view>

#include "verification/prints/print_verdict.hpp"
#include "verification/suite/claim_verdict.hpp"

namespace wavecurve::reports {

/// How the page shows a verdict. Its word and its symbol say all; the tone only adds colour.
struct VerdictStyle {
  std::string_view symbol;
  std::string_view tone;     ///< CSS class: "good", "partial", "bad" or "open"
  std::string_view meaning;  ///< for the list of what the verdicts mean
};

VerdictStyle style_of(verification::ClaimVerdict verdict);
VerdictStyle style_of(verification::PrintVerdict verdict);

/// The verdict as HTML. The symbol is decoration, the word is what counts: a screen reader is spared
/// the symbol.
std::string badge(verification::ClaimVerdict verdict);
std::string badge(verification::PrintVerdict verdict);

}  // namespace wavecurve::reports
