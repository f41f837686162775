#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve::gait {

/// The outlines of one limb over time. All have the same number of points, and point k is the same
/// point of the limb at all times.
struct LimbTrack {
  std::string limb;  ///< LF, RF, LH, RH (left, right; fore, hind), BODY, HEAD, TAIL, or any name
  std::vector<Contour> outlines;  ///< one a time
};

/// A traced animal, in the frame of its body: on a treadmill, where a foot that stands on the
/// ground moves backwards. As in SVG, y points down. Publication, section 4.2 and Figure 10.
struct LimbTracks {
  Eigen::VectorXd times;  ///< strictly increasing: seconds, or numbers of frames
  std::vector<LimbTrack> limbs;
};

/// The track of a limb; none if it was not recorded.
const LimbTrack* find_track(const LimbTracks& tracks, std::string_view limb);

}  // namespace wavecurve::gait
