#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace wavecurve::io {

/// The text of a document; every writer of JSON uses this. Indented by so many blanks a level, or on
/// one line. In texts U+FFFD stands for what is no UTF-8, and what does not show (characters.hpp) is
/// escaped, as JSON has it for the control characters of ASCII.
std::string json_text(const nlohmann::json& document, int indent = -1);
std::string json_text(const nlohmann::ordered_json& document, int indent = -1);

/// A text as JSON has it, in quotation marks.
std::string quoted(const std::string& text);

}  // namespace wavecurve::io
