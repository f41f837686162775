#pragma once

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::gait {

/// The control points of a contour at a coarser scale, and the contour that they draw: the K
/// scaling coefficients a_n, c_n of (2.10)-(2.12), in units of the drawing (each level of (2.8)
/// multiplies by sqrt 2, which is taken out). At the finest scale, the points themselves.
class ControlPoints {
 public:
  /// Throws std::invalid_argument unless samples and scale are powers of two, 4 <= scale <=
  /// samples.
  ControlPoints(const FilterBank<double>& bank, Eigen::Index samples, Eigen::Index scale);

  Eigen::Index samples() const { return transform_.samples(); }
  Eigen::Index scale() const { return scale_; }

  Contour analyse(const Contour& points) const;
  /// Without details.
  Contour draw(const Contour& control_points) const;

 private:
  PeriodicTransform<double> transform_;
  Eigen::Index scale_;
  double factor_;
};

}  // namespace wavecurve::gait
