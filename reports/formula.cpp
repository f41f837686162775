#include "reports/formula.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "reports/escape.hpp"

namespace wavecurve::reports {

namespace {

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }
bool is_digit(char c) { return is_ascii(c) && std::isdigit(c) != 0; }
bool is_word(char c) { return is_ascii(c) && std::isalnum(c) != 0; }

/// Whether an index or exponent may follow the text.
bool ends_in_base(std::string_view text) {
  if (text.empty()) return false;
  const char last = text.back();
  if (!is_ascii(last) || last == ')' || last == ']' || last == '|') return true;
  if (!is_word(last)) return false;
  const auto end_of_rest = std::find_if_not(text.rbegin(), text.rend(), is_word);
  const auto length = end_of_rest - text.rbegin();
  const bool starts_afresh = end_of_rest == text.rend() || *end_of_rest != '_';
  return starts_afresh && (length == 1 || std::all_of(text.rbegin(), end_of_rest, is_digit));
}

/// The length of "{...}", braces within braces counted; 0 if it is not closed.
std::size_t braced_length(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '{') ++depth;
    if (text[i] == '}' && --depth == 0) return i + 1;
  }
  return 0;
}

/// The length of ".14" at the front of the text; 0 if there is no such thing.
std::size_t fraction_length(std::string_view text) {
  if (text.size() < 2 || text[0] != '.' || !is_digit(text[1])) return 0;
  const auto end = std::find_if_not(text.begin() + 1, text.end(), is_digit);
  return static_cast<std::size_t>(end - text.begin());
}

/// The length of the index or exponent that the text starts with; 0 if there is none.
std::size_t script_length(std::string_view text) {
  if (text.starts_with('{')) return braced_length(text);
  const std::size_t sign = text.starts_with('-') || text.starts_with('+') ? 1 : 0;
  const auto end = std::find_if_not(text.begin() + static_cast<std::ptrdiff_t>(sign), text.end(),
                                    [](char c) { return is_word(c) || !is_ascii(c); });
  const auto length = static_cast<std::size_t>(end - text.begin());
  if (length == sign) return 0;
  const bool is_number =
      std::all_of(text.begin() + static_cast<std::ptrdiff_t>(sign), end, is_digit);
  return is_number ? length + fraction_length(text.substr(length)) : length;
}

/// Text with its indices and exponents, by plain(text) and set('_' or '^', script, as written).
template <class Plain, class Set>
std::string formula(std::string_view text, Plain plain_text, Set set) {
  std::string result;
  std::size_t plain = 0, after_script = std::string_view::npos;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '_' && text[i] != '^') continue;
    if (i != after_script && !ends_in_base(text.substr(0, i))) continue;
    const std::size_t length = script_length(text.substr(i + 1));
    if (length == 0) continue;
    std::string_view script = text.substr(i + 1, length);
    if (script.front() == '{') script = script.substr(1, script.size() - 2);
    result += plain_text(text.substr(plain, i - plain));
    result += set(text[i], script, text.substr(i, length + 1));
    plain = after_script = i + 1 + length;
    i = plain - 1;
  }
  return result + plain_text(text.substr(std::min(plain, text.size())));
}

/// The characters of Unicode for a script; empty if one has none.
std::string small_characters(char kind, std::string_view script) {
  constexpr std::string_view plain = "0123456789+-()n";
  constexpr std::array<std::string_view, plain.size()> low{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇",
                                                           "₈", "₉", "₊", "₋", "₍", "₎", "ₙ"};
  constexpr std::array<std::string_view, plain.size()> high{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷",
                                                            "⁸", "⁹", "⁺", "⁻", "⁽", "⁾", "ⁿ"};
  std::string result;
  for (const char c : script) {
    const std::size_t place = plain.find(c);
    if (place == std::string_view::npos) return "";
    result += (kind == '_' ? low : high)[place];
  }
  return result;
}

}  // namespace

std::string formula_html(std::string_view text) {
  return formula(text, escape, [](char kind, std::string_view script, std::string_view) {
    const std::string element = kind == '_' ? "sub" : "sup";
    return "<" + element + ">" + formula_html(script) + "</" + element + ">";
  });
}

std::string formula_text(std::string_view text) {
  return formula(
      text, [](std::string_view plain) { return std::string(plain); },
      [](char kind, std::string_view script, std::string_view written) {
        const std::string small = small_characters(kind, script);
        return small.empty() ? std::string(written) : small;
      });
}

}  // namespace wavecurve::reports
