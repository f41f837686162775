#include "verification/quantities/entry_index.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <vector>

#include "wavecurve/io/files/detail/text.hpp"

#include "verification/prints/number_forms.hpp"
#include "verification/prints/printed_number.hpp"

namespace wavecurve::verification {

namespace {

/// Finer points would be indistinguishable on any axis.
constexpr int finest_level = 20;

std::optional<double> parse_integer(std::string_view text) {
  if (text.starts_with('+') && text.size() > 1 && is_digit(text[1])) text.remove_prefix(1);
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) return HUGE_VAL;
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return static_cast<double>(value);
}

std::optional<double> parse_point(std::string_view text) {
  if (const auto integer = parse_integer(text)) return integer;
  if (const auto slash = text.find('/'); slash != std::string_view::npos) {
    const auto p = parse_integer(io::trimmed(text.substr(0, slash)));
    const auto q = parse_integer(io::trimmed(text.substr(slash + 1)));
    if (!p || !q || !std::isfinite(*p) || !(*q > 0)) return std::nullopt;
    if (std::fmod(*q, 1) != 0 || std::ldexp(1, std::ilogb(*q)) != *q) return std::nullopt;
    return *p / *q;
  }
  try {
    const PrintedNumber number = parse_printed_number(text);
    const double value = number.to_double();
    if (std::abs(value) > largest_index) return value;
    const certified::Rational scaled = number.value() * certified::Rational(1L << finest_level);
    if (scaled == certified::Rational(std::lround(std::ldexp(value, finest_level)))) return value;
  } catch (const std::invalid_argument&) {  // not a number: answered below
  }
  return std::nullopt;
}

/// The numbers of "(2, -1)", "2 -1", "2;-1"; what is too many stands in the last.
std::vector<std::string_view> numbers_of(std::string_view text) {
  if (text.starts_with('(') && text.ends_with(')')) {
    text = io::trimmed(text.substr(1, text.size() - 2));
  }
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find_first_of(" ,;\t");
    const auto next = text.find_first_not_of(" ,;\t", std::min(end, text.size()));
    const bool is_last = parts.size() + 1 == most_indices || next == std::string_view::npos;
    parts.push_back(is_last ? text : text.substr(0, end));
    if (is_last) return parts;
    text.remove_prefix(next);
  }
}

[[noreturn]] void refuse_index(std::string_view text, std::string_view what) {
  throw std::invalid_argument("the index " + excerpt(text) + " " + std::string(what));
}

}  // namespace

EntryIndex EntryIndex::at(double x) {
  EntryIndex index;
  index.first = x;
  return index;
}

EntryIndex EntryIndex::pair(int l, int m) { return tuple(l, std::span(&m, 1)); }

EntryIndex EntryIndex::tuple(double x, std::span<const int> further) {
  EntryIndex index = at(x);
  index.count = static_cast<int>(further.size()) + 1;
  if (!further.empty()) index.second = further[0];
  if (further.size() > 1) index.third = further[1];
  return index;
}

bool EntryIndex::is_integer() const { return !is_tuple() && std::fmod(first, 1) == 0; }

int EntryIndex::integer() const {
  if (!is_integer()) throw std::domain_error("the index " + text() + " is not an integer");
  return static_cast<int>(first);
}

std::vector<int> EntryIndex::integers() const {
  if (std::fmod(first, 1) != 0) {
    throw std::domain_error("the index " + text() + " must be of integers");
  }
  const int all[most_indices] = {static_cast<int>(first), second, third};
  return {all, all + count};
}

int EntryIndex::dyadic_level() const {
  int exponent = 0;
  const double fraction = std::frexp(first, &exponent);
  const auto digits = static_cast<std::uint64_t>(std::abs(std::ldexp(fraction, 53)));
  return std::max(0, 53 - exponent - std::countr_zero(digits));
}

std::string EntryIndex::first_text() const {
  const int level = dyadic_level();
  const auto numerator = std::to_string(static_cast<long>(std::ldexp(first, level)));
  return level == 0 ? numerator : numerator + "/" + std::to_string(1L << level);
}

std::string EntryIndex::text() const {
  if (!is_tuple()) return first_text();
  std::string text = "(" + first_text() + ", " + std::to_string(second);
  if (count > 2) text += ", " + std::to_string(third);
  return text + ")";
}

EntryIndex parse_entry_index(std::string_view text) {
  const std::string plain = plain_number_text(text);
  const auto parts = numbers_of(io::trimmed(plain));
  std::vector<double> values;
  for (const std::string_view part : parts) {
    const auto value = values.empty() ? parse_point(part) : parse_integer(part);
    if (!value) {
      refuse_index(text,
                   parts.size() > 1
                       ? "is not a pair nor a triple of integers (the first may be a dyadic point)"
                       : "is not an integer nor a dyadic point such as 1/2");
    }
    if (std::abs(*value) > largest_index) {
      refuse_index(text,
                   "is out of range: at most " + std::to_string(largest_index) + " in magnitude");
    }
    values.push_back(*value);
  }
  const std::vector<int> further(values.begin() + 1, values.end());
  return EntryIndex::tuple(values[0] + 0.0, further);  // no negative zero
}

}  // namespace wavecurve::verification
