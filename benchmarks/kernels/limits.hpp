#pragma once

namespace wavecurve::tracking {

/// What the machine can do at best, of one core: each the best of several runs, since other
/// programs only ever take away from it.

/// Seconds that a copy takes in which so many bytes are read and written together (STREAM's copy:
/// half of them read, half written).
double copy_seconds(double bytes);

/// Additions and multiplications of doubles a second, by the widest vectors, without fusing any.
double arithmetic_peak();

}  // namespace wavecurve::tracking
