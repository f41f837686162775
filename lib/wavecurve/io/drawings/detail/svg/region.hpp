#pragma once

#include <cstddef>
#include <vector>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

/// A part of the plane, bounded by closed polygons that do not cross each other: outer ones turn one way, holes the
/// other. Clipper computes with whole numbers; one unit of them is about 2^-45 of the largest coordinate.
struct Region {
  std::vector<Contour> polygons;

  double area() const;
};

/// What polygons enclose by a fill rule.
Region region_of(const std::vector<Contour>& polygons, FillRule rule);

Region united(const Region& a, const Region& b);
Region intersected(const Region& a, const Region& b);

/// The points of subpaths, one polygon for each, so that no curve is further from its polygon than the tolerance, if
/// so many points a segment suffice for it.
inline constexpr int most_pieces = 64;
std::vector<Contour> polygons_of(const std::vector<Subpath>& subpaths, double tolerance);

/// Closed subpaths of straight lines, which enclose the region by either fill rule.
std::vector<Subpath> outline_of(const Region& region);

/// A bound of the work of an operation on all these polygons together, which is how often they may cross: the number
/// of edges times the number of runs of edges that only rise or only fall.
std::size_t most_crossings(const std::vector<Contour>& polygons);

}  // namespace wavecurve::io
