#include "verification/prints/column_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "wavecurve/elementary/logarithm.hpp"

#include "verification/prints/print_form.hpp"

namespace wavecurve::verification {

PrintError error_of(const TrueValue& value, const PrintedNumber& print, bool inaccurate) {
  const double magnitude = std::abs(value.to_double());
  const double absolute = logarithm_10(distance_in_units(value, print)) - print.decimals();
  const double relative = magnitude == 0 ? -std::numeric_limits<double>::infinity()
                                         : absolute - logarithm_10(magnitude);
  return {absolute, relative, inaccurate};
}

ColumnErrors::ColumnErrors(std::span<const PrintError> errors)
    : entries_(static_cast<std::ptrdiff_t>(errors.size())) {
  for (const PrintError& error : errors) {
    if (!error.inaccurate) continue;
    absolute_.push_back(error.absolute);
    relative_.push_back(error.relative);
  }
  std::sort(absolute_.begin(), absolute_.end());
  std::sort(relative_.begin(), relative_.end());
}

bool ColumnErrors::are_usual_as(const PrintError& own) const {
  constexpr double a_tenth = -1;  // as a logarithm
  constexpr std::ptrdiff_t a_quarter = 4;
  const auto at_least = [](const std::vector<double>& sorted, double bound) {
    return sorted.end() - std::lower_bound(sorted.begin(), sorted.end(), bound);
  };
  const auto as_far_off = std::max(at_least(absolute_, own.absolute + a_tenth),
                                   at_least(relative_, own.relative + a_tenth)) -
                          (own.inaccurate ? 1 : 0);
  return as_far_off > 0 && a_quarter * as_far_off >= entries_ - 1;
}

}  // namespace wavecurve::verification
