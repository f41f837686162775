#pragma once

#include "verification/checker/check_table.hpp"

namespace wavecurve::verification {

/// A checked table whose prints are names of doubles: every row whose double is the nearest to the true value is
/// certified, for no double is nearer, whatever the decimals by which it was printed. Proved, as all verdicts are.
CheckedTable judged_as_doubles(CheckedTable table);

}  // namespace wavecurve::verification
