#pragma once

#include "wavecurve/curves/contour.hpp"

namespace wavecurve::verification {

/// The yardstick: the contour as z = x + i y, of whose discrete Fourier transform the `size`
/// frequencies -size / 2 .. (size - 1) / 2 are kept, as many numbers as `size` points have.
Contour fourier_approximation(const Contour& samples, Eigen::Index size);

}  // namespace wavecurve::verification
