#include "wavecurve/motion/gait/model/detail/control_points.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/filters/detail/whole_numbers.hpp"

namespace wavecurve::gait {

using Eigen::Index;

namespace {

int levels_between(Index samples, Index scale) {
  if (!is_power_of_two(samples) || samples < 4) {
    throw std::invalid_argument(
        must_be("the number of points of an outline", samples, "a power of two, at least 4"));
  }
  if (!is_power_of_two(scale) || scale < 4 || scale > samples) {
    throw std::invalid_argument(
        must_be("scale", scale, fmt::format("a power of two from 4 to {}", samples)));
  }
  return all_levels(samples / scale);
}

}  // namespace

ControlPoints::ControlPoints(const FilterBank<double>& bank, Index samples, Index scale)
    : transform_(bank, samples, levels_between(samples, scale)),
      scale_(scale),
      factor_(std::sqrt(static_cast<double>(samples) / static_cast<double>(scale))) {}

Contour ControlPoints::analyse(const Contour& points) const {
  if (scale_ == transform_.samples()) return points;
  Contour coefficients(points.rows(), 2);
  Eigen::VectorXd workspace(transform_.workspace_size(2));
  transform_.forward(points, coefficients, workspace);
  return coefficients.topRows(scale_) / factor_;
}

Contour ControlPoints::draw(const Contour& control_points) const {
  if (scale_ == transform_.samples()) return control_points;
  Contour coefficients = Contour::Zero(transform_.samples(), 2);
  coefficients.topRows(scale_) = factor_ * control_points;
  Eigen::VectorXd workspace(transform_.workspace_size(2));
  transform_.inverse(coefficients, coefficients, workspace);
  return coefficients;
}

}  // namespace wavecurve::gait
