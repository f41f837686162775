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

/// The two halves of "(2, -1)", "2 -1", "2;-1"; one half if there is no second.
std::vector<std::string_view> halves(std::string_view text) {
  if (text.starts_with('(') && text.ends_with(')')) {
    text = io::trimmed(text.substr(1, text.size() - 2));
  }
  const auto end = text.find_first_of(" ,;\t");
  if (end == std::string_view::npos) return {text};
  const auto next = text.find_first_not_of(" ,;\t", end);
  if (next == std::string_view::npos) return {text};
  return {text.substr(0, end), text.substr(next)};
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

EntryIndex EntryIndex::pair(int l, int m) {
  EntryIndex index(l);
  index.second = m;
  index.is_pair = true;
  return index;
}

bool EntryIndex::is_integer() const { return !is_pair && std::fmod(first, 1) == 0; }

int EntryIndex::integer() const {
  if (!is_integer()) throw std::domain_error("the index " + text() + " is not an integer");
  return static_cast<int>(first);
}

int EntryIndex::dyadic_level() const {
  int exponent = 0;
  const double fraction = std::frexp(first, &exponent);
  const auto digits = static_cast<std::uint64_t>(std::abs(std::ldexp(fraction, 53)));
  return std::max(0, 53 - exponent - std::countr_zero(digits));
}

std::string EntryIndex::text() const {
  const auto whole = [](double x) { return std::to_string(static_cast<long>(x)); };
  if (is_pair) return "(" + whole(first) + ", " + whole(second) + ")";
  const int level = dyadic_level();
  return level == 0 ? whole(first)
                    : whole(std::ldexp(first, level)) + "/" + std::to_string(1L << level);
}

EntryIndex parse_entry_index(std::string_view text) {
  const std::string plain = plain_number_text(text);
  const auto parts = halves(io::trimmed(plain));
  std::vector<double> values;
  for (const std::string_view part : parts) {
    const auto value = parts.size() == 2 ? parse_integer(part) : parse_point(part);
    if (!value) {
      refuse_index(text, parts.size() == 2 ? "is not a pair of integers"
                                           : "is not an integer nor a dyadic point such as 1/2");
    }
    if (std::abs(*value) > largest_index) {
      refuse_index(text,
                   "is out of range: at most " + std::to_string(largest_index) + " in magnitude");
    }
    values.push_back(*value);
  }
  if (values.size() == 2) {
    return EntryIndex::pair(static_cast<int>(values[0]), static_cast<int>(values[1]));
  }
  return EntryIndex::at(values[0] + 0.0);  // no negative zero
}

}  // namespace wavecurve::verification
