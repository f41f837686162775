#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::gait {

/// The frames of a limb between two of its key frames. A coefficient is one coordinate of one
/// control point: columns hold the x of all points, then the y.
struct PhaseRun {
  double begin = 0, end = 0;    ///< times of the key frames q_1 and q_2
  Eigen::RowVectorXd from, to;  ///< the control points there
  Eigen::VectorXd tau;          ///< of the frames inside, 0 < tau < 1
  Eigen::MatrixXd points;       ///< their control points, one row a frame
};

/// A phase of a limb, once a cycle.
struct PhaseData {
  std::string phase;
  std::vector<PhaseRun> runs;
  double begin = 0, end = 1;  ///< of the phase, as shares of the cycle from touch-down on
};

/// What is left of the points of a run by the straight line between its key frames:
/// points - q_2 - (q_1 - q_2) (1 - tau).
Eigen::MatrixXd off_line(const PhaseRun& run);

/// The frames of a track between two times, and the key frames there (outline_at).
PhaseRun phase_run(const Eigen::VectorXd& times, const LimbTrack& track, double begin, double end);

}  // namespace wavecurve::gait
