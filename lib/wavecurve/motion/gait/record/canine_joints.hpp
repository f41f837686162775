#pragma once

#include <array>

#include <Eigen/Core>

#include "wavecurve/motion/gait/record/canine_gaits.hpp"
#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::gait {

/// Lengths of a limb, from the body down.
struct CanineLimb {
  Eigen::RowVector2d pivot;        ///< the dorsal end of the scapula, or the hip
  std::array<double, 3> segments;  ///< scapula, upper arm, forearm; or thigh, shank, midfoot
  double metacarpus = 0;           ///< of the forelimb
  double digits = 0;
};

/// A dog that faces to larger x; y points down.
struct CanineBuild {
  CanineLimb fore, hind;
  double ground = 0;     ///< y of the digits of a foot that stands
  double reach = 0;      ///< x of the toe less that of the pivot in the middle of the stance
  double sweep = 0;      ///< what a foot moves backwards in a stance, of the largest duty factor
  double clearance = 0;  ///< to which a foot is lifted
};

/// The dog of docs/examples/dog.svg: its limbs hang where those of the drawing do. Pivots are
/// level, for the scapula, not the shoulder, is the counterpart of the thigh; the upper arm takes
/// 27 % of the forelimb in dogs of all breeds, and the scapula 24 to 34 %: M. S. Fischer, K. E.
/// Lilje, Dogs in Motion (2011). Other lengths are those of the drawing; the sweep is for its walk.
CanineBuild drawn_dog();

/// The joints of the four limbs of a dog that moves in place, at phases of the gait cycle (1 is one
/// cycle on; LF touches down at 0), which are the times: a track of chains of joints, from the
/// pivot to the toe, as skin_joints takes them.
///
/// A foot stands for its duty factor, from its touch-down on. It then moves backwards with the
/// ground, at constant speed, its digits flat. It swings forwards on a quintic in time that takes
/// over its speed at both ends, without acceleration there: slow, fast, slow. The limb follows its
/// foot like a pantograph, the first segment parallel to the third: M. S. Fischer, R. Blickhan, The
/// tri-segmented limbs of therian mammals, J. Exp. Zool. 305A (2006) 935-952. In the swing the
/// digits hang, more so early.
///
/// Throws std::domain_error naming the distance and the length where a foot is out of reach.
LimbTracks canine_joints(const CanineBuild& build, const CanineGait& gait,
                         const Eigen::Ref<const Eigen::VectorXd>& phases);

/// The distance by which a dog gets on in a cycle: what a foot sweeps, over the largest duty
/// factor.
double stride_length(const CanineBuild& build, const CanineGait& gait);

}  // namespace wavecurve::gait
