#include "reports/formula.hpp"

#include <algorithm>
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

}  // namespace

std::string formula_html(std::string_view text) {
  std::string html;
  std::size_t plain = 0, after_script = std::string_view::npos;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '_' && text[i] != '^') continue;
    if (i != after_script && !ends_in_base(text.substr(0, i))) continue;
    const std::size_t length = script_length(text.substr(i + 1));
    if (length == 0) continue;
    std::string_view script = text.substr(i + 1, length);
    if (script.front() == '{') script = script.substr(1, script.size() - 2);
    const std::string element = text[i] == '_' ? "sub" : "sup";
    html += escape(text.substr(plain, i - plain));
    html.append("<").append(element).append(">").append(formula_html(script));
    html.append("</").append(element).append(">");
    plain = after_script = i + 1 + length;
    i = plain - 1;
  }
  return html + escape(text.substr(std::min(plain, text.size())));
}

}  // namespace wavecurve::reports
