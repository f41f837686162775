#pragma once

#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::gait {

/// Whether y points up in tracks: a limb swings about where it is attached, so its lowest point
/// moves to and fro farther than its highest one does. Compared are the standard deviations over
/// time of the x of the points of least and of largest y, summed over the limbs LF, RF, LH and RH,
/// or over all where there are none of these.
bool y_points_up(const LimbTracks& tracks);

/// Joints of an animal that travels over a field of view, brought into the frame of its body: in
/// each frame, x is counted from the mean of the first joints of LF, RF, LH and RH, of those there
/// are, or of all limbs. One that stays in place is left as it is: where that mean moves, in all,
/// by less than half of the mean width of the animal.
void take_out_travel(LimbTracks& joints);

}  // namespace wavecurve::gait
