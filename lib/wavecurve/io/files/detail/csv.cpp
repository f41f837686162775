#include "wavecurve/io/files/detail/csv.hpp"

#include <algorithm>
#include <stdexcept>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::io {

namespace {

/// The separator may itself be a tab.
void skip_blanks(std::string_view& rest, char separator) {
  while (!rest.empty() && rest[0] != separator && (rest[0] == ' ' || rest[0] == '\t')) {
    rest.remove_prefix(1);
  }
}

/// Takes a field in quotes off the front.
std::string take_quoted(std::string_view& rest) {
  std::string field;
  do {
    rest.remove_prefix(1);
    const auto quote = rest.find('"');
    if (quote == std::string_view::npos) {
      throw std::invalid_argument("a quoted field is not closed");
    }
    field += rest.substr(0, quote);
    rest.remove_prefix(quote + 1);
    if (rest.starts_with('"')) field += '"';
  } while (rest.starts_with('"'));
  return field;
}

}  // namespace

std::vector<std::string> csv_fields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (;;) {
    skip_blanks(line, separator);
    if (line.starts_with('"')) {
      fields.push_back(take_quoted(line));
      skip_blanks(line, separator);
      if (!line.empty() && line.front() != separator) {
        throw std::invalid_argument("text follows a closing quote");
      }
    } else {
      const std::size_t end = std::min(line.find(separator), line.size());
      fields.emplace_back(trimmed(line.substr(0, end)));
      line.remove_prefix(end);
    }
    if (line.empty()) return fields;
    line.remove_prefix(1);
  }
}

std::string csv_field(std::string_view text) {
  const bool has_edge = !text.empty() && (trimmed(text).size() < text.size());
  if (!has_edge && text.find_first_of(",;\t\"\r\n") == std::string_view::npos) {
    return std::string(text);
  }
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? "\"\"" : std::string(1, c);
  return field + "\"";
}

}  // namespace wavecurve::io
