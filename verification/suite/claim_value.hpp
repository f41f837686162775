#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wavecurve::verification {

/// A number that a claim has found: what is shown, kept as blessed, and compared. It is rounded to
/// the digits that are shown, so that it is the same wherever the computation agrees to these.
struct ClaimValue {
  std::string name;          ///< what it is; no two values of a claim have the same name
  double number = 0;         ///< finite
  std::string unit;          ///< "%", "s"; empty where there is none
  int digits = 0;            ///< how many are shown
  bool significant = false;  ///< `digits` counts significant digits, otherwise decimals
  double tolerance = 0;      ///< how far another run's number may be from this one
  std::string reason;        ///< why the tolerance is another than the maker gives; mostly empty

  bool operator==(const ClaimValue&) const = default;

  /// The same value with a tolerance of its own, and why, as one sentence.
  ClaimValue within(double own_tolerance, std::string why) const;

  /// The number as it is shown, with its unit: "46.3 %", "4e-09", "32".
  std::string text() const;
};

/// An exact number of things; the tolerance is 0.
ClaimValue counted(std::string name, long long number, std::string unit = {});

/// Rounded to so many decimals, or so many significant digits; the tolerance is half a unit of the
/// last of them. Zero has no significant digits: its tolerance is then 0.
ClaimValue to_decimals(std::string name, double number, int decimals, std::string unit = {});
ClaimValue to_digits(std::string name, double number, int digits, std::string unit = {});

/// A share in %, without the sign, for the cell of a table.
std::string percent(double share, int significant_digits = 2);

/// True if a run's number is within the tolerance of the blessed one, in the same unit. The
/// blessed tolerance counts, not the run's: a wider one has to be blessed first.
bool agrees(const ClaimValue& blessed, const ClaimValue& own);

/// What a claim has found, in numbers and in words.
struct Finding {
  Finding() = default;
  /// `words` with each {} replaced by the text of the next value, or all by number, {2} by that of
  /// the third. Values need not be shown. Throws fmt::format_error if a {} has no value.
  Finding(std::string_view words, std::vector<ClaimValue> found);

  std::string sentence;  ///< one line
  std::vector<ClaimValue> values;
};

}  // namespace wavecurve::verification
