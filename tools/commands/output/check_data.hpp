#pragma once

#include <string>

#include "verification/checker/check_table.hpp"

namespace wavecurve::tools {

// A checked table for programs.

std::string check_as_json(const verification::CheckedTable& table);

/// The rows, with the further columns that the table had.
std::string check_as_csv(const verification::CheckedTable& table);

}  // namespace wavecurve::tools
