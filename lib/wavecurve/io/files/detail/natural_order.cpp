#include "wavecurve/io/files/detail/natural_order.hpp"

#include <algorithm>

namespace wavecurve::io {

namespace {

bool is_decimal_digit(char c) { return c >= '0' && c <= '9'; }

/// Takes the digits off the front; returns them without the zeros before them.
std::string_view leading_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_decimal_digit);
  std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

}  // namespace

bool naturally_precedes(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_decimal_digit(a[0]) && is_decimal_digit(b[0])) {
      const std::string_view x = leading_number(a), y = leading_number(b);
      if (x.size() != y.size()) return x.size() < y.size();
      if (x != y) return x < y;
    } else {
      if (a[0] != b[0]) return a[0] < b[0];
      a.remove_prefix(1), b.remove_prefix(1);
    }
  }
  return a.size() < b.size();
}

}  // namespace wavecurve::io
