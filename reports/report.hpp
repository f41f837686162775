#pragma once

#include <string>
#include <utility>
#include <vector>

#include "verification/suite/publication.hpp"
#include "verification/suite/run_claims.hpp"

namespace wavecurve::reports {

/// What every form of the report is written from.
struct Report {
  verification::Publication publication;
  std::string generated;  ///< date and time; the only part that differs between two runs
  std::string program;    ///< the version of the program
  std::vector<verification::ClaimResult> results;
};

/// How many claims have each verdict, in the order of the enumeration, without the zeros.
std::vector<std::pair<verification::ClaimVerdict, int>> count_verdicts(
    const std::vector<verification::ClaimResult>& results);

/// Now in UTC as 2026-01-31T12:00:00Z, or the time of SOURCE_DATE_EPOCH where that is set.
/// Throws std::invalid_argument if SOURCE_DATE_EPOCH is no number of seconds.
std::string date_of_report();

}  // namespace wavecurve::reports
