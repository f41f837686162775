#include "verification/tables/column_errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "verification/tables/print_form.hpp"

namespace wavecurve::verification {

PrintError error_of(const TrueValue& value, const PrintedNumber& print, bool inaccurate) {
  const double magnitude = std::abs(value.to_double());
  const double absolute = std::log10(distance_in_units(value, print)) - print.decimals();
  const double relative =
      magnitude == 0 ? -std::numeric_limits<double>::infinity() : absolute - std::log10(magnitude);
  return {absolute, relative, inaccurate};
}

bool is_usual_error(std::span<const PrintError> column, std::size_t which) {
  constexpr double a_tenth = -1;  // as a logarithm
  constexpr std::size_t a_quarter = 4;
  const PrintError& own = column[which];
  std::size_t as_far_off = 0;
  for (std::size_t i = 0; i < column.size(); ++i) {
    const PrintError& other = column[i];
    if (i == which || !other.inaccurate) continue;
    const bool is_as_far_off =
        other.absolute >= own.absolute + a_tenth || other.relative >= own.relative + a_tenth;
    as_far_off += is_as_far_off ? 1 : 0;
  }
  return as_far_off > 0 && a_quarter * as_far_off >= column.size() - 1;
}

}  // namespace wavecurve::verification
