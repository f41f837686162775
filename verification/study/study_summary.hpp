#pragma once

#include <memory>
#include <string>
#include <vector>

#include "verification/study/power_fit.hpp"
#include "verification/study/study_point.hpp"

namespace wavecurve::verification {

/// Where the curve of a solver in closed form ends: the error of its model, which no tolerance
/// makes smaller.
struct ErrorFloor {
  std::shared_ptr<const StudySetting> setting;
  std::string solver;
  double displacement_l2_max = 0, energy_norm_max = 0;
};

/// How the error of a solver with steps falls with its evaluations, in the asymptotic range: from
/// the finest point that is above rounding on, towards the coarse ones, as long as the error grows,
/// the cost falls by at least a tenth (else stability sets the step, not the tolerance), and the
/// order between neighbours stays within a third of the median. None if these are fewer than four.
struct ObservedOrder {
  std::shared_ptr<const StudySetting> setting;
  std::string solver;
  std::vector<double> tolerances;  ///< of the points fitted, from coarse to fine
  PowerFit fit;                    ///< of the error, as 1 / evaluations ^ exponent
};

/// How the cost of a solver grows with the number of samples, all else equal; for those solved at
/// three sizes or more, at the coarsest and at the finest tolerance solved at all of them: of
/// explicit solvers stability sets the steps at the one, accuracy at the other.
struct Growth {
  std::shared_ptr<const StudySetting> setting;  ///< the largest
  std::string solver;
  std::optional<double> tolerance;
  std::vector<Eigen::Index> samples;
  PowerFit operations, seconds;
};

struct StudySummary {
  std::vector<ErrorFloor> floors;
  std::vector<ObservedOrder> orders;
  std::vector<Growth> growth;
};

/// The points of one sweep must stand together, as points_of() has them.
StudySummary summarize(const std::vector<StudyPoint>& points);

/// The settings, in the order of the points.
std::vector<StudySetting> settings_of(const std::vector<StudyPoint>& points);

/// "db4, 64 samples, 6 levels; ellipse, damping 0, 0.1".
std::string name_of(const StudySetting& setting);

}  // namespace wavecurve::verification
