#pragma once

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"

namespace wavecurve {

/// What is taken out of a pair of contours, besides their places, before their points are compared.
enum class Rotation {
  kept,       ///< a turned shape counts as different
  taken_out,  ///< a turned shape counts as the same
};

/// The shift s, 0 .. N - 1, for which point i of one contour corresponds best to point (i + s)
/// mod N of the other: with points as complex numbers z, w about their means, the least
///   sum_i |z_i - c w_{i+s}|^2,
/// where c > 0 takes out the scale, or c = r e^{i angle} the rotation too. The best c for a shift
/// follows from the circular correlation C_s = sum_i conj(z_i) w_{i+s}, and the best shift is that
/// of the largest Re C_s, or |C_s|; a factor of scale does not change it. Where several are equal
/// but for rounding (symmetric shapes) it is the smallest. O(N log N) by FFT.
/// Throws std::invalid_argument unless both have the same number of points, at least one.
Eigen::Index best_shift(const Eigen::Ref<const Contour>& from, const Eigen::Ref<const Contour>& to,
                        Rotation rotation = Rotation::kept);

/// The same curve with point `shift` as its first.
Contour started_at(const Eigen::Ref<const Contour>& contour, Eigen::Index shift);

}  // namespace wavecurve

namespace wavecurve::plain {

/// The same by trying every shift. O(N^2).
Eigen::Index best_shift(const Eigen::Ref<const Contour>& from, const Eigen::Ref<const Contour>& to,
                        Rotation rotation = Rotation::kept);

}  // namespace wavecurve::plain
