#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// The filter bank of a name such as "db4", "D8", "coif2", "K2", "sym4", "bspline4.4", "cdf9.7",
/// "bior6.8", "rbio2.2" (certified/find_filter.hpp), every tap the correctly rounded one. The tables are generated (tools/generate_filter_tables.cpp)
/// from certified enclosures; splines of any order are rounded exactly when asked for.
/// Scalar is double or float. Throws std::invalid_argument naming an unknown name.
template <class Scalar = double>
FilterBank<Scalar> find_filter_bank(std::string_view name);

}  // namespace wavecurve
