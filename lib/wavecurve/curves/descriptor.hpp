#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/curves/coefficients.hpp"
#include "wavecurve/curves/contour.hpp"
#include "wavecurve/curves/drawing.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

struct ContourDescriptor {
  /// Wavelet coefficients in global-to-local order (see Band), one a row, columns x and y: a_n^M
  /// and c_n^M, then r_n^m and d_n^m from the coarsest m on. Publication, (2.10)-(2.12).
  Contour coefficients;
  bool closed = true;  ///< false: an open stroke, there and back
  double length = 0;   ///< L of t = l / L, in units of the drawing; of an open stroke, one way
};

struct LayerDescriptor {
  std::string id;
  Paint paint;
  std::vector<ContourDescriptor> contours;
};

/// How a drawing is described; the same for all of its contours.
struct DescriptorOptions {
  Eigen::Index samples = 256;  ///< of each contour
  int levels = 4;
  SampleMode mode = SampleMode::samples;
  Corners corners = Corners::ignored;
  /// Each contour for itself as normalized_contour makes it, from samples uniform in arc length: then
  /// descriptors of equal shapes are equal. Lengths are in units of the size, the view box is about 0.
  bool normalized = false;
};

/// The wavelet descriptor of a drawing, with all that it takes to draw it again.
struct Descriptor {
  std::string filter;  ///< a name that find_filter_bank knows, or the path of a user's filter
  DescriptorOptions options;
  ViewBox view_box;
  std::vector<LayerDescriptor> layers;
};

/// Publication, section 2.2. Throws as sample_layer and to_coefficients do.
Descriptor describe(const Drawing& drawing, const FilterBank<double>& bank,
                    const DescriptorOptions& options);

/// The samples of a layer's contours from the `scale` coarsest coefficients; all of them: the
/// samples that were described, up to rounding. Throws std::invalid_argument unless scale is one of
/// samples, samples / 2, ..., samples / 2^levels.
std::vector<Contour> reconstruct(const LayerDescriptor& layer, const FilterBank<double>& bank,
                                 const DescriptorOptions& options, Eigen::Index scale);

/// The share of each band in the sum of squares of the coefficients, coarsest first, those of the
/// coarsest scale taken from their mean: where the curve lies does not count. For an orthonormal
/// family, that is the variance of the samples. All zero for a contour that is a point.
Eigen::VectorXd energy_shares(const Contour& coefficients, int levels);

}  // namespace wavecurve
