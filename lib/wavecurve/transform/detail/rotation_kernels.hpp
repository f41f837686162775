#pragma once

#include "wavecurve/transform/detail/interleave.hpp"
#include "wavecurve/transform/detail/rotation_cascade.hpp"

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

/// Levels that the fused kernels take at once, so that a signal that no cache holds passes through
/// memory once for all of them; and the values of a ring between two of them.
constexpr int fused_levels = 3;
constexpr Eigen::Index ring_size = 4096;
/// Below, caches hold the signal, and the starts of the blocks cost more than they save.
constexpr Eigen::Index fused_from = 1 << 21;

/// The same bits as fused_levels levels, of one signal of a multiple of ring_size 2^fused_levels
/// samples: the last c, and d of level j to (or from) bands + samples / 2^j. Nothing overlaps; the
/// rings hold (fused_levels - 1) ring_size values.
template <class Scalar>
void rotate_forward_fused(const RotationCascade<Scalar>& cascade, const Scalar* fine,
                          Eigen::Index samples, Scalar* c, Scalar* bands, Scalar* rings);
template <class Scalar>
void rotate_backward_fused(const RotationCascade<Scalar>& cascade, const Scalar* c,
                           const Scalar* bands, Eigen::Index samples, Scalar* fine, Scalar* rings);

}  // namespace wavecurve
