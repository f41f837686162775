#include "wavecurve/transform/bands.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

std::vector<Band> multiscale_bands(Eigen::Index samples, int levels) {
  check_at_least("samples", samples, 1);
  if (levels < 0 || levels > 62 || samples % (Eigen::Index{1} << levels) != 0) {
    throw std::invalid_argument(
        fmt::format("levels is {}, but {} samples must be a multiple of 2^levels, levels >= 0",
                    levels, samples));
  }
  const Eigen::Index coarsest = samples >> levels;
  std::vector<Band> bands{{0, coarsest, levels, true}};
  for (int depth = levels; depth >= 1; --depth) {
    bands.push_back({samples >> depth, samples >> depth, depth, false});
  }
  return bands;
}

std::vector<Eigen::Index> band_borders(Eigen::Index samples, int levels) {
  std::vector<Eigen::Index> borders;
  for (const Band& band : multiscale_bands(samples, levels)) {
    if (band.offset > 0) borders.push_back(band.offset);
  }
  return borders;
}

}  // namespace wavecurve
