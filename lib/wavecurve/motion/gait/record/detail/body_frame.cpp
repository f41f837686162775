#include "wavecurve/motion/gait/record/detail/body_frame.hpp"

#include <cmath>
#include <vector>

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

std::vector<const LimbTrack*> legs_of(const LimbTracks& tracks) {
  std::vector<const LimbTrack*> legs, all;
  for (const LimbTrack& track : tracks.limbs) {
    all.push_back(&track);
    const std::string& name = track.limb;
    if (name == "LF" || name == "RF" || name == "LH" || name == "RH") legs.push_back(&track);
  }
  return legs.empty() ? all : legs;
}

double deviation(const VectorXd& values) {
  return std::sqrt((values.array() - values.mean()).square().mean());
}

}  // namespace

bool y_points_up(const LimbTracks& tracks) {
  double least = 0, largest = 0;
  for (const LimbTrack* track : legs_of(tracks)) {
    VectorXd at_least(tracks.times.size()), at_largest(tracks.times.size());
    for (Index i = 0; i < tracks.times.size(); ++i) {
      const Contour& outline = track->outlines[static_cast<std::size_t>(i)];
      Index row = 0;
      outline.col(1).minCoeff(&row);
      at_least[i] = outline(row, 0);
      outline.col(1).maxCoeff(&row);
      at_largest[i] = outline(row, 0);
    }
    least += deviation(at_least);
    largest += deviation(at_largest);
  }
  return least > largest;
}

void take_out_travel(LimbTracks& joints) {
  const Index frames = joints.times.size();
  VectorXd place = VectorXd::Zero(frames), low(frames), high(frames);
  const auto legs = legs_of(joints);
  for (Index i = 0; i < frames; ++i) {
    const auto time = static_cast<std::size_t>(i);
    for (const LimbTrack* leg : legs) place[i] += leg->outlines[time](0, 0);
    low[i] = high[i] = joints.limbs[0].outlines[time](0, 0);
    for (const LimbTrack& limb : joints.limbs) {
      low[i] = std::min(low[i], limb.outlines[time].col(0).minCoeff());
      high[i] = std::max(high[i], limb.outlines[time].col(0).maxCoeff());
    }
  }
  place /= static_cast<double>(legs.size());
  if (place.maxCoeff() - place.minCoeff() < (high - low).mean() / 2) return;
  for (LimbTrack& limb : joints.limbs) {
    for (Index i = 0; i < frames; ++i) {
      limb.outlines[static_cast<std::size_t>(i)].col(0).array() -= place[i];
    }
  }
}

}  // namespace wavecurve::gait
