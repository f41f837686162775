#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/curves/path.hpp"

namespace wavecurve {

/// Numbers of samples are powers of two within these bounds.
constexpr Eigen::Index fewest_samples = 4, most_samples = Eigen::Index{1} << 24;

/// Throws std::invalid_argument naming the number and the bounds.
void check_samples(Eigen::Index samples);

/// Whether corners, the joints where the direction turns by more than 20 degrees, become samples.
enum class Corners {
  ignored,  ///< all samples are uniform in arc length: the publication's
  kept,     ///< uniform between neighbouring corners, their numbers in proportion to the length
};

/// Points of a subpath, uniform in arc length from its start: row i at l = i L / samples, clockwise
/// as seen. With Corners::kept and a corner, row 0 is the first corner from the start on.
///
/// An open subpath is run through there and back, so that the points are those of a closed curve:
/// row 0 is its start, row samples / 2 its end, rows i and samples - i coincide. They do so at
/// every scale of a transform with filters that are symmetric about 0 (bspline4.4, cdf9.7, not D8).
/// Throws std::invalid_argument for an empty subpath, a length that is zero or not finite, a number
/// as check_samples has it, and more corners than samples. Publication, section 2.2.
Contour sample_contour(const Subpath& subpath, Eigen::Index samples,
                       Corners corners = Corners::ignored);

/// The same for a closed polygon.
Contour sample_contour(const Contour& points, Eigen::Index samples,
                       Corners corners = Corners::ignored);

/// All subpaths of a layer, in order. If the largest area is counter-clockwise, all are reversed:
/// holes keep their direction relative to what they are holes of, on which the fill rule relies. In
/// a layer that is filled, open subpaths are closed by a line, as filling does; there and back
/// there would be nothing to fill. Throws as sample_contour does, naming the layer.
std::vector<Contour> sample_layer(const Layer& layer, Eigen::Index samples,
                                  Corners corners = Corners::ignored);

/// Whole numbers of samples in proportion to lengths, at least one each: the largest remainders are
/// rounded up. There are at most as many lengths as samples.
std::vector<Eigen::Index> shares_of_samples(const std::vector<double>& lengths,
                                            Eigen::Index samples);

/// The lines through the points, closed by the one from the last to the first unless they coincide.
Subpath polygon(const Contour& points);

}  // namespace wavecurve
