#pragma once

#include <string>
#include <string_view>

namespace wavecurve::verification {

/// A number as typesetters, TeX and spreadsheets write it, brought to plain ASCII: every dash and
/// minus sign of Unicode becomes '-', every blank (no-break, thin, ..., and TeX's "\," and "~") ' ',
/// every sign of multiplication ("×", "·", "\times", "\cdot") '*', digits set high "^" and digits,
/// "½" and "\frac{1}{2}" "1/2", the typographic apostrophe '\''. Dollar signs, braces, "\num" and
/// "\phantom{...}" leave. Blanks at either end do, too. All else stays as it is, so that what is no
/// number is refused by whoever reads the result.
std::string plain_number_text(std::string_view text);

/// The signs alone: dashes, blanks, multiplication and digits set high, with nothing taken away, so
/// that brackets and what separates numbers of a line remain.
std::string plain_signs(std::string_view text);

}  // namespace wavecurve::verification
