#pragma once

#include <limits>
#include <string>
#include <utility>

#include "wavecurve/filters/filter.hpp"

namespace wavecurve {

/// The four filters of a two-channel bank with perfect reconstruction, indexed as in the
/// publication.
///
/// The functions that curves are expanded in belong to the synthesis side (2.1):
///   phi(t) = sqrt 2 sum_n synthesis_low_n  phi(2t - n),
///   psi(t) = sqrt 2 sum_n synthesis_high_n phi(2t - n).
/// The analysis side computes the coefficients by correlation (2.8), c_n = sum_l low_{l-2n} c_l.
/// The two low-pass filters are biorthogonal, sum_k analysis_low_k synthesis_low_{k+2n} = delta_n;
/// for an orthonormal family they are equal. The high-pass filters follow from (2.2):
///   synthesis_high_k = (-1)^k analysis_low_{1-k},  analysis_high_k = (-1)^k synthesis_low_{1-k}.
template <class Scalar = double>
struct FilterBank {
  std::string name;
  Filter<Scalar> analysis_low, analysis_high, synthesis_low, synthesis_high;
  /// Zeros of synthesis_low at z = -1: the vanishing moments of the analysis wavelet, and the
  /// number of polynomial degrees that shifts of phi reproduce.
  int vanishing_moments = 0;
  /// Zeros of analysis_low at z = -1: the vanishing moments of psi.
  int dual_vanishing_moments = 0;
  /// phi lies in the Sobolev space H^s for every s below this number, and for no s above it.
  double sobolev_exponent = std::numeric_limits<double>::quiet_NaN();

  bool is_orthonormal() const { return analysis_low == synthesis_low; }
};

/// The conjugate mirror g_k = (-1)^k h_{1-k} of (2.2).
template <class Scalar>
Filter<Scalar> conjugate_mirror(const Filter<Scalar>& low) {
  Filter<Scalar> high;
  high.first_index = 1 - low.last_index();
  high.taps.reserve(low.taps.size());
  for (int k = high.first_index; k <= 1 - low.first_index; ++k) {
    high.taps.push_back(k % 2 == 0 ? low[1 - k] : -low[1 - k]);
  }
  return high;
}

/// The bank of a pair of biorthogonal low-pass filters; the high-pass filters follow by (2.2).
template <class Scalar>
FilterBank<Scalar> make_filter_bank(std::string name, Filter<Scalar> analysis_low,
                                    Filter<Scalar> synthesis_low) {
  FilterBank<Scalar> bank;
  bank.name = std::move(name);
  bank.analysis_high = conjugate_mirror(synthesis_low);
  bank.synthesis_high = conjugate_mirror(analysis_low);
  bank.analysis_low = std::move(analysis_low);
  bank.synthesis_low = std::move(synthesis_low);
  return bank;
}

}  // namespace wavecurve
