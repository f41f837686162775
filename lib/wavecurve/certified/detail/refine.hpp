#pragma once

#include <optional>
#include <stdexcept>

#include "wavecurve/certified/ball.hpp"

namespace wavecurve::certified {

/// How often refine() doubles the precision before it gives up: the last attempt has 32 times the
/// bits of the first.
inline constexpr int precision_doublings = 5;

/// Calls attempt(bits) at ever higher working precision, first_bits and then twice as many each
/// time, until it answers: an answer is whatever converts to true, such as a filled optional. A
/// std::domain_error says that the enclosures were too wide, and is no answer either.
///
/// After precision_doublings it stops, and what the last attempt returned is returned, or the
/// std::domain_error that it threw is thrown. It stops as well at a precision above known_bits,
/// those that the data themselves have: no precision narrows the enclosures of a user's own
/// decimals. The attempt runs with WorkingPrecision(bits). Other exceptions pass at once.
template <class Attempt>
auto refine(long first_bits, Attempt attempt, std::optional<long> known_bits = std::nullopt) {
  long bits = first_bits;
  for (int doubling = 0;; ++doubling, bits *= 2) {
    const bool is_last = doubling == precision_doublings || (known_bits && bits > *known_bits);
    const WorkingPrecision precision(bits);
    try {
      auto answer = attempt(bits);
      if (answer || is_last) return answer;
    } catch (const std::domain_error&) {
      if (is_last) throw;
    }
  }
}

}  // namespace wavecurve::certified
