#pragma once

#include "wavecurve/transform/interleave.hpp"
#include "wavecurve/transform/rotation_cascade.hpp"

/// One level of the transform by a cascade of rotations, vectorised for the processor at hand.
/// Every operation is a rounded addition or multiplication, fixed in order by the formula alone,
/// never fused: all processors give the same bits.
namespace wavecurve {

/// As FilterPair::analyse.
template <class Scalar>
void rotate_forward(const RotationCascade<Scalar>& cascade, const Scalar* fine, Eigen::Index half,
                    Scalar* c, Scalar* d, Layout layout = Layout::single);

/// As FilterPair::synthesise.
template <class Scalar>
void rotate_backward(const RotationCascade<Scalar>& cascade, const Scalar* c, const Scalar* d,
                     Eigen::Index half, Scalar* fine, Layout layout = Layout::single);

}  // namespace wavecurve
