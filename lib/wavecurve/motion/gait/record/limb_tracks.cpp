#include "wavecurve/motion/gait/record/limb_tracks.hpp"

#include <algorithm>

namespace wavecurve::gait {

const LimbTrack* find_track(const LimbTracks& tracks, std::string_view limb) {
  const auto found = std::ranges::find(tracks.limbs, limb, &LimbTrack::limb);
  return found == tracks.limbs.end() ? nullptr : &*found;
}

}  // namespace wavecurve::gait
