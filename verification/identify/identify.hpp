#pragma once

#include <string>
#include <vector>

#include "verification/identify/known_columns.hpp"
#include "verification/identify/number_lists.hpp"
#include "verification/quantities/convention.hpp"

namespace wavecurve::verification {

/// What a list of numbers is, or may be.
struct Match {
  const KnownColumn* column = nullptr;
  /// Entry i of the list, with the index first_index + i (or the support's first + i if the list
  /// has none), follows from the column's values by this; half_powers hold if scale_is_power.
  Convention convention;
  double scale = 1;
  bool scale_is_power = true;  ///< of sqrt 2
  bool in_order = true;        ///< false: the numbers are among the column's, in another order
  int matched = 0, of = 0;
  double evidence = 0;  ///< decimal digits in which the matched agree, all together
  double digits = 0;    ///< right in the worst of the matched, relative to the largest of the list
};

/// The columns that a list may be, the best first: those that have most of its numbers, then the
/// simplest convention, then most digits; one of each filter. A column is a match if it has at least
/// two of the numbers, and two thirds of them, each to within two units of its last digit or 2e-5 of
/// itself, and if they agree in ten digits all together, more than chance would give.
///
/// An index over the magnitudes of all known columns, one sorted list for every power of sqrt 2
/// from 1/4 to 4 and one for the columns divided by their largest entry, gives the candidates; each
/// is then laid over the list in either direction and at every shift.
std::vector<Match> identify(const NumberList& list);

/// A column that is none of the matches, and how far its entries are from the list's where their
/// magnitudes, largest first and divided by the largest, are compared.
struct NearMiss {
  const KnownColumn* column = nullptr;
  double distance = 0;
};

/// The three nearest among the filters that do not match, the nearest first: the runners-up.
std::vector<NearMiss> nearest_columns(const NumberList& list, const std::vector<Match>& matches);

/// "sqrt2", "1/sqrt2", "4", "1.3333": the factor of a match.
std::string scale_text(const Match& match);

}  // namespace wavecurve::verification
