#pragma once

#include <optional>
#include <string>

#include "wavecurve/filters/filter.hpp"

namespace wavecurve {

/// A filter that a user brings, as printed: taps are decimals, so that nothing is lost or
/// pretended.
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
};

}  // namespace wavecurve
