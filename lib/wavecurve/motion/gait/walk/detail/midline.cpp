#include "wavecurve/motion/gait/walk/detail/midline.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// From each point to the next.
VectorXd edge_lengths(const Contour& outline) {
  const Index size = outline.rows();
  VectorXd lengths(size);
  for (Index i = 0; i < size; ++i) {
    lengths[i] = (outline.row((i + 1) % size) - outline.row(i)).norm();
  }
  return lengths;
}

/// The point whose way from the foot is nearest to half the length.
Index opposite(const VectorXd& lengths, Index foot) {
  const double half = lengths.sum() / 2;
  const Index size = lengths.size();
  double way = 0;
  Index point = foot;
  while (true) {
    const double step = lengths[point];
    if (way + step / 2 >= half || (point + 2) % size == foot) break;
    way += step;
    point = (point + 1) % size;
  }
  return point == foot ? (foot + 1) % size : point;
}

}  // namespace

Midline::Midline(const Contour& rest, Index foot, int nodes) : hinge_(0), foot_(foot) {
  const Index size = rest.rows();
  const VectorXd lengths = edge_lengths(rest);
  if (nodes < 2 || size < 4 || foot < 0 || foot >= size || !(lengths.sum() > 0)) {
    throw std::invalid_argument(
        fmt::format("a midline of {} nodes, from an outline of {} points and length {} with its "
                    "foot at point {}",
                    nodes, size, lengths.sum(), foot));
  }
  hinge_ = opposite(lengths, foot);
  shares_.resize(size);
  sides_.resize(static_cast<std::size_t>(nodes));
  for (int side : {0, 1}) {
    // Along the outline, then against it.
    const Index step = side == 0 ? 1 : size - 1;
    const auto edge = [&](Index i) { return lengths[side == 0 ? i : (i + size - 1) % size]; };
    double whole = 0;
    for (Index i = hinge_; i != foot_; i = (i + step) % size) whole += edge(i);
    if (!(whole > 0)) whole = 1;
    double way = 0;
    std::size_t node = 0;
    for (Index i = hinge_; i != foot_; i = (i + step) % size) {
      shares_[i] = way / whole;
      const double after = way + edge(i);
      const Index next = (i + step) % size;
      for (; node < sides_.size(); ++node) {
        const double at = whole * static_cast<double>(node) / (nodes - 1);
        if (at > after && next != foot_) break;
        const double weight = edge(i) > 0 ? std::min(1.0, (at - way) / edge(i)) : 0;
        sides_[node][static_cast<std::size_t>(side)] = {i, next, weight};
      }
      way = after;
    }
  }
  shares_[foot_] = 1;
}

Contour Midline::nodes(const Contour& outline) const {
  Contour result(static_cast<Index>(sides_.size()), 2);
  for (Index i = 0; i < result.rows(); ++i) {
    result.row(i).setZero();
    for (const Between& b : sides_[static_cast<std::size_t>(i)]) {
      result.row(i) += ((1 - b.weight) * outline.row(b.point) + b.weight * outline.row(b.next)) / 2;
    }
  }
  return result;
}

}  // namespace wavecurve::gait
