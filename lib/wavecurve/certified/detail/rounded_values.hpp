#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "wavecurve/certified/ball.hpp"
#include "wavecurve/certified/decimal_enclosure.hpp"

namespace wavecurve::certified {

/// The numbers that compute(bits) encloses to about `bits` bits of the largest, correctly rounded
/// to this many significant digits: the bits are doubled until every rounding is decided. What is
/// exactly zero is "0", with the fraction "0".
///
/// A number that vanishes, but not by structure, cannot be told from one that is very small. When
/// its enclosure still holds zero at 10^-(digits + 100) of the largest number, it is "0" with the
/// radius that is proved. Where the data themselves have only known_bits, numbers have as many
/// digits as are proved.
std::vector<DecimalEnclosure> rounded_values(
    const std::function<std::vector<Ball>(long bits)>& compute, int digits,
    std::optional<long> known_bits = std::nullopt);

}  // namespace wavecurve::certified
