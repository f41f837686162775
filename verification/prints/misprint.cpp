#include "verification/prints/misprint.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace wavecurve::verification {

namespace {

/// A difference between two texts that one edit explains.
struct TextEdit {
  Edit edit;
  std::size_t place;  ///< of the edit in the right text
};

/// If `longer` is `shorter` with one digit more: where that digit stands in it.
std::optional<std::size_t> extra_digit(std::string_view shorter, std::string_view longer) {
  if (longer.size() != shorter.size() + 1) return std::nullopt;
  const auto place = static_cast<std::size_t>(
      std::mismatch(shorter.begin(), shorter.end(), longer.begin()).second - longer.begin());
  if (!is_digit(longer[place]) || shorter.substr(place) != longer.substr(place + 1)) {
    return std::nullopt;
  }
  return place;
}

/// Texts of equal length that differ in one digit or in two that changed places.
std::optional<TextEdit> same_length_edit(std::string_view print, std::string_view right) {
  if (print.size() != right.size()) return std::nullopt;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < print.size(); ++i) {
    if (print[i] == right[i]) continue;
    if (!is_digit(print[i]) || !is_digit(right[i])) return std::nullopt;
    places.push_back(i);
  }
  if (places.size() == 1) return TextEdit{Edit::wrong_digit, places[0]};
  if (places.size() != 2) return std::nullopt;
  const auto i = places[0], j = places[1];
  if (print[i] != right[j] || print[j] != right[i]) return std::nullopt;
  const bool neighbours = j == i + 1 || (j == i + 2 && right[i + 1] == '.');
  return TextEdit{neighbours ? Edit::swapped_digits : Edit::swapped_apart, i};
}

std::optional<TextEdit> text_edit(std::string_view print, std::string_view right) {
  if (const auto place = extra_digit(print, right)) return TextEdit{Edit::dropped_digit, *place};
  if (const auto place = extra_digit(right, print)) return TextEdit{Edit::added_digit, *place};
  return same_length_edit(print, right);
}

bool is_one_exponent_edit(int print, int right) {
  if (print == right) return false;
  return print == -right || text_edit(std::to_string(print), std::to_string(right)).has_value();
}

bool is_moved_point(const PrintedNumber& print, const PrintedNumber& right) {
  if (print.is_zero() || print.significand() != right.significand()) return false;
  if (print.exponent == right.exponent) return print.decimals() != right.decimals();
  return print.mantissa() == right.mantissa() && print.is_scientific() && right.is_scientific() &&
         is_one_exponent_edit(*print.exponent, *right.exponent);
}

/// Where a reader finds the digit: "decimal 3".
std::string place_name(std::string_view mantissa, std::size_t place) {
  const auto point = std::min(mantissa.find('.'), mantissa.size());
  if (place < point) return "before the point";
  return "decimal " + std::to_string(place - point);
}

std::string describe(const TextEdit& found, const std::string& print, const std::string& right) {
  const std::string where = place_name(right, found.place);
  const bool is_leading_zero = found.place < right.find_first_of("123456789");
  switch (found.edit) {
    case Edit::dropped_digit:
      if (is_leading_zero) return "a dropped 0 (of those behind the point)";
      return std::string("a dropped ") + right[found.place] + " (" + where + ")";
    case Edit::added_digit:
      return std::string("an added ") + print[found.place] + " (" + place_name(print, found.place) +
             ")";
    case Edit::wrong_digit:
      return std::string("a wrong digit: ") + print[found.place] + " for " + right[found.place] +
             " (" + where + ")";
    default:
      return "two swapped digits (" + where + ")";
  }
}

/// Digits of the right number that the edit does not supply.
int agreeing_digits(const TextEdit& found, const PrintedNumber& right) {
  const int significant = right.is_zero() ? 0 : static_cast<int>(right.significand().size());
  const std::size_t first = right.mantissa().find_first_of("123456789");
  const bool edits_significand = found.edit != Edit::added_digit && found.place >= first;
  if (found.edit == Edit::swapped_apart) return significant - 2;
  return edits_significand || found.edit == Edit::swapped_digits ? significant - 1 : significant;
}

std::optional<Repair> mantissa_repair(const PrintedNumber& print, const PrintedNumber& right) {
  const std::string wrong = print.mantissa(), mantissa = right.mantissa();
  const auto found = text_edit(wrong, mantissa);
  if (!found || print.exponent != right.exponent) return std::nullopt;
  Repair repair{found->edit, right, describe(*found, wrong, mantissa),
                agreeing_digits(*found, right), false};
  repair.only_last_digit = found->edit == Edit::wrong_digit && found->place + 1 == mantissa.size();
  return repair;
}

bool differs_by_one_unit_at_most(const PrintedNumber& print, const PrintedNumber& right) {
  return (print.value() - right.value()).abs() <= print.unit();
}

}  // namespace

std::optional<Repair> find_repair(const PrintedNumber& print, const PrintedNumber& right) {
  const int significant = right.is_zero() ? 0 : right.significant_digits();
  if (print.negative != right.negative) {
    PrintedNumber turned = print;
    turned.negative = right.negative;
    if (turned != right) return std::nullopt;
    const std::string what = print.negative ? "an added sign" : "a lost sign";
    return Repair{Edit::sign, right, what, significant, false};
  }
  std::optional<Repair> repair = mantissa_repair(print, right);
  const bool distant = repair && repair->edit == Edit::swapped_apart;
  if ((!repair || distant) && is_moved_point(print, right)) {
    const std::string what =
        print.exponent == right.exponent ? "a moved point" : "a wrong exponent";
    return Repair{Edit::moved_point, right, what, significant, false};
  }
  return repair;
}

std::optional<Repair> likeliest_repair(const PrintedNumber& print,
                                       std::span<const PrintedNumber> candidates) {
  for (const PrintedNumber& right : candidates) {
    if (differs_by_one_unit_at_most(print, right)) return std::nullopt;
  }
  for (const PrintedNumber& right : candidates) {
    auto repair = find_repair(print, right);
    if (repair && repair->agreeing_digits >= least_agreeing_digits) return repair;
  }
  return std::nullopt;
}

}  // namespace wavecurve::verification
