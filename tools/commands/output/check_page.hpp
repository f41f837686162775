#pragma once

#include <string>

#include "verification/checker/check_table.hpp"

namespace wavecurve::tools {

/// A checked table as a page of HTML in the style of the report, whole in itself: counts by verdict
/// with which rows are shown or hidden, the rows with their departing digits marked (in bold and
/// underlined as well as in colour), what is said of conventions and routes, and what the verdicts
/// mean. Without JavaScript all rows are shown; on paper those that were chosen.
std::string check_as_page(const verification::CheckedTable& table);

}  // namespace wavecurve::tools
