#pragma once

#include <string>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

/// Numbers as short decimals for files that people download: rounded to a number of places, without
/// trailing zeros, the same on every machine.
class Decimals {
 public:
  /// Places 0 .. 15.
  explicit Decimals(int places);

  /// The fewest places whose unit is at most `accuracy` of the longer side; so a written
  /// coordinate is off by at most half of that. At 1e-4, that is a tenth of a pixel on a screen of
  /// 2000.
  static Decimals for_box(const ViewBox& box, double accuracy);

  int places() const { return places_; }
  void append(std::string& text, double value) const;
  std::string text(double value) const;
  /// The value that the text stands for.
  double rounded(double value) const;

 private:
  int places_;
  double power_;  ///< 10^places
};

}  // namespace wavecurve::io
