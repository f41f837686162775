#pragma once

#include <vector>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve::gait {

/// Outlines of one limb over time that were traced frame by frame, brought into correspondence:
/// `samples` points each, uniform in arc length and clockwise as seen; each outline starts where it
/// corresponds best to the one before, turned as it may be (best_shift), found among starts that
/// are a quarter of a sample apart.
///
/// Throws std::invalid_argument as sample_contour does.
std::vector<Contour> track_outlines(const std::vector<Contour>& traced, Eigen::Index samples);

/// Whether the points of outlines correspond already, so that tracking them anew could only blur
/// them: their number is the same power of two at all times, at least fewest_samples, and the start
/// that corresponds best lies within 1/32 of the outline at every step. What a limb's bending moves
/// it by is less, a start that was chosen anew in each frame jumps farther sooner or later.
bool correspond(const std::vector<Contour>& outlines);

}  // namespace wavecurve::gait
