#include "wavecurve/curves/descriptor.hpp"

#include <cstddef>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/detail/arc_length.hpp"
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
    result.contours.push_back({to_coefficients(bank, contours[i], options.levels, options.mode),
                               subpath.closed || layer.paint.fill.has_value(),
                               arc_length(subpath)});
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
  Descriptor descriptor{bank.name, options, drawing.view_box, {}};
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
