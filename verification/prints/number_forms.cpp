#include "verification/prints/number_forms.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "wavecurve/io/files/detail/text.hpp"

namespace wavecurve::verification {

namespace {

/// What stands in a text and what it becomes.
using Replacement = std::pair<std::string_view, std::string_view>;

/// The longer of two that begin alike comes first.
constexpr Replacement tex_commands[] = {
    {"\\times", "*"}, {"\\cdot", "*"},      {"\\tfrac", ""}, {"\\dfrac", ""}, {"\\frac", ""},
    {"\\num", ""},    {"\\thinspace", " "}, {"\\,", " "},    {"\\;", " "},    {"\\:", " "},
    {"\\ ", " "},     {"\\!", ""},          {"\\(", ""},     {"\\)", ""},     {"}{", "/"},
};

constexpr Replacement characters[] = {
    // hyphens, dashes and signs
    {"\u2010", "-"},
    {"\u2011", "-"},
    {"\u2012", "-"},
    {"\u2013", "-"},
    {"\u2014", "-"},
    {"\u2015", "-"},
    {"\u2212", "-"},
    {"\uFE63", "-"},
    {"\uFF0D", "-"},
    {"\uFF0B", "+"},
    // blanks, and what has no width
    {"\u00A0", " "},
    {"\u2000", " "},
    {"\u2001", " "},
    {"\u2002", " "},
    {"\u2003", " "},
    {"\u2004", " "},
    {"\u2005", " "},
    {"\u2006", " "},
    {"\u2007", " "},
    {"\u2008", " "},
    {"\u2009", " "},
    {"\u200A", " "},
    {"\u202F", " "},
    {"\u205F", " "},
    {"\u3000", " "},
    {"\u200B", ""},
    {"\u200E", ""},
    {"\u2060", ""},
    {"\uFEFF", ""},
    // multiplication, division, apostrophe; the blank keeps "1½" from being 11/2
    {"\u00D7", "*"},
    {"\u00B7", "*"},
    {"\u22C5", "*"},
    {"\u2219", "*"},
    {"\u2044", "/"},
    {"\u2215", "/"},
    {"\u2019", "'"},
    {"\u02BC", "'"},
    {"\u00BD", " 1/2"},
    {"\u00BC", " 1/4"},
    {"\u00BE", " 3/4"},
    {"\u215B", " 1/8"},
    {"\u215C", " 3/8"},
    {"\u215D", " 5/8"},
    {"\u215E", " 7/8"},
};

/// Characters set high, as in "10⁻³".
constexpr Replacement high_characters[] = {
    {"\u2070", "0"}, {"\u00B9", "1"}, {"\u00B2", "2"}, {"\u00B3", "3"},
    {"\u2074", "4"}, {"\u2075", "5"}, {"\u2076", "6"}, {"\u2077", "7"},
    {"\u2078", "8"}, {"\u2079", "9"}, {"\u207B", "-"}, {"\u207A", "+"},
};

/// Digits, signs, points, bars and letters: what most numbers are made of, and nothing changes there.
bool is_plain(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' ||
           c == '+' || c == '.' || c == '/';
  });
}

/// Takes what the table has off the front.
template <std::size_t size>
std::optional<std::string_view> take_replaced(std::string_view& rest,
                                              const Replacement (&table)[size]) {
  for (const auto& [from, to] : table) {
    if (!rest.starts_with(from)) continue;
    rest.remove_prefix(from.size());
    return to;
  }
  return std::nullopt;
}

/// Takes "\phantom{-}", which only holds a place.
bool take_phantom(std::string_view& rest) {
  for (const std::string_view name : {"\\phantom{", "\\hphantom{"}) {
    if (!rest.starts_with(name)) continue;
    const auto end = rest.find('}');
    if (end == std::string_view::npos) return false;
    rest.remove_prefix(end + 1);
    return true;
  }
  return false;
}

void take_one(std::string_view& rest, std::string& plain, bool& high) {
  if (const auto digit = take_replaced(rest, high_characters)) {
    if (!high) plain += '^';
    high = true;
    plain += *digit;
    return;
  }
  high = false;
  if (take_phantom(rest)) return;
  if (const auto replaced = take_replaced(rest, tex_commands)) {
    plain += *replaced;
  } else if (const auto character = take_replaced(rest, characters)) {
    plain += *character;
  } else {
    const char c = rest.front();
    rest.remove_prefix(1);
    if (c == '~' || c == '\t')
      plain += ' ';
    else if (c != '{' && c != '}' && c != '$')
      plain += c;
  }
}

}  // namespace

std::string plain_number_text(std::string_view text) {
  if (is_plain(text)) return std::string(text);
  std::string plain;
  bool high = false;
  while (!text.empty()) take_one(text, plain, high);
  return std::string(io::trimmed(plain));
}

std::string plain_signs(std::string_view text) {
  std::string plain;
  bool high = false;
  while (!text.empty()) {
    if (is_plain(text.substr(0, 1)) || text.front() == ' ') {  // most are, and no sign begins so
      high = false;
      plain += text.front();
      text.remove_prefix(1);
      continue;
    }
    const auto digit = take_replaced(text, high_characters);
    if (digit && !high) plain += '^';
    high = digit.has_value();
    const auto sign = digit ? digit : take_replaced(text, characters);
    if (sign) {
      plain += *sign;
    } else if (text.starts_with("\\times") || text.starts_with("\\cdot")) {
      plain += '*';
      text.remove_prefix(text.starts_with("\\times") ? 6 : 5);
    } else if (text.starts_with("\\,")) {
      text.remove_prefix(2);
    } else {
      plain += text.front();
      text.remove_prefix(1);
    }
  }
  return plain;
}

}  // namespace wavecurve::verification
