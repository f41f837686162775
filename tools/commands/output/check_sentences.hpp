#pragma once

#include <string>
#include <vector>

#include "verification/checker/check_table.hpp"

namespace wavecurve::tools {

// What is said of a checked table beside its rows, in every format for people.

/// A distance in units of the last digit, or nothing for a fraction, which has no last digit.
std::string ulps_text(double ulps, int digits);

/// One sentence for each column that does not follow the library's own convention, or is another
/// solution of the filter's equations.
std::vector<std::string> convention_sentences(const verification::CheckedTable& table);

/// What columns have in common, beyond chance.
std::vector<std::string> habit_sentences(const verification::CheckedTable& table);

/// For each column where its entries come from.
std::vector<std::string> route_sentences(const verification::CheckedTable& table);

}  // namespace wavecurve::tools
