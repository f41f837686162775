#pragma once

#include <optional>
#include <span>
#include <string>

#include "verification/prints/printed_number.hpp"

namespace wavecurve::verification {

/// The edits by which a right number may have become the print. The order is the rule for the
/// likeliest: what a hand that copies a number does most easily comes first.
enum class Edit {
  sign,            ///< a sign lost or added
  dropped_digit,   ///< a digit of the right number is missing
  added_digit,     ///< a digit that the right number does not have
  swapped_digits,  ///< two neighbours changed places
  wrong_digit,     ///< one digit replaced by another
  moved_point,     ///< the digits are right, the point or the exponent is not
  swapped_apart,   ///< two digits that are no neighbours changed places
};

struct Repair {
  Edit edit = Edit::sign;
  PrintedNumber repaired;
  /// "a dropped 0 (decimal 9)"
  std::string description;
  /// Significant digits that agree without help of the edit: those of the right number, less the
  /// one that the edit supplies or puts in order.
  int agreeing_digits = 0;
  /// Only the last digit changes: an inaccurate computation explains that as well.
  bool only_last_digit = false;
};

/// Fewer agreeing digits than this are no evidence: among the edits of a short number one fits by
/// chance (with two digits, one wrong number in a hundred a possible edit).
inline constexpr int least_agreeing_digits = 2;

/// The single edit that turns the print into the right number (same notation, digit for digit), if
/// there is one.
std::optional<Repair> find_repair(const PrintedNumber& print, const PrintedNumber& right);

/// The likeliest of the repairs with enough agreeing digits: the candidates, roundings of the true
/// value to several numbers of decimals, are tried in the order given (the column's form first),
/// then the order of Edit decides. Nothing if no candidate is one edit away, or if one of them is
/// within one unit of the print's last digit: that is a rounding difference, no misprint.
std::optional<Repair> likeliest_repair(const PrintedNumber& print,
                                       std::span<const PrintedNumber> candidates);

}  // namespace wavecurve::verification
