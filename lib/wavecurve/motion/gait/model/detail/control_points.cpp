#include "wavecurve/motion/gait/model/detail/control_points.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::gait {

using Eigen::Index;

namespace {

int levels_between(Index samples, Index scale) {
  const auto is_power = [](Index n) {
    return n >= 4 && std::has_single_bit(static_cast<std::uint64_t>(n));
  };
  if (!is_power(samples)) {
    throw std::invalid_argument(
        fmt::format("an outline has {} points, but must have a power of two, at least 4", samples));
  }
  if (!is_power(scale) || scale > samples) {
    throw std::invalid_argument(
        fmt::format("the scale is {}, but must be a power of two from 4 to {}", scale, samples));
  }
  return std::countr_zero(static_cast<std::uint64_t>(samples / scale));
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
