#include "wavecurve/curves/descriptor.hpp"

#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/detail/arc_length.hpp"
#include "wavecurve/curves/normalized_contour.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve {

namespace {

LayerDescriptor describe(const Layer& layer, const FilterBank<double>& bank,
                         const DescriptorOptions& options) {
  LayerDescriptor result{layer.id, layer.paint, {}};
  const std::vector<Contour> contours = sample_layer(layer, options.samples, options.corners);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    const Subpath& subpath = layer.subpaths[i];
    const bool closed = subpath.closed || layer.paint.fill.has_value();
    const Contour points = options.normalized ? normalized_contour(contours[i]) : contours[i];
    const double unit = options.normalized ? contour_size(contours[i]) : 1;
    result.contours.push_back({to_coefficients(bank, points, options.levels, options.mode), closed,
                               arc_length(subpath) / unit});
  }
  return result;
}

void check_scale(const DescriptorOptions& options, Eigen::Index scale) {
  for (int level = 0; level <= options.levels; ++level) {
    if (scale == options.samples >> level) return;
  }
  throw std::invalid_argument(
      must_be("scale", scale,
              fmt::format("a power of two from {} to {}", options.samples >> options.levels,
                          options.samples)));
}

}  // namespace

Descriptor describe(const Drawing& drawing, const FilterBank<double>& bank,
                    const DescriptorOptions& options) {
  if (options.normalized && options.corners == Corners::kept) {
    throw std::invalid_argument("contours are normalized without keeping corners, or the reverse");
  }
  Descriptor descriptor{bank.name, options, drawing.view_box, {}};
  // Points are 1 from the middle in the root mean square, so few are beyond three times that.
  if (options.normalized) descriptor.view_box = {-3, -3, 6, 6};
  for (const Layer& layer : drawing.layers) {
    descriptor.layers.push_back(describe(layer, bank, options));
  }
  return descriptor;
}

std::vector<Contour> reconstruct(const LayerDescriptor& layer, const FilterBank<double>& bank,
                                 const DescriptorOptions& options, Eigen::Index scale) {
  check_scale(options, scale);
  std::vector<Contour> contours;
  for (const ContourDescriptor& contour : layer.contours) {
    contours.push_back(
        to_samples(bank, approximation(contour.coefficients, scale), options.levels, options.mode));
  }
  return contours;
}

Eigen::VectorXd energy_shares(const Contour& coefficients, int levels) {
  const std::vector<Band> bands = multiscale_bands(coefficients.rows(), levels);
  Eigen::VectorXd energy(static_cast<Eigen::Index>(bands.size()));
  for (Eigen::Index i = 0; i < energy.size(); ++i) {
    const Band& band = bands[static_cast<std::size_t>(i)];
    Contour part = coefficients.middleRows(band.offset, band.size);
    if (band.is_scaling) part.rowwise() -= part.colwise().mean().eval();
    energy[i] = part.squaredNorm();
  }
  const double total = energy.sum();
  return total > 0 ? Eigen::VectorXd(energy / total) : energy;
}

}  // namespace wavecurve
