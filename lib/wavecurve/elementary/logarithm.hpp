#pragma once

namespace wavecurve {

/// The natural logarithm within one unit in the last place of the true value (the bound that is
/// proved is smaller: elementary/detail/elementary_tables.hpp), and the same bits on every
/// processor. Of 0, minus infinity; below 0, and of what is no number, no number.
double logarithm(double x);

/// log(x) / log(10), within three units: one of the logarithm may be two of the quotient. Exact for
/// powers of ten that are doubles, 10^0 .. 10^22.
double logarithm_10(double x);

}  // namespace wavecurve
