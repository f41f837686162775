#include "wavecurve/io/files/detail/csv.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "wavecurve/filters/detail/characters.hpp"
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

/// Whether a spreadsheet might take the text for a formula, or has been kept from that by apostrophes.
bool is_like_formula(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of('\''), text.size()));
  if (text.empty() || std::string_view("=+-@").find(text.front()) == std::string_view::npos) {
    return false;
  }
  double number = 0;
  const char* const first = text.data() + (text.front() == '+' ? 1 : 0);
  const char* const last = text.data() + text.size();
  return std::from_chars(first, last, number).ptr != last;
}

/// The text as it was before csv_field() kept it from being a formula.
std::string unmarked(std::string text) {
  if (text.starts_with('\'') && is_like_formula(text)) text.erase(0, 1);
  return text;
}

}  // namespace

std::vector<std::string> csv_fields(std::string_view line, char separator) {
  std::vector<std::string> fields;
  for (;;) {
    skip_blanks(line, separator);
    if (line.starts_with('"')) {
      fields.push_back(unmarked(take_quoted(line)));
      skip_blanks(line, separator);
      if (!line.empty() && line.front() != separator) {
        throw std::invalid_argument("text follows a closing quote");
      }
    } else {
      const std::size_t end = std::min(line.find(separator), line.size());
      fields.push_back(unmarked(std::string(trimmed(line.substr(0, end)))));
      line.remove_prefix(end);
    }
    if (line.empty()) return fields;
    line.remove_prefix(1);
  }
}

std::string csv_field(std::string_view text) {
  std::string field = is_like_formula(text) ? "'" : "";
  const bool has_edge = trimmed(text).size() < text.size();
  const bool is_quoted = has_edge || text.find_first_of(",;\t\"\r\n") != std::string_view::npos;
  while (!text.empty()) {
    const Character character = take_character(text);
    const bool breaks = character.code == '\t' || character.code == '\n' || character.code == '\r';
    if (character.code == '"') field += '"';
    field += character.shows() || breaks ? character.bytes : replacement_character;
  }
  return is_quoted ? "\"" + field + "\"" : field;
}

}  // namespace wavecurve::io
