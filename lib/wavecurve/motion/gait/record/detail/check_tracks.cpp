#include "wavecurve/motion/gait/record/detail/check_tracks.hpp"

#include <cmath>
#include <set>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;

void check_times(const Eigen::VectorXd& times) {
  constexpr Index fewest = 4;
  check_at_least("the number of frames", times.size(), fewest);
  for (Index i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || (i > 0 && times[i] <= times[i - 1])) {
      throw std::invalid_argument(fmt::format(
          "the time of frame {} is {}, but times must be finite and increase", i, times[i]));
    }
  }
}

void check_track(const LimbTrack& track, Index frames) {
  if (static_cast<Index>(track.outlines.size()) != frames) {
    throw std::invalid_argument(fmt::format("limb '{}' has {} outlines, but there are {} frames",
                                            track.limb, track.outlines.size(), frames));
  }
  const Index points = track.outlines.front().rows();
  for (std::size_t i = 0; i < track.outlines.size(); ++i) {
    const Contour& outline = track.outlines[i];
    if (outline.rows() != points || points < 4) {
      throw std::invalid_argument(
          fmt::format("limb '{}' has {} points in frame {}, but must have {} in all", track.limb,
                      outline.rows(), i, points < 4 ? "at least 4" : fmt::format("{}", points)));
    }
    if (!outline.allFinite()) {
      throw std::invalid_argument(
          fmt::format("limb '{}' has a point that is not finite in frame {}", track.limb, i));
    }
  }
}

}  // namespace

void check_tracks(const LimbTracks& tracks) {
  check_times(tracks.times);
  if (tracks.limbs.empty()) throw std::invalid_argument("the record has no limbs");
  std::set<std::string> names;
  for (const LimbTrack& track : tracks.limbs) {
    check_track(track, tracks.times.size());
    if (!names.insert(track.limb).second) {
      throw std::invalid_argument(fmt::format("limb '{}' is there twice", track.limb));
    }
  }
}

}  // namespace wavecurve::gait
