#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "verification/prints/printed_number.hpp"
#include "verification/prints/true_value.hpp"

namespace wavecurve::verification {

/// How far a print is off, as decimal logarithms: numbers of any size have them.
struct PrintError {
  double absolute = 0;  ///< of |print - value|
  double relative = 0;  ///< of |print / value - 1|; minus infinity if the value is zero
  /// The print is proved wrong, and no single edit of its first digits explains it.
  bool inaccurate = false;
};

PrintError error_of(const TrueValue& value, const PrintedNumber& print, bool inaccurate);

/// The errors of a column, for the question whether an edit is evidence of a misprint.
class ColumnErrors {
 public:
  /// One for each entry of the column.
  explicit ColumnErrors(std::span<const PrintError> errors);

  /// Is this entry's error one as the column has them all over: are at least a quarter of the others
  /// inaccurate and at least a tenth as far off, absolutely or relatively? An edit that happens to
  /// turn such a print into the right number is no evidence: among the numbers that are off by up
  /// to 10^k units of the last digit, some 10 k are one edit away.
  bool are_usual_as(const PrintError& own) const;

 private:
  std::vector<double> absolute_, relative_;  ///< of the inaccurate entries, sorted
  std::ptrdiff_t entries_;
};

}  // namespace wavecurve::verification
