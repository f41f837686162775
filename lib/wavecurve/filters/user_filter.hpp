#pragma once

#include <optional>
#include <string>

#include "wavecurve/filters/filter.hpp"

namespace wavecurve {

/// A filter that a user brings, as printed: taps are decimals or fractions of them, so that nothing
/// is lost or pretended. What begins with `dual_` is that of the dual side where it is another.
struct UserFilter {
  std::string name;
  /// The low-pass filter of phi (synthesis side).
  Filter<std::string> taps;
  /// The low-pass filter of the dual scaling function (analysis side); none for an orthonormal
  /// filter.
  std::optional<Filter<std::string>> dual = {};
  /// What the taps add up to: "sqrt2" (orthonormal normalisation), "1" or "2".
  std::string sum = "sqrt2";
  /// The numbers of zeros at pi, where the user claims them.
  std::optional<int> vanishing_moments = {}, dual_vanishing_moments = {};
  std::optional<std::string> dual_sum = {};
  /// A bound of the error of every tap, in the units in which it is printed; without one it is half
  /// a unit of the tap's last digit.
  std::optional<std::string> accuracy = {}, dual_accuracy = {};
};

}  // namespace wavecurve
