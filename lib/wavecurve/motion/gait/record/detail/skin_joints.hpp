#pragma once

#include <vector>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve::gait {

/// Outlines of a limb that is known by its joints only: the boundary of a chain of capsules, the
/// points at distance `radius` of the bones between neighbouring joints.
///
/// Joints are rows, one matrix a time, from the body to the toe. The outline starts at the tip
/// beyond the first joint and is clockwise as seen. Each bone has a line on either side, and half
/// of the arcs about its joints, to the bisectors there. Points are uniform within these pieces,
/// each of which has the same points at all times, in proportion to its mean extent over time. So
/// point k is the same point of the limb always, and moves continuously: outside of a bend it keeps
/// its place on the bone; inside, where lines are shorter, points gather towards the bone's middle,
/// and those of an arc wait in its corner.
///
/// Bones that are points at all times are left out; one that is so at some time has the direction
/// of the one before it. Where a bend is sharper than the bones are long (radius * tan(angle / 2) >
/// half of one), its inner corner stays at the middle of the bone and nearer to it than the radius.
///
/// Throws std::invalid_argument unless there are at least two joints, as many at all times, finite,
/// not all one point, samples is as check_samples has it, and the radius is positive and finite.
std::vector<Contour> skin_joints(const std::vector<Contour>& joints, double radius,
                                 Eigen::Index samples);

/// The mean over time of the length of the chain.
double chain_length(const std::vector<Contour>& joints);

}  // namespace wavecurve::gait
