#pragma once

#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/filters/user_filter.hpp"

namespace wavecurve::certified {

/// The definition of a user's own filter, after a check of what it claims.
///
/// A tap is a decimal, "-0.125" or "1.25e-1", or a fraction of two, "75/64". A zero, with however
/// many digits, is exactly zero; zeros at either end are taken off. Decimals that satisfy every
/// relation exactly are exact numbers, and so are fractions. Otherwise each tap stands for all
/// numbers within the stated accuracy, or for all that round to it (half a unit of its last digit
/// either way), and everything computed from it encloses the result for every filter in that box
/// that satisfies the relations: the radius says what the digits are worth.
///
/// Relations: the sums, biorthonormality at every lag, and the claimed zeros at pi; where none are
/// claimed as many as the box admits, at most half as many as there are taps (of long filters that
/// may be more than are meant: the doubles of coif14, which has 28, admit 30). Throws
/// std::invalid_argument if one is violated by every filter in the box, naming it, by how much, and
/// the accuracy that would be accepted: one at which the box holds a filter that satisfies all of
/// them to first order. Throws also for an empty filter, a name of more than 200 characters, more than 256 taps, indices beyond 10000,
/// a tap that is no number or has more than 1000 digits, an unknown sum, a negative claim, an
/// accuracy that is not above 0 and below 1.
FilterDefinition define_user_filter(const UserFilter& filter);

}  // namespace wavecurve::certified
