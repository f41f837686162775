#pragma once

#include <string>

#include "tools/commands/output/markup_table.hpp"
#include "verification/checker/check_table.hpp"

namespace wavecurve::tools {

// A checked table for people.

struct CheckTextOptions {
  bool colour = false;   ///< departing digits in red, for a terminal
  bool explain = false;  ///< below each row a line with carets under its departing digits
};

std::string check_as_text(const verification::CheckedTable& table, const CheckTextOptions& options);

/// For Markdown and LaTeX, the departing digits marked. With `plain`, numbers are written in plain
/// decimals instead of the way the table has them.
MarkupTable check_as_markup(const verification::CheckedTable& table, bool plain);

}  // namespace wavecurve::tools
