#include "wavecurve/curves/hausdorff_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace wavecurve {

namespace {

using Eigen::Index;
using Point = Eigen::RowVector2d;

/// The square of the distance of a point from the side that follows a row.
double squared_distance(const Point& point, const Contour& contour, Index row) {
  const Point start = contour.row(row);
  const Point side = contour.row(row + 1 < contour.rows() ? row + 1 : 0) - start;
  const Point from = point - start;
  const double length = side.squaredNorm();
  const double share = length > 0 ? std::clamp(from.dot(side) / length, 0.0, 1.0) : 0;
  return (from - share * side).squaredNorm();
}

/// The square of the distance from the contour, or any value below `enough` if it is below. The
/// search goes both ways from the side that corresponds.
double nearest(const Point& point, const Contour& contour, Index start, double enough) {
  const Index count = contour.rows();
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < count && least > enough; ++i) {
    const Index offset = i % 2 == 0 ? i / 2 : count - (i + 1) / 2;
    least = std::min(least, squared_distance(point, contour, (start + offset) % count));
  }
  return least;
}

double one_way(const Contour& from, const Contour& to, double largest) {
  for (Index i = 0; i < from.rows(); ++i) {
    const Index start = i * to.rows() / from.rows();
    largest = std::max(largest, nearest(from.row(i), to, start, largest));
  }
  return largest;
}

}  // namespace

double hausdorff_distance(const Contour& a, const Contour& b) {
  return std::sqrt(one_way(b, a, one_way(a, b, 0)));
}

double plain::hausdorff_distance(const Contour& a, const Contour& b) {
  double largest = 0;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (Index i = 0; i < from->rows(); ++i) {
      double least = std::numeric_limits<double>::infinity();
      for (Index k = 0; k < to->rows(); ++k) {
        least = std::min(least, squared_distance(from->row(i), *to, k));
      }
      largest = std::max(largest, least);
    }
  }
  return std::sqrt(largest);
}

}  // namespace wavecurve
