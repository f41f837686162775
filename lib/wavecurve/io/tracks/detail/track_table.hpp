#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::io {

/// What a table of tracks says, before anything is resampled or skinned.
struct TrackTable {
  gait::LimbTracks tracks;  ///< points as they are: outlines, or chains of joints; y as in the file
  bool joints = false;
  bool treadmill = false;               ///< x is in the frame of the body
  std::vector<std::string> warnings{};  ///< what was interpolated, or not read
};

/// DeepLabCut's own bound of what it shows.
inline constexpr double usual_likelihood = 0.6;

/// The table that the text of a CSV file holds, of the limbs named, or of all. What
/// read_limb_tracks says holds; the messages do not name the file.
TrackTable read_track_table(std::string_view text, const std::vector<std::string>& limbs,
                            double least_likelihood = usual_likelihood);

}  // namespace wavecurve::io
