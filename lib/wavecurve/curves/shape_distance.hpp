#pragma once

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// How far two curves are from each other as shapes.
struct ShapeDistance {
  /// sqrt(mean |z(t) - e^(i angle) w(t + shift)|^2), for the angle and the shift that make it least,
  /// where z and w are the curves about their means with mean squared distance 1 from them: 0 for equal shapes,
  /// at most sqrt 2.
  double total = 0;
  /// The shares of the bands of a wavelet transform of that difference, the coarsest scale first, then the
  /// details that lead to each finer one, as multiscale_bands has them. Their squares add up to that of
  /// the whole. They are means over all points at which the transform may start.
  Eigen::VectorXd by_scale;
  double shift = 0, angle = 0;  ///< in radians; 2 pi is once around
};

/// Place, size, rotation, start and direction of the curves do not count; that one is the mirror image
/// of the other does. The distance is the same in both directions. Points should be uniform in arc
/// length; of open curves, which run there and back (sample_contour), the start is either end. Shifts between
/// the points are tried by the Fourier series through them. O(N log N).
/// Throws std::invalid_argument unless both have as many points, a power of two from 4 on, not all one; the
/// filter is orthonormal, for else no sum of squares is kept; and multiscale_bands knows the levels.
ShapeDistance shape_distance(const Contour& from, const Contour& to, const FilterBank<double>& bank,
                             int levels, bool closed = true);

/// The yardstick: the distance of elliptic Fourier descriptors (Kuhl and Giardina 1982), the root of
/// the sum of |Z_k - W_k|^2 over the frequencies 1 .. harmonics of either sign. Start and rotation are those of the
/// first ellipses, the size is the sum of their half axes; of the two ends of the major axis the nearer
/// one counts. Throws std::invalid_argument unless both have as many points, more than twice the harmonics,
/// not all one.
double elliptic_fourier_distance(const Contour& from, const Contour& to, int harmonics = 20);

}  // namespace wavecurve
