#include "wavecurve/motion/detail/oklab.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "wavecurve/elementary/root.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// Linear sRGB to cone responses, and their cube roots to L, a, b (Ottosson 2020).
const Matrix3d cones{{0.4122214708, 0.5363325363, 0.0514459929},
                     {0.2119034982, 0.6806995451, 0.1073969566},
                     {0.0883024619, 0.2817188376, 0.6299787005}};
const Matrix3d opponents{{0.2104542553, 0.7936177850, -0.0040720468},
                         {1.9779984951, -2.4285922050, 0.4505937099},
                         {0.0259040371, 0.7827717662, -0.8086757660}};

double to_linear(double value) {
  if (value <= 0.04045) return value / 12.92;
  const double base = (value + 0.055) / 1.055;
  return root(whole_power(base, 12), 5);  // base^2.4
}

double from_linear(double value) {
  return value <= 0.0031308 ? 12.92 * value : 1.055 * root(whole_power(value, 5), 12) - 0.055;
}

Vector3d components(const Colour& colour) { return {colour.red, colour.green, colour.blue}; }

Colour mix(const Colour& from, const Colour& to, double share) {
  return {std::lerp(from.red, to.red, share), std::lerp(from.green, to.green, share),
          std::lerp(from.blue, to.blue, share)};
}

/// The point of the line in OKLab, its ends exact.
Colour line_at(const Colour& from, const Colour& to, double share) {
  if (share == 0 || share == 1) return share == 0 ? from : to;
  return from_oklab((1 - share) * to_oklab(from) + share * to_oklab(to));
}

/// The largest distance, in a component, of the line from its chord between two shares, at fifteen
/// places in between. The line has kinks only where a component leaves sRGB or the transfer
/// function changes its branch, so that it cannot be much farther off between the places.
double deviation(const Colour& from, const Colour& to, const ColourStop& left,
                 const ColourStop& right) {
  constexpr int places = 16;
  double largest = 0;
  for (int i = 1; i < places; ++i) {
    const double inner = static_cast<double>(i) / places;
    const Colour exact = line_at(from, to, std::lerp(left.share, right.share, inner));
    const Colour chord = mix(left.colour, right.colour, inner);
    largest = std::max(largest, (components(exact) - components(chord)).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// Stops from `left`, exclusive, to `right`, inclusive: halved until the chords are near enough.
void append_stops(const Colour& from, const Colour& to, const ColourStop& left,
                  const ColourStop& right, std::vector<ColourStop>& stops) {
  // Half of the 1/512 promised, for what may lie between the places looked at.
  constexpr double tolerance = 1.0 / 1024;
  if (deviation(from, to, left, right) <= tolerance) return stops.push_back(right);
  const double middle = (left.share + right.share) / 2;
  const ColourStop stop{middle, line_at(from, to, middle)};
  append_stops(from, to, left, stop, stops);
  append_stops(from, to, stop, right, stops);
}

}  // namespace

Vector3d to_oklab(const Colour& colour) {
  const Vector3d linear = components(colour).unaryExpr(&to_linear);
  const Vector3d responses = cones * linear;
  return opponents * responses.unaryExpr([](double value) { return root(value, 3); });
}

Colour from_oklab(const Vector3d& lab) {
  static const Matrix3d to_responses = opponents.inverse(), to_rgb = cones.inverse();
  const Vector3d roots = to_responses * lab;
  const Vector3d linear = to_rgb * roots.array().cube().matrix();
  const Vector3d rgb = linear.unaryExpr(&from_linear).cwiseMax(0).cwiseMin(1);
  return {rgb.x(), rgb.y(), rgb.z()};
}

std::vector<ColourStop> colour_line(const Colour& from, const Colour& to) {
  std::vector<ColourStop> stops{{0, from}};
  append_stops(from, to, stops.front(), {1, to}, stops);
  return stops;
}

}  // namespace wavecurve::motion
