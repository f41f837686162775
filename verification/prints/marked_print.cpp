#include "verification/prints/marked_print.hpp"

#include <algorithm>

namespace wavecurve::verification {

namespace {

/// Bytes of a text, the end excluded.
struct Range {
  std::size_t begin = 0, end = 0;
};

/// Where the digits of a mantissa stand in a text, which may have zeros more before them ("007.5") or
/// one less (".5"), and other digits behind them.
struct FoundDigits {
  std::vector<std::size_t> bytes;  ///< of those that were found
  std::size_t left_out = 0;        ///< zeros of the mantissa that the text does not have
};

std::optional<FoundDigits> find_digits(const std::string& text, const PrintedNumber& number) {
  std::string digits;
  std::vector<std::size_t> bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_digit(text[i])) continue;
    digits += text[i];
    bytes.push_back(i);
  }
  const std::size_t zeros = number.digits.find_first_not_of('0');
  const std::size_t most_left_out = std::min(zeros, number.digits.size() - 1);
  for (std::size_t left_out = 0; left_out <= most_left_out; ++left_out) {
    const std::size_t found = digits.find(number.digits.substr(left_out));
    if (found == std::string::npos) continue;
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(found);
    const auto count = static_cast<std::ptrdiff_t>(number.digits.size() - left_out);
    return FoundDigits{{first, first + count}, left_out};
  }
  return std::nullopt;
}

/// The sign before the digits, of ASCII or a dash of Unicode; an empty range where there is none.
Range find_sign(const std::string& text, std::size_t end) {
  const auto is_inside = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  for (std::size_t i = 0; i < end; ++i) {
    if (text[i] == '-' || text[i] == '+') return {i, i + 1};
    if (static_cast<unsigned char>(text[i]) < 0x80U) continue;
    std::size_t last = i + 1;
    while (last < end && is_inside(text[last])) ++last;
    return {i, last};
  }
  return {};
}

}  // namespace

std::vector<PrintPart> marked_print(const std::string& text, const PrintedNumber& number,
                                    const std::optional<Departure>& departure) {
  if (!departure) return {{text, false}};
  const auto found = number.is_fraction() ? std::nullopt : find_digits(text, number);
  if (!found) return {{text, true}};
  std::vector<PrintPart> parts;
  std::size_t done = 0;
  const auto add = [&](Range range, bool departs) {
    parts.push_back({text.substr(range.begin, range.end - range.begin), departs});
    done = range.end;
  };
  if (departure->sign) {
    const Range sign = find_sign(text, found->bytes.front());
    if (sign.begin > 0) add({0, sign.begin}, false);
    add(sign, true);
  }
  if (departure->digit) {
    const std::size_t digit = std::max(*departure->digit, found->left_out) - found->left_out;
    const std::size_t last = departure->end > digit + found->left_out
                                 ? found->bytes[departure->end - found->left_out - 1]
                                 : found->bytes.back();
    const Range wrong{found->bytes[digit], last + 1};
    if (wrong.begin > done) add({done, wrong.begin}, false);
    add(wrong, true);
  }
  if (done < text.size()) add({done, text.size()}, false);
  return parts;
}

}  // namespace wavecurve::verification
