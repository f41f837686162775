#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace wavecurve::io {

/// What the columns of a table of points are, by position.
struct PointColumns {
  std::size_t x = 0, y = 1;
  std::optional<std::size_t> index;  ///< numbers the points, or, where it stays the same, contours
  std::vector<std::size_t>
      contour;                    ///< their entries together tell to which contour a point belongs
  std::vector<std::size_t> time;  ///< of a record, whose points a still drawing must not mix
  std::vector<std::string> warnings;  ///< which columns are not read, or are taken for x and y
};

/// The columns that a header names, in any order and case, whatever unit follows (column_name()).
///   coordinates: x and y, also as pos_x, x_coord, ...; else lon and lat, easting and northing, col and
///                row, axis_1 and axis_0, u and v; else two columns that are only numbered, as V1 and V2
///   contours: id, contour, name, label, shape, polygon, ring, part, group, object, ..., also with _id
///   time: t, time, frame, timestamp, slice
///   points: index, i, k, n, no, point, vertex, row, ..., and a first column without a name
/// Throws std::invalid_argument where x or y is missing, or there are two of one.
PointColumns point_columns(const std::vector<std::string>& header);

/// Whether such a header could be read: words of a comment mostly cannot.
bool names_coordinates(const std::vector<std::string>& header);

/// Whether a first row names columns and holds no point.
bool is_point_header(const std::vector<std::string>& row, char separator);

}  // namespace wavecurve::io
