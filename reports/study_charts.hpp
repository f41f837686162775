#pragma once

#include <string>
#include <vector>

#include "verification/study/study_summary.hpp"
#include "verification/suite/claim.hpp"

namespace wavecurve::reports {

// The charts of `wavecurve compare`, each with its numbers as a table; where there is nothing to draw,
// a chart has no script.

/// The relative error that an eye does not see.
inline constexpr double small_error = 0.05;

/// What a setting does not have in common with all of them, in few words; its shape if there is
/// nothing.
class ShortNames {
 public:
  explicit ShortNames(const std::vector<verification::StudySetting>& all);
  std::string operator()(const verification::StudySetting& setting) const;

 private:
  bool filter_, samples_, levels_, shape_, mass_damping_, stiffness_damping_;  ///< what differs
};

/// Where every solver's curve ends, setting by setting: the floors of the models, and the least
/// error of the solvers with steps.
verification::Chart floors_chart(const std::vector<verification::StudyPoint>& points);

/// Work against precision in one setting: the error over the operations, one symbol a solver, and
/// the models' floors as named lines; the operations of the
/// exact one as a vertical line. The number makes the id unique.
verification::Chart work_precision_chart(const std::vector<verification::StudyPoint>& points,
                                         const verification::StudySetting& setting, int number);

/// The model's error over time in one setting; no rows if no model was asked for.
verification::Chart model_error_chart(const std::vector<verification::StudyPoint>& points,
                                      const verification::StudySetting& setting, int number);

/// Observed orders, growth of costs, with their intervals.
verification::Table orders_table(const verification::StudySummary& summary);
verification::Table growth_table(const verification::StudySummary& summary);

}  // namespace wavecurve::reports
