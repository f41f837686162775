#pragma once

#include <optional>
#include <string>

#include "verification/quantities/list_quantity.hpp"

namespace wavecurve::tools {

/// `coefficients NAME --quantity Q`: the entries of one quantity of a filter (quantity.hpp), as
/// text, json, csv, cpp, markdown or latex. Throws as parse_quantity, io::load_filter and
/// list_quantity.
std::string quantity_output(const std::string& filter, const std::string& quantity,
                            const verification::ListingRequest& request, const std::string& format);

/// Where integrals are taken: over the line, if neither is given.
struct IntegralRange {
  std::optional<std::string> on;  ///< an interval, "0,1/2", or "0,x" for every x
  std::optional<int> period;      ///< of the factors, made periodic
  int level = 0;                  ///< x at multiples of 2^-level
};

/// `coefficients NAME --integral I [--on A,B | --on 0,x | --period N]`: every integral of
/// integral_expression.hpp. Throws as parse_integral, parse_interval, io::load_filter and
/// certified::integral_decimals.
std::string integral_output(const std::string& filter, const std::string& integral,
                            const IntegralRange& range, int digits, const std::string& format);

}  // namespace wavecurve::tools
