#pragma once

#include <string>

#include "verification/quantities/list_quantity.hpp"

namespace wavecurve::tools {

/// `coefficients NAME --quantity Q` and `--integral I`: the entries of one quantity of a filter, as
/// text, json, csv, cpp, markdown or latex. `integral` is the inside of int(...), or empty if `quantity` is given.
struct QuantityOutput {
  std::string filter;  ///< a name or a path
  std::string quantity, integral, format;
  verification::ListingRequest request;
};

/// Throws as parse_quantity, io::load_filter and list_quantity.
std::string quantity_output(const QuantityOutput& options);

}  // namespace wavecurve::tools
