#include "wavecurve/motion/gait/model/phase_data.hpp"

#include <vector>

#include "wavecurve/motion/gait/record/gait_cycle.hpp"

namespace wavecurve::gait {

Eigen::MatrixXd off_line(const PhaseRun& run) {
  return run.points - (1 - run.tau.array()).matrix() * run.from - run.tau * run.to;
}

PhaseRun phase_run(const Eigen::VectorXd& times, const LimbTrack& track, double begin, double end) {
  PhaseRun run{begin,
               end,
               outline_at(times, track, begin).reshaped().transpose(),
               outline_at(times, track, end).reshaped().transpose(),
               {},
               {}};
  std::vector<Eigen::Index> inside;
  for (Eigen::Index i = 0; i < times.size(); ++i) {
    if (times[i] > begin && times[i] < end) inside.push_back(i);
  }
  const auto frames = static_cast<Eigen::Index>(inside.size());
  run.tau.resize(frames);
  run.points.resize(frames, run.from.size());
  for (Eigen::Index i = 0; i < frames; ++i) {
    const Eigen::Index frame = inside[static_cast<std::size_t>(i)];
    run.tau[i] = (times[frame] - begin) / (end - begin);
    run.points.row(i) = track.outlines[static_cast<std::size_t>(frame)].reshaped().transpose();
  }
  return run;
}

}  // namespace wavecurve::gait
