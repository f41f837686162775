#pragma once

// What the tests of the readers ask of a drawing.

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "wavecurve/io/drawings/detail/svg/read_svg.hpp"

namespace wavecurve::io::test {

/// A drawing whose view box is 0 0 100 100.
inline DrawingFile read(const std::string& body) {
  return read_svg(
      "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
      "viewBox='0 0 100 100'>" +
      body + "</svg>");
}

inline Layer only_layer(const std::string& body) {
  const DrawingFile file = read(body);
  EXPECT_EQ(file.drawing.layers.size(), 1U) << body;
  return file.drawing.layers.at(0);
}

/// The path of a stroked path element, so that open subpaths stay as they are.
inline std::vector<Subpath> path_of(const std::string& data) {
  return only_layer("<path fill='none' stroke='red' d='" + data + "'/>").subpaths;
}

inline Layer layer_of(const Drawing& drawing, const std::string& id) {
  for (const Layer& layer : drawing.layers) {
    if (layer.id == id) return layer;
  }
  ADD_FAILURE() << "no layer " << id;
  return {};
}

inline std::vector<std::string> ids_of(const Drawing& drawing) {
  std::vector<std::string> ids;
  for (const Layer& layer : drawing.layers) ids.push_back(layer.id);
  return ids;
}

/// By de Casteljau's rule.
inline Eigen::Vector2d point_at(const BezierSegment& segment, double s) {
  Eigen::MatrixXd points = segment.control;
  for (Eigen::Index n = points.cols() - 1; n > 0; --n) {
    points = ((1 - s) * points.leftCols(n) + s * points.rightCols(n)).eval();
  }
  return points.col(0);
}

/// integral of (x dy - y dx) / 2 of closed subpaths: positive if clockwise as seen. The integrand
/// has degree five at most, for which three Gauss points are exact.
inline double area_of(const std::vector<Subpath>& subpaths) {
  const double offset = std::sqrt(0.6) / 2;
  const std::pair<double, double> gauss[] = {
      {0.5 - offset, 5.0 / 18}, {0.5, 4.0 / 9}, {0.5 + offset, 5.0 / 18}};
  double area = 0;
  for (const Subpath& subpath : subpaths) {
    for (const BezierSegment& segment : subpath.segments) {
      BezierSegment derivative;
      const Eigen::Index n = segment.control.cols() - 1;
      derivative.control =
          static_cast<double>(n) * (segment.control.rightCols(n) - segment.control.leftCols(n));
      for (const auto& [s, weight] : gauss) {
        const Eigen::Vector2d at = point_at(segment, s), by = point_at(derivative, s);
        area += weight * (at.x() * by.y() - at.y() * by.x()) / 2;
      }
    }
  }
  return area;
}

inline Eigen::AlignedBox2d box_of(const std::vector<Subpath>& subpaths) {
  Eigen::AlignedBox2d box;
  for (const Subpath& subpath : subpaths) {
    for (const BezierSegment& segment : subpath.segments) {
      for (int i = 0; i <= 16; ++i) box.extend(point_at(segment, i / 16.0));
    }
  }
  return box;
}

inline void expect_near(const Eigen::Vector2d& actual, double x, double y, double tolerance) {
  EXPECT_NEAR(actual.x(), x, tolerance);
  EXPECT_NEAR(actual.y(), y, tolerance);
}

/// The message with which a text is refused.
template <typename Read>
std::string refusal(const Read& read_it) {
  try {
    read_it();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

}  // namespace wavecurve::io::test
