#pragma once

namespace wavecurve {

/// The angle of the point (x, y), -pi .. pi, in the order of arguments and with the special values
/// of std::atan2: within one unit in the last place of the true value (the bound that is proved is
/// smaller: elementary/detail/elementary_tables.hpp), and the same bits on every processor.
double arctangent(double y, double x);

/// The angle whose cosine is x, 0 .. pi: arctangent(sqrt((1 - x)(1 + x)), x), within two units. Of
/// |x| > 1, no number.
double arccosine(double x);

/// sin(x) / cos(x), within five units: one of a factor may be two of the quotient.
double tangent(double x);

}  // namespace wavecurve
