#pragma once

#include <cstddef>
#include <vector>

#include "verification/study/study_summary.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::reports {

// What a person can read of a study of thousands of settings: the best, the worst, and a map.

/// Nobody reads the tables of more settings one by one.
inline constexpr std::size_t most_settings_shown = 24;

/// A map of the solvers with steps over their accuracies: how many decimal digits the worst setting has
/// right, with the table of the smallest, median and largest errors and of the failures.
verification::Chart accuracy_map(const std::vector<verification::StudyPoint>& points);

/// The ten settings in which each model errs least, and the ten in which it errs most.
verification::Table extremes_table(const std::vector<verification::StudyPoint>& points,
                                   const verification::StudySummary& summary);

/// The smallest, median and largest error of each model for each value of what settings differ in.
verification::Table influence_table(const verification::StudySummary& summary);

/// The smallest, median and largest exponent of each solver over all settings.
verification::Table orders_overview(const verification::StudySummary& summary);
verification::Table growth_overview(const verification::StudySummary& summary);

}  // namespace wavecurve::reports
