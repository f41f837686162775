#include "wavecurve/io/drawings/detail/svg/arc.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"

namespace wavecurve::io {

namespace {

constexpr double largest_step = std::numbers::pi / 24;

double angle_of(const Eigen::Vector2d& point) { return arctangent(point.y(), point.x()); }

}  // namespace

Eigen::Vector2d Ellipse::at(double angle) const {
  const Eigen::Vector2d unit(cosine(angle), sine(angle));
  return centre + Eigen::Rotation2Dd(rotation) * radii.cwiseProduct(unit);
}

void append_arc(PathBuilder& path, const Ellipse& ellipse, double from, double sweep) {
  // A full circle is not to become one piece more by rounding.
  const int pieces =
      std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / largest_step - 1e-9)));
  const double step = sweep / pieces, reach = 4.0 / 3 * wavecurve::tangent(step / 4);
  const auto tangent = [&](double angle) -> Eigen::Vector2d {
    return ellipse.at(angle + std::numbers::pi / 2) - ellipse.centre;
  };
  for (int i = 0; i < pieces; ++i) {
    const double begin = from + sweep * i / pieces, end = from + sweep * (i + 1) / pieces;
    path.cubic_to(ellipse.at(begin) + reach * tangent(begin),
                  ellipse.at(end) - reach * tangent(end), ellipse.at(end));
  }
}

void append_endpoint_arc(PathBuilder& path, const Eigen::Vector2d& radii, double rotation,
                         bool large, bool clockwise, const Eigen::Vector2d& to) {
  const Eigen::Vector2d from = path.current();
  if (from == to) return;
  if (radii.x() == 0 || radii.y() == 0) return path.line_to(to);
  Ellipse ellipse{(from + to) / 2, radii.cwiseAbs(), rotation * std::numbers::pi / 180};
  const Eigen::Rotation2Dd back(-ellipse.rotation);

  // Where the ellipse is the unit circle, its centre at the origin, the ends are half and -half
  // but for a shift across the chord.
  Eigen::Vector2d half = (back * (from - to) / 2).cwiseQuotient(ellipse.radii);
  const double length = half.norm();
  // Ends that are a diameter apart up to rounding, whose root would be much larger, are just that.
  if (length > 1 - 1e-14) {
    ellipse.radii *= length;
    half /= length;
  }
  // So flat an arc differs from its chord by less than the rounding of its centre.
  if (!large && half.norm() < 1e-8) return path.line_to(to);
  const double cosine = std::min(1.0, half.norm());
  const double across = length > 1 - 1e-14 ? 0 : std::sqrt((1 - cosine) * (1 + cosine)) / cosine;
  const Eigen::Vector2d shift =
      (large == clockwise ? -across : across) * Eigen::Vector2d(half.y(), -half.x());
  ellipse.centre += back.inverse() * ellipse.radii.cwiseProduct(shift);

  const double begin = angle_of(half - shift);
  double sweep = angle_of(-half - shift) - begin;
  if (clockwise && sweep < 0) sweep += 2 * std::numbers::pi;
  if (!clockwise && sweep > 0) sweep -= 2 * std::numbers::pi;
  if (!ellipse.centre.allFinite() || !std::isfinite(sweep)) {
    throw std::invalid_argument(
        fmt::format("an arc of radii {:g} and {:g} to ({:g}, {:g}) has no centre", radii.x(),
                    radii.y(), to.x(), to.y()));
  }
  append_arc(path, ellipse, begin, sweep);
  path.move_end(to);
}

}  // namespace wavecurve::io
