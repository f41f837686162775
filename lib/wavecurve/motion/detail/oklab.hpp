#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::motion {

/// Lightness L, green-red a and blue-yellow b of the perceptual space OKLab, in which equal
/// distances look about equally large. Matrices: B. Ottosson, A perceptual color space for image
/// processing, 2020; the transfer function of sRGB: IEC 61966-2-1.
Eigen::Vector3d to_oklab(const Colour& colour);

/// The inverse; a colour that sRGB does not have is clamped, component by component.
Colour from_oklab(const Eigen::Vector3d& lab);

struct ColourStop {
  double share = 0;  ///< of the way, 0 .. 1
  Colour colour;
};

/// The straight line in OKLab from one colour to another, as stops between which sRGB components
/// are linear: off by less than 1/512 in each, half a step of eight bits. The ends are exact.
std::vector<ColourStop> colour_line(const Colour& from, const Colour& to);

}  // namespace wavecurve::motion
