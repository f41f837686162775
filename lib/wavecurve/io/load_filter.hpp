#pragma once

#include <string>

#include "wavecurve/certified/filter_definition.hpp"

namespace wavecurve::io {

/// The filter of a name (certified/find_filter.hpp) or, if the text ends in ".json", of a user's
/// file (io/filter_json.hpp). Throws as those do.
certified::FilterDefinition load_filter(const std::string& name_or_path);

/// The same in double precision: the library's tables for a name, the nearest doubles for a file.
FilterBank<double> load_filter_bank(const std::string& name_or_path);

}  // namespace wavecurve::io
