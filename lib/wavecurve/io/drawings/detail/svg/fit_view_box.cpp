#include "wavecurve/io/drawings/detail/svg/fit_view_box.hpp"

#include <algorithm>

#include <Eigen/Geometry>

namespace wavecurve::io {

namespace {

Eigen::AlignedBox2d box_around(const Layer& layer) {
  Eigen::AlignedBox2d box;
  for (const Subpath& subpath : layer.subpaths) {
    for (const BezierSegment& segment : subpath.segments) {
      for (Eigen::Index i = 0; i < segment.control.cols(); ++i) box.extend(segment.control.col(i));
    }
  }
  const double margin = layer.paint.stroke ? layer.paint.stroke_width / 2 : 0;
  const Eigen::Vector2d corner = Eigen::Vector2d::Constant(margin);
  return {box.min() - corner, box.max() + corner};
}

}  // namespace

ViewBox fit_view_box(const Drawing& drawing) {
  Eigen::AlignedBox2d box;
  for (const Layer& layer : drawing.layers) box.extend(box_around(layer));
  const Eigen::Vector2d sizes = box.sizes(), centre = box.center();
  const double other = sizes.maxCoeff();
  const double width = sizes.x() > 0 ? sizes.x() : other;
  const double height = sizes.y() > 0 ? sizes.y() : other;
  return {centre.x() - width / 2, centre.y() - height / 2, width, height};
}

}  // namespace wavecurve::io
