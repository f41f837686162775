#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::gait {

/// Where the foot reverses: from swing to stance, or from stance to swing.
struct Reversal {
  double time = 0;          ///< between frames: the vertex of a parabola
  bool touch_down = false;  ///< foremost; else rearmost, lift-off
};

struct LimbCycle {
  std::string limb;
  Eigen::Index foot = 0;            ///< the point of the outline
  std::vector<Reversal> reversals;  ///< in time, touch-downs and lift-offs by turns
  double duty_factor =
      0;  ///< mean duration of a stance, from reversal to reversal, over the period
  double touch_down =
      0;  ///< mean, after that of LF (or of the first limb), as a share of the period
  double excursion = 0;  ///< mean fore-aft distance between reversals
};

struct GaitCycle {
  double period = 0;  ///< in units of the tracks' times
  double facing = 1;  ///< 1: the animal looks to larger x, -1: to smaller
  double ground_speed =
      0;              ///< at which feet that stand move backwards, in units of length and time
  double stride = 0;  ///< length: ground_speed * period, by which the animal gets on in a cycle
  bool is_loop =
      false;  ///< the record was taken for one cycle, whose last frame is before its first
  std::vector<LimbCycle> limbs;  ///< of LF, RF, LH, RH, those there are, in this order
};

/// What the tracks of the limbs LF, RF, LH, RH tell about the gait; other tracks are left out.
///
/// The foot is the point of the outline, averaged over its neighbourhood of 1/16 of the points,
/// whose position varies most. Its reversals are the turning points of its fore-aft position,
/// between which it moves by more than 0.4 of its range (smaller ones are noise). The foot is lower
/// while it stands than while it swings, which tells where the animal looks to; the ground's speed
/// is the median of that of the feet in the middle halves of the stances.
/// A record of a single cycle, which leaves no reversal twice, is taken for a loop if its last
/// frame is as close to its first as neighbouring frames are.
///
/// Throws std::invalid_argument: less than 4 frames; tracks of different lengths; no fore or no
/// hind limb; values that are not finite; an outline that changes its number of points; a limb
/// whose foot does not move, or completes no cycle.
GaitCycle analyse_cycle(const LimbTracks& tracks);

/// The outline of a track at any time of the record: cubic between the four nearest frames, of
/// fewer all.
Contour outline_at(const Eigen::VectorXd& times, const LimbTrack& track, double time);

/// The record three times in a row, the second one at its own times; a loop's last frame and its
/// first are as far apart as frames are on average.
LimbTracks unrolled(const LimbTracks& tracks);

}  // namespace wavecurve::gait
