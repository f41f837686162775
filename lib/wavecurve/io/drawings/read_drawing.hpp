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

/// Reads a drawing.
///
/// `.svg`: every shape that is painted becomes a layer, in painting order, with all transformations
/// applied; so do the copies that `<use>` makes. Lines stay lines, quadratics quadratics; circles,
/// ellipses and arcs become cubic segments whose radius is at most 1e-10 of it too large. The view
/// box is that of the file, or its width and height, or else that of the outlines. Ids are those of
/// the file; of a shape without one, its element and number, such as path-3, and a number is added
/// where that is taken. An open subpath that is only filled is closed, as it is painted; one that
/// is filled and stroked becomes two layers, the second with `-stroke` added to the id. Gradients
/// become their mean colour. Text, images, filters, masks, clipping, markers, patterns, animations
/// and dashes are not supported; strokes have round ends and corners. A shape without length is
/// skipped with a warning. Subpaths that end where they start count as closed.
///
/// `.csv`: points x,y of one closed contour, a line each; or contour,x,y, where a contour is the
/// run of lines with the same first entry. A header, blank lines and comments after # may be there.
/// A contour is a hole where it lies inside of another one (even-odd rule); the fill is black.
///
/// Throws std::invalid_argument naming the file, the line or element, the value and the bound, for
/// anything that is broken, that declares entities, lies in itself, or draws nothing, and for a
/// file that cannot be opened; std::system_error if reading fails. Bounds: 256 MiB; 10^6
/// elements, 256 in each other; 10^5 layers; 4 10^6 segments; coordinates within +-1e9.
DrawingFile read_drawing(const std::filesystem::path& path);

}  // namespace wavecurve::io
