#pragma once

#include <string>
#include <string_view>

namespace wavecurve::reports {

/// Escaped HTML of text in which indices and exponents are written as in "c_n^{M_f}" or "C^-1".
/// They are set as such only behind a single letter, a number, a closing bracket or each other, so
/// that names like own_value stay as they are.
std::string formula_html(std::string_view text);

/// The same text, not escaped, with the small digits and signs of Unicode, for the words of a chart:
/// "s₁ = 2", "C⁻¹". A script that has a character without such a form stays as it is written.
std::string formula_text(std::string_view text);

}  // namespace wavecurve::reports
