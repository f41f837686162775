#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::certified {

/// The filter of a canonical name or an alias: db1-db38 (haar, D2-D76), sym2-sym20, coif1.. (K1..),
/// cdf9.7 (bior4.4), bsplineD.E for every D >= 1, E >= 1 with D + E even.
/// Throws std::invalid_argument with a message that names the text and what is accepted.
FilterDefinition find_filter(std::string_view name);

/// The canonical name of a name or alias. Throws as find_filter does.
std::string canonical_filter_name(std::string_view name);

/// Every canonical name of the finite families; the splines, being infinitely many, up to order 8.
std::vector<std::string> filter_names();

}  // namespace wavecurve::certified
