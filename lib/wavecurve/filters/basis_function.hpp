#pragma once

#include <string>

namespace wavecurve {

/// One of the four functions of a filter bank, or a derivative of one:
///   phi, psi of the synthesis side, phi~, psi~ of the analysis side (filters/filter_bank.hpp).
struct BasisFunction {
  bool wavelet = false;  ///< psi rather than phi
  bool dual = false;     ///< of the analysis side
  int derivative = 0;

  bool operator==(const BasisFunction&) const = default;
};

/// The highest order of a derivative that is accepted.
inline constexpr int highest_derivative = 8;

/// "phi", "psi~''", "phi^(4)".
std::string name_of(const BasisFunction& f);

}  // namespace wavecurve
