#pragma once

#include <span>
#include <vector>

namespace wavecurve::verification {

// How probable it is that a computation which has nothing to do with a column yields its digits.

/// A route is credited only if chance explains it with less than this probability, all computations
/// that were tried taken into account.
inline constexpr double credible_chance = 1e-6;

/// What is less is not told apart.
inline constexpr double least_chance = 1e-300;

/// One entry of a column, as the search for chance sees it.
struct EntryError {
  double distance = 0;   ///< |print - true value| in units of the print's last digit
  double unit = 0;       ///< that unit
  double allowance = 0;  ///< for rounding errors, in that unit
  double magnitude = 0;  ///< |print|
};

/// For each entry the probability that an unrelated computation of the same accuracy yields the
/// print: its error is taken as uniform in [-R, R] last units, and has to fall into an interval of
/// length 1 + 2 allowance,
///
///   p = min(1, (1 + 2 allowance) / (2 R)),   R = max(distance, what is typical of the column),
///
/// twice the median of the column's distances being typical (the median of a uniform error is R/2):
/// in last units, in absolute terms or relative to the entry, whichever is least. An entry that is
/// exactly right says nothing, p = 1. Where the true range is wider than R the probability is
/// overestimated.
std::vector<double> chance_of_each(std::span<const EntryError> entries);

/// The probability that at least `least` of independent events happen, these being their
/// probabilities; least_chance where it is less. Sums of positive terms only, so it is right to a few
/// units in the last place; of so many events that this would take more than 4 million steps it is
/// Hoeffding's bound, which is not less.
double chance_of_at_least(int least, std::span<const double> probabilities);

/// The number of ways to choose k of n.
double ways_to_choose(int n, int k);

}  // namespace wavecurve::verification
