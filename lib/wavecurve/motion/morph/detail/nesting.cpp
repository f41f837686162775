#include "wavecurve/motion/morph/detail/nesting.hpp"

#include <algorithm>

#include "wavecurve/curves/detail/orient2d.hpp"
#include "wavecurve/curves/signed_area.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;
using Eigen::Vector2d;
using In = const Eigen::Ref<const Contour>&;

/// Where the horizontal line at y meets the polygon, in increasing x.
std::vector<double> meetings(In contour, double y) {
  std::vector<double> found;
  for (Index i = 0; i < contour.rows(); ++i) {
    const Vector2d a = contour.row(i), b = contour.row((i + 1) % contour.rows());
    if ((a.y() <= y) == (b.y() <= y)) continue;
    found.push_back(a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// The middle of the widest inner stretch, and its width; width 0 if there is none.
struct Stretch {
  Vector2d middle;
  double width = 0;
};

Stretch widest_stretch(In contour) {
  constexpr int lines = 16;
  const double top = contour.col(1).minCoeff(), bottom = contour.col(1).maxCoeff();
  Stretch widest;
  for (int line = 0; line < lines; ++line) {
    const double y = top + (line + 0.5) / lines * (bottom - top);
    const std::vector<double> x = meetings(contour, y);
    for (std::size_t i = 0; i + 1 < x.size(); ++i) {
      const Vector2d middle((x[i] + x[i + 1]) / 2, y);
      if (x[i + 1] - x[i] > widest.width && winding_number(contour, middle) != 0) {
        widest = {middle, x[i + 1] - x[i]};
      }
    }
  }
  return widest;
}

}  // namespace

bool is_filled(int winding, FillRule rule) {
  return rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
}

int winding_number(In contour, const Vector2d& point) {
  int winding = 0;
  for (Index i = 0; i < contour.rows(); ++i) {
    const Vector2d a = contour.row(i), b = contour.row(i + 1 == contour.rows() ? 0 : i + 1);
    const bool starts_above = a.y() <= point.y(), ends_above = b.y() <= point.y();
    if (starts_above == ends_above) continue;
    // The edge passes to the right of the point if the point lies on the proper side of it.
    const int side = orient2d(a, b, point);
    if (starts_above && side > 0) ++winding;
    if (ends_above && side < 0) --winding;
  }
  return winding;
}

Vector2d interior_point(In contour) {
  const Vector2d mean = contour.colwise().mean();
  if (winding_number(contour, mean) != 0) return mean;
  const Stretch widest = widest_stretch(contour);
  if (widest.width > 0) return widest.middle;
  Index nearest = 0;
  (contour.rowwise() - mean.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
  return contour.row(nearest);
}

}  // namespace wavecurve::motion
