#include "wavecurve/motion/gait/record/limb_tracks.hpp"

#include <gtest/gtest.h>

namespace wavecurve::gait {
namespace {

TEST(FindTrack, IsTheTrackOfThatName) {
  const LimbTracks tracks{{}, {{"LF", {}}, {"RF", {}}}};
  EXPECT_EQ(find_track(tracks, "RF"), &tracks.limbs[1]);
  EXPECT_EQ(find_track(tracks, "R"), nullptr);
}

}  // namespace
}  // namespace wavecurve::gait
