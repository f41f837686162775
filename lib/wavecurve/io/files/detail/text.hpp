#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wavecurve::io {

/// Without white space at either end.
std::string_view trimmed(std::string_view text);

/// The pieces between any of the separators, trimmed, empty ones left out.
std::vector<std::string_view> split(std::string_view text, std::string_view separators);

std::string lower_case(std::string_view text);

/// At most 40 characters of a text, for a message.
std::string shown(std::string_view text);

}  // namespace wavecurve::io
