#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "wavecurve/curves/drawing.hpp"

namespace wavecurve::io {

struct DrawingFile {
  Drawing drawing;
  std::vector<std::string> warnings;  ///< what is not supported, each once; it was skipped
};

/// What a table of points does not say itself.
struct PointOptions {
  bool open =
      false;  ///< contours are not closed, but lines: black, as wide as 1/100 of the drawing
  bool y_up = false;  ///< y points up
  bool operator==(const PointOptions&) const = default;
};

/// Reads a drawing.
///
/// `.svg`, or `.svgz`, which is packed: every shape that is painted becomes a layer, in painting order, with all
/// transformations applied; so do the copies that `<use>` makes. `sprite.svg#id` is one symbol or
/// element, as `<use>` draws it. Lines stay lines, quadratics quadratics; circles,
/// ellipses and arcs become cubic segments whose radius is at most 1e-10 of it too large. The view
/// box is that of the file, or its width and height, or else that of the outlines. Ids are those of
/// the file, or Inkscape's labels; of a shape without one, its element and number, such as path-3, and
/// a number is added where that is taken. An open subpath that is only filled is closed, as it is painted; one that
/// is filled and stroked becomes two layers, the second with `-stroke` added to the id. Gradients
/// become their mean colour. Text, images, filters, masks, clipping, markers, patterns, animations
/// and dashes are not supported. A shape without length is
/// skipped with a warning. Subpaths that end where they start count as closed. What comes before
/// the defect of a broken element is drawn, with a warning that names its line; so are the others.
///
/// `.csv`: points of closed contours, a line each, by the names of their columns (point_columns):
/// x and y; of contours, which are told apart; of the points, which are counted. Cells are separated
/// by commas, semicolons, tabs or blanks, and quoted or not; with semicolons or tabs decimals may have a
/// comma. Without a header, two columns are x,y, and three contour,x,y, or number,x,y. Blank lines
/// separate contours of three points or more. Comments after # may be there. A contour is a hole
/// where it lies inside of another one (even-odd rule); the fill is black. A table whose points
/// belong to several times is refused.
///
/// Throws std::invalid_argument naming the file, the line or element, the value and the bound, for
/// what is no XML or no table, declares entities that lie elsewhere, exceeds a bound, or draws nothing,
/// and for a file that cannot be opened; std::system_error if reading fails. Bounds: 256 MiB; 10^6
/// elements, 256 in each other; 10^5 layers; 4 10^6 segments or points; coordinates within +-1e9.
DrawingFile read_drawing(const std::filesystem::path& path, const PointOptions& options = {});

}  // namespace wavecurve::io
