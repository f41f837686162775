#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wavecurve::io {

/// The fields of one line of a table (RFC 4180, no line break inside a field): what stands between
/// quotes as it is, with quotes inside doubled, all else without blanks at either end; without the
/// apostrophe of csv_field(). Throws std::invalid_argument for a quote that is not closed, and text
/// behind one that is.
std::vector<std::string> csv_fields(std::string_view line, char separator = ',');

/// A text as a field of such a line: in quotes where it must be; behind an apostrophe where a
/// spreadsheet would take it for a formula (it begins with = + - @, and is no number); with U+FFFD for
/// what is no UTF-8 and for control characters but tab and line breaks.
std::string csv_field(std::string_view text);

}  // namespace wavecurve::io
