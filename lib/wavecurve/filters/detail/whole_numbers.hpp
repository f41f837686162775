#pragma once

#include <bit>
#include <cstdint>

#include <Eigen/Core>

namespace wavecurve {

/// floor(n / 2), also of negative n.
constexpr int floor_half(int n) { return (n - (n & 1)) / 2; }

/// Whether n is 2^k, k >= 0.
constexpr bool is_power_of_two(Eigen::Index n) { return n > 0 && (n & (n - 1)) == 0; }

/// How often n > 0 can be halved: the number of levels of a full transform of n samples, and
/// log2 n of a power of two.
constexpr int all_levels(Eigen::Index n) { return std::countr_zero(static_cast<std::uint64_t>(n)); }

/// log2 of a number of samples. Throws std::invalid_argument unless it is a power of two from 1 to
/// 2^24.
int checked_log2(Eigen::Index samples);

}  // namespace wavecurve
