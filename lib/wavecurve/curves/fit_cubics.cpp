#include "wavecurve/curves/fit_cubics.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;
/// One row a point (or vertex), columns x and y of each key in turn; rows are what is worked with.
using Columns = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A turn this much sharper than those beside it, in any key, is a corner.
constexpr double corner_turn = std::numbers::pi / 6;
/// Segments that no point lies inside leave tangents undetermined; this share of the weight of a
/// point draws them towards the chord, too little to show in the fit of others.
constexpr double chord_weight = 1e-6;

/// The cubic Hermite polynomials at s, as factors of the values and of the tangents (for a unit
/// interval) at its ends.
struct Hermite {
  explicit Hermite(double s)
      : value_start((1 + 2 * s) * (1 - s) * (1 - s)),
        tangent_start(s * (1 - s) * (1 - s)),
        value_end(s * s * (3 - 2 * s)),
        tangent_end(s * s * (s - 1)) {}
  double value_start, tangent_start, value_end, tangent_end;
};

/// The vertices of a fit: indices of points, increasing, and the unknowns that their tangents are.
struct Knots {
  Index points = 0;
  Closing closing = Closing::joined;
  std::vector<Index> at;
  std::vector<bool> corner;  ///< of every point

  /// A segment has the number of the vertex that it starts from.
  std::size_t segments() const { return at.size() - (closing == Closing::open ? 1 : 0); }
  std::size_t next(std::size_t i) const { return i + 1 == at.size() ? 0 : i + 1; }
  /// Points from a vertex to the next.
  Index span(std::size_t i) const {
    return at[next(i)] - at[i] + (i + 1 == at.size() ? points : 0);
  }
};

Columns columns_of(const std::vector<Contour>& keys) {
  Columns columns(keys.front().rows(), 2 * static_cast<Index>(keys.size()));
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (keys[k].rows() != columns.rows()) {
      throw std::invalid_argument("fit of cubics: key " + std::to_string(k) + " has " +
                                  std::to_string(keys[k].rows()) + " points, key 0 has " +
                                  std::to_string(columns.rows()));
    }
    columns.middleCols<2>(2 * static_cast<Index>(k)) = keys[k];
  }
  return columns;
}

/// The edges before and after a point, and the angle between them: 0 .. pi; none where one has no
/// length.
struct Turn {
  Turn(const Columns& all, Index key, Index j) {
    const Index n = all.rows();
    const auto points = all.middleCols<2>(2 * key);
    const Eigen::RowVector2d before = points.row(j) - points.row(j == 0 ? n - 1 : j - 1);
    const Eigen::RowVector2d after = points.row(j + 1 == n ? 0 : j + 1) - points.row(j);
    sine = before.x() * after.y() - before.y() * after.x();
    cosine = before.dot(after);
  }
  double angle() const { return std::abs(arctangent(sine, cosine)); }
  /// Spares most points the angle.
  bool may_be_corner(double corner_slope) const {
    return cosine <= 0 || std::abs(sine) > corner_slope * cosine;
  }
  double sine, cosine;  ///< times the lengths of the edges
};

/// The longer side of the box about a key.
double extent(const Columns& points, Index key) {
  const auto side = [&](Index i) { return points.col(i).maxCoeff() - points.col(i).minCoeff(); };
  return std::max(side(2 * key), side(2 * key + 1));
}

/// Which keys are a point but for rounding, so that directions about it mean nothing. Asked for
/// where there may be a corner, and computed only then.
class PointKeys {
 public:
  explicit PointKeys(const Columns& points) : points_(points) {}

  bool operator()(Index key) {
    if (extents_.empty()) {
      for (Index k = 0; k < points_.cols() / 2; ++k) extents_.push_back(extent(points_, k));
      largest_ = *std::ranges::max_element(extents_);
    }
    return extents_[static_cast<std::size_t>(key)] <= 1e-9 * largest_;
  }

 private:
  const Columns& points_;
  std::vector<double> extents_;
  double largest_ = 0;
};

std::vector<bool> corners(const Columns& points, Closing closing) {
  const Index n = points.rows();
  std::vector<bool> corner(static_cast<std::size_t>(n), false);
  PointKeys is_point(points);
  const double corner_slope = tangent(corner_turn);
  std::vector<double> angles(static_cast<std::size_t>(n));
  // The ends of a line are no corners: they have one tangent each.
  const Index first = closing == Closing::open ? 1 : 0, end = n - first;
  for (Index key = 0; key < points.cols() / 2; ++key) {
    std::ranges::fill(angles, -1);  // not yet known; a bend asks for those of its neighbours
    const auto angle = [&](Index j) {
      if (j < first || j >= end) return 0.0;
      double& known = angles[static_cast<std::size_t>(j)];
      if (known < 0) known = Turn(points, key, j).angle();
      return known;
    };
    for (Index j = first; j < end; ++j) {
      if (!Turn(points, key, j).may_be_corner(corner_slope)) continue;
      if (is_point(key)) break;
      const double beside = (angle((j + n - 1) % n) + angle((j + 1) % n)) / 2;
      if (angle(j) - beside > corner_turn) corner[static_cast<std::size_t>(j)] = true;
    }
  }
  return corner;
}

/// The corners and four points at equal distances, of which the refinement starts.
Knots first_knots(const Columns& points, Closing closing) {
  Knots knots{points.rows(), closing, {}, corners(points, closing)};
  for (Index j = 0; j < knots.points; ++j) {
    const bool quarter = j * 4 / knots.points != (j - 1) * 4 / knots.points || j == 0;
    if (quarter || knots.corner[static_cast<std::size_t>(j)]) knots.at.push_back(j);
  }
  if (closing == Closing::open && knots.at.back() + 1 != knots.points) {
    knots.at.push_back(knots.points - 1);
  }
  return knots;
}

/// The tangents of a vertex, per point: one unknown where it is smooth, two at a corner.
struct TangentIndex {
  explicit TangentIndex(const Knots& knots) {
    for (Index at : knots.at) {
      in.push_back(count);
      if (knots.corner[static_cast<std::size_t>(at)]) ++count;
      out.push_back(count++);
    }
  }
  std::vector<int> in, out;
  int count = 0;
};

/// The tangents of least squares: rows as in the index.
Columns tangents(const Columns& points, const Knots& knots, const TangentIndex& index) {
  std::vector<Eigen::Triplet<double>> entries;
  Columns right = Columns::Zero(index.count, points.cols());
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const int a = index.out[i], b = index.in[knots.next(i)];
    const Index span = knots.span(i);
    const double h = static_cast<double>(span);
    const auto start = points.row(knots.at[i]), end = points.row(knots.at[knots.next(i)]);
    double aa = chord_weight * h * h, ab = 0, bb = aa;
    right.row(a) += chord_weight * h * (end - start);
    right.row(b) += chord_weight * h * (end - start);
    for (Index j = 1; j < span; ++j) {
      const Hermite basis(static_cast<double>(j) / h);
      const double p = h * basis.tangent_start, q = h * basis.tangent_end;
      const Eigen::RowVectorXd rest = points.row((knots.at[i] + j) % knots.points) -
                                      basis.value_start * start - basis.value_end * end;
      aa += p * p;
      ab += p * q;
      bb += q * q;
      right.row(a) += p * rest;
      right.row(b) += q * rest;
    }
    entries.insert(entries.end(), {{a, a, aa}, {b, b, bb}, {a, b, ab}, {b, a, ab}});
  }
  Eigen::SparseMatrix<double> normal(index.count, index.count);
  normal.setFromTriplets(entries.begin(), entries.end());
  // Neighbours on the contour are neighbours in the matrix: only its last row fills in, in this order.
  using Solver =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>>;
  return Solver(normal).solve(right);
}

/// Three rows a vertex, see the header.
Columns control_points(const Columns& points, const Knots& knots) {
  const TangentIndex index(knots);
  const Columns tangent = tangents(points, knots, index);
  const auto segments = static_cast<Index>(knots.segments());
  Columns control(3 * segments + (knots.closing == Closing::open ? 1 : 0), points.cols());
  if (knots.closing == Closing::open) control.row(3 * segments) = points.row(knots.at.back());
  for (std::size_t i = 0; i < knots.segments(); ++i) {
    const double third = static_cast<double>(knots.span(i)) / 3;
    const Index row = 3 * static_cast<Index>(i), end = knots.at[knots.next(i)];
    control.row(row) = points.row(knots.at[i]);
    control.row(row + 1) = points.row(knots.at[i]) + third * tangent.row(index.out[i]);
    control.row(row + 2) = points.row(end) - third * tangent.row(index.in[knots.next(i)]);
  }
  return control;
}

/// One cubic, in all keys.
struct Cubic {
  Eigen::RowVectorXd start, after, before, end;
};

/// Whether `span` points from one on are within the tolerance of a cubic, in all keys.
bool follows(const Columns& points, Index first, Index span, const Cubic& cubic, double tolerance) {
  Eigen::RowVectorXd away(points.cols());
  for (Index j = 1; j < span; ++j) {
    const double s = static_cast<double>(j) / static_cast<double>(span), r = 1 - s;
    away = r * r * r * cubic.start + 3 * r * r * s * cubic.after + 3 * r * s * s * cubic.before +
           s * s * s * cubic.end - points.row((first + j) % points.rows());
    for (Index key = 0; key < points.cols() / 2; ++key) {
      if (!(away.segment<2>(2 * key).squaredNorm() <= tolerance * tolerance)) return false;
    }
  }
  return true;
}

/// Whether the points inside the segment after vertex i are within the tolerance of its cubic.
bool fits(const Columns& points, const Knots& knots, const Columns& control, std::size_t i,
          double tolerance) {
  const Index row = 3 * static_cast<Index>(i), last = 3 * static_cast<Index>(knots.next(i));
  const Cubic cubic{control.row(row), control.row(row + 1), control.row(row + 2),
                    control.row(last)};
  return follows(points, knots.at[i], knots.span(i), cubic, tolerance);
}

/// Whether one cubic with the tangents at its ends as they are does for those before and after vertex i.
bool fits_without(const Columns& points, const Knots& knots, const Columns& control, std::size_t i,
                  double tolerance) {
  const Index before = 3 * static_cast<Index>(i - 1), after = before + 3;
  const Index span = knots.span(i - 1) + knots.span(i),
              last = 3 * static_cast<Index>(knots.next(i));
  const auto stretch = [&](std::size_t segment) {
    return static_cast<double>(span) / static_cast<double>(knots.span(segment));
  };
  const Cubic cubic{
      control.row(before),
      control.row(before) + stretch(i - 1) * (control.row(before + 1) - control.row(before)),
      control.row(last) + stretch(i) * (control.row(after + 2) - control.row(last)),
      control.row(last)};
  return follows(points, knots.at[i - 1], span, cubic, tolerance);
}

/// The knots without those that the curve does not need: no corner, no end, no two neighbours at once,
/// and two remain.
Knots coarsened(const Columns& points, const Knots& knots, const Columns& control,
                double tolerance) {
  Knots fewer{knots.points, knots.closing, {knots.at.front()}, knots.corner};
  std::size_t remaining = knots.at.size();
  bool was_kept = true;
  for (std::size_t i = 1; i < knots.at.size(); ++i) {
    const bool goes = was_kept && remaining > 2 && i < knots.segments() &&
                      !knots.corner[static_cast<std::size_t>(knots.at[i])] &&
                      fits_without(points, knots, control, i, tolerance);
    was_kept = !goes;
    if (goes) --remaining;
    if (!goes) fewer.at.push_back(knots.at[i]);
  }
  return fewer;
}

/// The knots with every segment halved that misses the tolerance; a segment of one step fits.
Knots refined(const Columns& points, const Knots& knots, const Columns& control, double tolerance) {
  Knots finer{knots.points, knots.closing, {}, knots.corner};
  for (std::size_t i = 0; i < knots.at.size(); ++i) {
    finer.at.push_back(knots.at[i]);
    if (i == knots.segments() || fits(points, knots, control, i, tolerance)) continue;
    finer.at.push_back((knots.at[i] + knots.span(i) / 2) % knots.points);
  }
  std::sort(finer.at.begin(), finer.at.end());
  return finer;
}

struct Fit {
  Knots knots;
  Columns control;
};

/// The knots with as many more as it takes to keep the tolerance.
Fit refined_fit(const Columns& points, Knots knots, double tolerance) {
  Columns control = control_points(points, knots);
  for (std::size_t before = 0; before != knots.at.size();) {
    before = knots.at.size();
    knots = refined(points, knots, control, tolerance);
    if (knots.at.size() != before) control = control_points(points, knots);
  }
  return {std::move(knots), std::move(control)};
}

}  // namespace

std::vector<Contour> fit_cubics(const std::vector<Contour>& keys, double tolerance,
                                Closing closing) {
  if (keys.empty() || keys.front().rows() == 0) {
    throw std::invalid_argument("fit of cubics: a contour without points");
  }
  check_at_least("the tolerance of a fit of cubics", tolerance, 0);
  const Columns points = columns_of(keys);
  if (closing == Closing::open && points.rows() < 2) {
    throw std::invalid_argument("fit of cubics: an open line of one point");
  }
  Fit fit = refined_fit(points, first_knots(points, closing), tolerance);
  for (;;) {
    Fit fewer =
        refined_fit(points, coarsened(points, fit.knots, fit.control, tolerance), tolerance);
    if (fewer.knots.at.size() >= fit.knots.at.size()) break;
    fit = std::move(fewer);
  }
  std::vector<Contour> result;
  for (std::size_t k = 0; k < keys.size(); ++k) {
    result.emplace_back(fit.control.middleCols<2>(2 * static_cast<Index>(k)));
  }
  return result;
}

}  // namespace wavecurve
