#include "wavecurve/io/drawings/detail/svg/region.hpp"

#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

namespace wavecurve::io {

namespace {

/// The whole numbers that stand for coordinates: multiples of a power of two, so that short decimals stay what they
/// are.
class Grid {
 public:
  explicit Grid(std::initializer_list<const std::vector<Contour>*> all) {
    double largest = 0;
    for (const auto* polygons : all) {
      for (const Contour& polygon : *polygons) {
        if (polygon.size() > 0) largest = std::max(largest, polygon.cwiseAbs().maxCoeff());
      }
    }
    constexpr int bits = 45;
    scale_ = std::ldexp(1.0, bits - (largest > 0 ? std::ilogb(largest) : 0));
  }

  ClipperLib::Paths whole(const std::vector<Contour>& polygons) const {
    ClipperLib::Paths paths;
    for (const Contour& polygon : polygons) {
      ClipperLib::Path& path = paths.emplace_back();
      for (const auto& point : polygon.rowwise()) {
        path.emplace_back(std::llround(scale_ * point.x()), std::llround(scale_ * point.y()));
      }
    }
    return paths;
  }

  Region region(const ClipperLib::Paths& paths) const {
    Region region;
    for (const ClipperLib::Path& path : paths) {
      Contour& polygon = region.polygons.emplace_back(static_cast<Eigen::Index>(path.size()), 2);
      for (Eigen::Index i = 0; i < polygon.rows(); ++i) {
        const ClipperLib::IntPoint& point = path[static_cast<std::size_t>(i)];
        polygon.row(i) << static_cast<double>(point.X) / scale_,
            static_cast<double>(point.Y) / scale_;
      }
    }
    return region;
  }

 private:
  double scale_;
};

Region combined(const Region& a, const Region& b, ClipperLib::ClipType operation) {
  const Grid grid{&a.polygons, &b.polygons};
  ClipperLib::Clipper clipper;
  clipper.AddPaths(grid.whole(a.polygons), ClipperLib::ptSubject, true);
  clipper.AddPaths(grid.whole(b.polygons), ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  clipper.Execute(operation, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return grid.region(result);
}

/// In how many straight pieces a segment stays within the tolerance: a chord of the n-th part of the parameter is off
/// by |B''| / (8 n^2) at most, and B'' is degree (degree - 1) times second differences of the control points, or
/// between them.
Eigen::Index pieces_of(const BezierSegment& segment, double tolerance) {
  constexpr double most = most_pieces;
  double bend = 0;
  for (Eigen::Index i = 2; i < segment.control.cols(); ++i) {
    bend = std::max(
        bend, (segment.control.col(i) - 2 * segment.control.col(i - 1) + segment.control.col(i - 2))
                  .norm());
  }
  const double n = segment.degree();
  return static_cast<Eigen::Index>(
      std::clamp(std::ceil(std::sqrt(n * (n - 1) * bend / (8 * tolerance))), 1.0, most));
}

/// By de Casteljau's rule.
Eigen::RowVector2d point_at(const BezierSegment& segment, double s) {
  auto points = segment.control;
  for (Eigen::Index n = points.cols() - 1; n > 0; --n) {
    for (Eigen::Index i = 0; i < n; ++i) {
      points.col(i) = (1 - s) * points.col(i) + s * points.col(i + 1);
    }
  }
  return points.col(0).transpose();
}

Contour polygon_of(const Subpath& subpath, double tolerance) {
  std::vector<Eigen::RowVector2d> points;
  for (const BezierSegment& segment : subpath.segments) {
    const Eigen::Index pieces = pieces_of(segment, tolerance);
    for (Eigen::Index i = 0; i < pieces; ++i) {
      points.push_back(point_at(segment, static_cast<double>(i) / static_cast<double>(pieces)));
    }
  }
  if (!subpath.closed && !subpath.segments.empty()) {
    points.emplace_back(subpath.segments.back().control.rightCols<1>().transpose());
  }
  Contour polygon(static_cast<Eigen::Index>(points.size()), 2);
  for (Eigen::Index i = 0; i < polygon.rows(); ++i) {
    polygon.row(i) = points[static_cast<std::size_t>(i)];
  }
  return polygon;
}

}  // namespace

double Region::area() const {
  double doubled = 0;
  for (const Contour& polygon : polygons) {
    for (Eigen::Index i = 0, n = polygon.rows(); i < n; ++i) {
      const Eigen::Index next = i + 1 == n ? 0 : i + 1;
      doubled += polygon(i, 0) * polygon(next, 1) - polygon(i, 1) * polygon(next, 0);
    }
  }
  return std::abs(doubled) / 2;
}

Region region_of(const std::vector<Contour>& polygons, FillRule rule) {
  const Grid grid{&polygons};
  ClipperLib::Paths paths = grid.whole(polygons);
  ClipperLib::SimplifyPolygons(
      paths, rule == FillRule::evenodd ? ClipperLib::pftEvenOdd : ClipperLib::pftNonZero);
  return grid.region(paths);
}

Region united(const Region& a, const Region& b) { return combined(a, b, ClipperLib::ctUnion); }

Region intersected(const Region& a, const Region& b) {
  return combined(a, b, ClipperLib::ctIntersection);
}

std::vector<Contour> polygons_of(const std::vector<Subpath>& subpaths, double tolerance) {
  std::vector<Contour> polygons;
  for (const Subpath& subpath : subpaths) polygons.push_back(polygon_of(subpath, tolerance));
  return polygons;
}

std::vector<Subpath> outline_of(const Region& region) {
  std::vector<Subpath> subpaths;
  for (const Contour& polygon : region.polygons) {
    Subpath& subpath = subpaths.emplace_back();
    subpath.closed = true;
    for (Eigen::Index i = 0, n = polygon.rows(); i < n; ++i) {
      BezierSegment& line = subpath.segments.emplace_back();
      line.control.resize(2, 2);
      line.control << polygon.row(i).transpose(), polygon.row(i + 1 == n ? 0 : i + 1).transpose();
    }
  }
  return subpaths;
}

std::size_t most_crossings(const std::vector<Contour>& polygons) {
  std::size_t edges = 0, runs = 0;
  for (const Contour& polygon : polygons) {
    double before = 0;
    for (Eigen::Index i = 0, n = polygon.rows(); i < n; ++i) {
      const double rise = polygon(i + 1 == n ? 0 : i + 1, 1) - polygon(i, 1);
      if (rise == 0) continue;
      if (!(before * rise > 0)) ++runs;
      before = rise;
    }
    edges += static_cast<std::size_t>(polygon.rows());
  }
  return edges * runs;
}

}  // namespace wavecurve::io
