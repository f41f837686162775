#pragma once

#include <vector>

#include "wavecurve/certified/decimal_enclosure.hpp"

#include "verification/quantities/filter_values.hpp"

namespace wavecurve::verification {

struct ListedEntry {
  EntryIndex index;
  certified::DecimalEnclosure number;
};

/// Which entries list_quantity gives.
struct ListingRequest {
  int digits = 40;          ///< significant digits, at least 1
  int level = 0;            ///< of functions: points k / 2^level
  int highest_moment = 10;  ///< of moments
};

/// Every entry of a quantity that does not vanish by structure, and the zeros between them, each
/// correctly rounded to the digits asked for; where a user's own taps do not decide a rounding, as
/// many digits as are proved, and the radius tells the rest. Pairs l, m: row by row in l.
/// Throws as FilterValues::value, and std::invalid_argument for digits below 1, a level outside
/// 0 .. highest_dyadic_level, or a moment outside 0 .. highest_moment.
std::vector<ListedEntry> list_quantity(FilterValues& filter, const Quantity& quantity,
                                       const ListingRequest& request = {});

}  // namespace wavecurve::verification
