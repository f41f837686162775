#include "verification/prints/printed_number.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <vector>

#include "wavecurve/certified/ball.hpp"

#include "verification/prints/number_forms.hpp"

namespace wavecurve::verification {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool take(std::string_view& rest, std::string_view what) {
  if (!rest.starts_with(what)) return false;
  rest.remove_prefix(what.size());
  return true;
}

void skip_blanks(std::string_view& rest) {
  while (take(rest, " ")) {
  }
}

/// Takes a sign off the front; true for a minus.
bool take_sign(std::string_view& rest) {
  const bool negative = take(rest, "-");
  if (!negative) take(rest, "+");
  return negative;
}

std::string take_digits(std::string_view& rest) {
  const auto end = std::find_if_not(rest.begin(), rest.end(), is_digit);
  std::string digits(rest.begin(), end);
  rest.remove_prefix(digits.size());
  return digits;
}

/// Reads one decimal in plain ASCII from front to end.
class DecimalParser {
 public:
  /// `whole` is what messages repeat.
  DecimalParser(std::string_view plain, std::string_view whole) : rest_(plain), whole_(whole) {}

  PrintedNumber parse() {
    skip_blanks(rest_);
    PrintedNumber number;
    number.negative = take_sign(rest_);
    skip_blanks(rest_);
    const std::string before = take_groups(true);
    const std::string behind = take(rest_, ".") ? take_groups(false) : "";
    if (before.empty() && behind.empty()) refuse();
    const std::string integer =
        before.substr(std::min(before.find_first_not_of('0'), before.size()));
    number.digits = (integer.empty() ? "0" : integer) + behind;
    number.integer_digits = integer.empty() ? 1 : static_cast<int>(integer.size());
    check_length(number);
    number.exponent = take_exponent();
    take_suffix();
    skip_blanks(rest_);
    if (!rest_.empty()) refuse();
    return number;
  }

 private:
  [[noreturn]] void refuse(const std::string& why = "is not a decimal number") const {
    throw std::invalid_argument(excerpt(whole_) + " " + why);
  }

  void check_length(const PrintedNumber& number) const {
    if (number.significand().size() > most_printed_digits) {
      refuse("has more than " + std::to_string(most_printed_digits) + " digits");
    }
    const std::size_t zeros = number.digits.size() - number.significand().size();
    if (zeros > largest_printed_exponent + 1) {
      refuse("has more than " + std::to_string(largest_printed_exponent) +
             " zeros behind its point");
    }
  }

  /// Digits, maybe in groups.
  std::string take_groups(bool before_the_point) {
    std::string digits = take_digits(rest_);
    std::vector<std::size_t> sizes{digits.size()};
    while (!digits.empty() && take_separator(sizes.size() == 1, sizes.back())) {
      const std::string group = take_digits(rest_);
      sizes.push_back(group.size());
      digits += group;
    }
    if (sizes.size() > 1 && !are_groups(sizes, before_the_point, digits)) refuse();
    return digits;
  }

  /// Takes what stands between two groups of digits, everywhere in the number the same.
  bool take_separator(bool first, std::size_t size_of_last) {
    std::string_view rest = rest_;
    const char separator = rest.empty() ? '.' : rest.front();
    if (separator != ' ' && separator != '_' && separator != '\'') return false;
    rest.remove_prefix(1);
    if (separator == ' ') skip_blanks(rest);
    if (rest.empty() || !is_digit(rest.front())) return false;
    if (separator == '_' && is_fortran_kind(rest)) {
      if (first && size_of_last != 3) return false;
      refuse("may end in a group of digits or in a kind of Fortran");
    }
    if (separator_ != '\0' && separator_ != separator) refuse();
    separator_ = separator;
    rest_ = rest;
    return true;
  }

  static bool is_fortran_kind(std::string_view text) {
    return text == "4" || text == "8" || text == "10" || text == "16";
  }

  static bool are_groups(const std::vector<std::size_t>& sizes, bool before_the_point,
                         const std::string& digits) {
    constexpr std::size_t usual = 3;
    if (before_the_point) {
      return sizes.front() <= usual && digits.front() != '0' &&
             std::all_of(sizes.begin() + 1, sizes.end(), [](auto size) { return size == usual; });
    }
    const std::size_t size = sizes.front();
    return size >= usual && sizes.back() <= size &&
           std::all_of(sizes.begin(), sizes.end() - 1, [size](auto one) { return one == size; });
  }

  std::optional<int> take_exponent() {
    std::string_view rest = rest_;
    skip_blanks(rest);
    if (rest.empty()) return std::nullopt;
    const auto starts_integer = [](std::string_view text) {
      return !text.empty() &&
             (is_digit(text.front()) || text.front() == '-' || text.front() == '+');
    };
    constexpr std::string_view letters = "eEdDqQ";
    if (letters.find(rest.front()) != std::string_view::npos && starts_integer(rest.substr(1))) {
      rest_ = rest.substr(1);
      return take_integer();
    }
    if (take(rest, "*^")) {  // Mathematica's
      rest_ = rest;
      return take_integer();
    }
    if (take(rest, "*") || take(rest, "x") || take(rest, "X")) return take_power_of_ten(rest);
    if (take(rest, "(")) return take_in_parentheses(rest);
    constexpr std::size_t digits_without_letter = 3;  // in Fortran's "1.2-107"
    if ((rest.front() == '-' || rest.front() == '+') && rest.size() == 1 + digits_without_letter) {
      rest_ = rest;
      return take_integer();
    }
    return std::nullopt;
  }

  int take_power_of_ten(std::string_view rest) {
    skip_blanks(rest);
    if (!take(rest, "10") || !(take(rest, "^") || take(rest, "**"))) refuse();
    const bool enclosed = take(rest, "(");
    rest_ = rest;
    const int exponent = take_integer();
    if (enclosed && !take(rest_, ")")) refuse();
    return exponent;
  }

  int take_in_parentheses(std::string_view rest) {
    skip_blanks(rest);
    const bool has_sign = rest.starts_with('-') || rest.starts_with('+');
    rest_ = rest;
    const int exponent = take_integer();
    skip_blanks(rest_);
    if (!take(rest_, ")")) refuse();
    if (!has_sign && exponent != 0) refuse("may mean an exponent or an uncertainty");
    return exponent;
  }

  int take_integer() {
    const bool negative = take_sign(rest_);
    skip_blanks(rest_);
    const std::string digits = take_digits(rest_);
    if (digits.empty()) refuse();
    int magnitude = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), magnitude);
    if (error != std::errc() || magnitude > largest_printed_exponent) {
      refuse("has an exponent beyond " + std::to_string(largest_printed_exponent));
    }
    return negative ? -magnitude : magnitude;
  }

  /// The type of a literal: "f", "L", "f32", "_dp", "_8", Mathematica's "`15.9".
  void take_suffix() {
    if (take(rest_, "_")) {
      if (is_fortran_kind(rest_))
        take_digits(rest_);
      else
        take_identifier();
    } else if (take(rest_, "`")) {
      take_digits(rest_);
      if (take(rest_, ".")) take_digits(rest_);
    } else if (take(rest_, "f") || take(rest_, "F")) {
      take_digits(rest_);
    } else if (constexpr std::string_view letters = "lLdDqQ";
               !rest_.empty() && letters.find(rest_.front()) != std::string_view::npos) {
      rest_.remove_prefix(1);
    }
  }

  void take_identifier() {
    if (rest_.empty() || !is_letter(rest_.front())) refuse();
    while (!rest_.empty() && (is_letter(rest_.front()) || is_digit(rest_.front()))) {
      rest_.remove_prefix(1);
    }
  }

  std::string_view rest_, whole_;
  char separator_ = '\0';  ///< of groups
};

/// The digits of a whole number without leading zeros; nothing if it has a part behind the point.
std::optional<std::string> whole_digits(const PrintedNumber& number) {
  const int places = number.integer_digits + number.exponent.value_or(0);
  const auto size = static_cast<std::size_t>(std::max(places, 0));
  std::string digits = number.digits;
  if (digits.size() > size) {
    if (digits.find_first_not_of('0', size) != std::string::npos) return std::nullopt;
    digits.resize(size);
  }
  digits.resize(size, '0');
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  return digits.empty() ? "0" : digits;
}

PrintedNumber parse_fraction(std::string_view plain, std::size_t slash, std::string_view text) {
  const PrintedNumber above = DecimalParser(plain.substr(0, slash), text).parse();
  const PrintedNumber below = DecimalParser(plain.substr(slash + 1), text).parse();
  const auto numerator = whole_digits(above), denominator = whole_digits(below);
  if (!numerator || !denominator || below.negative) {
    throw std::invalid_argument(excerpt(text) + " is not a fraction of whole numbers");
  }
  if (*denominator == "0") throw std::invalid_argument(excerpt(text) + " divides by zero");
  const int size = static_cast<int>(numerator->size());
  return {above.negative, *numerator, size, std::nullopt, *denominator};
}

}  // namespace

std::string excerpt(std::string_view text) {
  constexpr std::size_t shown = 40;
  std::string result(text.substr(0, shown));
  for (char& c : result) {
    if (c < ' ' || c > '~') c = '?';
  }
  return "'" + result + (text.size() > shown ? "...'" : "'");
}

int PrintedNumber::decimals() const {
  return static_cast<int>(digits.size()) - integer_digits - exponent.value_or(0);
}

std::string_view PrintedNumber::significand() const {
  const auto first = digits.find_first_not_of('0');
  if (first == std::string::npos) return {};
  return std::string_view(digits).substr(first);
}

int PrintedNumber::significant_digits() const {
  if (is_zero()) return static_cast<int>(digits.size());
  return static_cast<int>(significand().size());
}

std::string PrintedNumber::mantissa() const {
  const auto before = static_cast<std::size_t>(integer_digits);
  if (digits.size() == before) return digits;
  return digits.substr(0, before) + "." + digits.substr(before);
}

std::string PrintedNumber::text() const {
  std::string result = (negative ? "-" : "") + mantissa();
  if (is_fraction()) result += "/" + denominator;
  if (exponent) result += "e" + std::to_string(*exponent);
  return result;
}

certified::Rational PrintedNumber::value() const {
  if (!is_fraction()) return certified::Rational::from_decimal(text());
  const auto magnitude =
      certified::Rational::from_decimal(digits) / certified::Rational::from_decimal(denominator);
  return negative ? -magnitude : magnitude;
}

certified::Rational PrintedNumber::unit() const {
  return is_fraction() ? certified::Rational(0) : power_of_ten(-decimals());
}

double PrintedNumber::to_double() const {
  const std::string decimal = is_fraction() ? "" : text();
  double nearest = 0;
  const auto [end, error] =
      std::from_chars(decimal.data(), decimal.data() + decimal.size(), nearest);
  if (error == std::errc()) return nearest;
  // A fraction, or beyond the range of a double.
  constexpr long more_than_a_double = 128;
  const certified::WorkingPrecision precision(more_than_a_double);
  return certified::Ball(value()).to_double();
}

PrintedNumber parse_printed_number(std::string_view text, DecimalMark mark) {
  std::string plain = plain_number_text(text);
  const auto comma = plain.find(',');
  if (mark == DecimalMark::comma && comma != std::string::npos &&
      plain.find('.') == std::string::npos) {
    plain[comma] = '.';
  }
  const auto slash = plain.find('/');
  if (slash != std::string::npos) return parse_fraction(plain, slash, text);
  return DecimalParser(plain, text).parse();
}

certified::Rational power_of_ten(int exponent) {
  return certified::Rational::from_decimal("1e" + std::to_string(exponent));
}

}  // namespace wavecurve::verification
