#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace wavecurve::gait {

/// When a limb stands, as shares of the cycle.
struct LimbTiming {
  double touch_down = 0;  ///< after that of the left forelimb, 0 <= touch_down < 1
  double duty_factor =
      0;  ///< the share of the cycle for which the foot is on the ground, in (0, 1)
};

/// The limbs of a quadruped, in the order of all arrays of four. L, R: left, right; F, H: fore,
/// hind.
inline constexpr std::array<std::string_view, 4> limb_names{"LF", "RF", "LH", "RH"};

struct CanineGait {
  std::string name;
  std::array<LimbTiming, 4> limbs;  ///< LF, RF, LH, RH
};

/// walk, trot, pace and gallop, as published, rounded to a share of a hundredth:
///
/// - All gaits but the gallop are symmetrical: right limbs do what left limbs do, half a cycle
///   later. Duty factors above 0.5 are walks, below are runs; the second figure that tells gaits
///   apart is the share of the cycle by which a fore foot follows the hind foot of its side: 0 is a
///   pace, 0.5 a trot. M. Hildebrand, "Symmetrical gaits of horses", Science 150 (1965) 701-708.
/// - A dog walks in lateral sequence, LH LF RH RF; a hind foot comes down less than a quarter of a
///   cycle before the fore foot of its side. Diagonal limbs are 0.31 +- 0.02 of a cycle apart, in
///   the trot 0.02 +- 0.03: "Gait transitions during unrestrained locomotion in dogs", on 22
///   mongrel dogs. So LF to RH is 0.31, LH to LF 0.19. Two or three feet stand at a time, most of
///   the time three, which asks for a duty factor of about 5/8: 0.62.
/// - In the trot diagonal limbs, in the pace those of a side come down together, with moments of no
///   foot on the ground: duty factors below 0.5, here 0.45. M. Hildebrand, "Symmetrical gaits of
///   dogs in relation to body build", J. Morphology 124 (1968) 353-360.
/// - The gallop of dogs is rotary, LH RH RF LF: the fore feet come down in the order opposite to
/// the
///   hind ones. L. D. Maes et al., "Steady locomotion in dogs", J. Exp. Biol. 211 (2008) 138-149.
///   Lags within a pair are between 0.1 and 0.2 of a cycle, and a foot stands a quarter of it: one
///   phase without ground contact, all feet gathered under the body, after LF has left the ground.
///   M. Hildebrand, "Analysis of asymmetrical gaits", J. Mammalogy 58 (1977) 131-156.
const std::vector<CanineGait>& canine_gaits();

/// The one of that name. Throws std::invalid_argument naming the four for any other.
const CanineGait& find_canine_gait(std::string_view name);

}  // namespace wavecurve::gait
