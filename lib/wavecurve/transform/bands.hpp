#pragma once

#include <vector>

#include <Eigen/Core>

namespace wavecurve {

/// One block of a coefficient vector in global-to-local order: the scaling coefficients of the
/// coarsest level first, then the wavelet coefficients from coarse to fine (publication, 3.2).
struct Band {
  Eigen::Index offset = 0, size = 0;
  /// Levels of decomposition between the samples and this band: size = samples / 2^depth.
  int depth = 0;
  bool is_scaling = false;
};

/// The levels + 1 bands of a signal; without decomposition, one scaling band.
/// Throws std::invalid_argument unless samples >= 1, levels >= 0 and 2^levels divides samples.
std::vector<Band> multiscale_bands(Eigen::Index samples, int levels);

/// The offsets of all bands but the first: where the blocks of a multiscale matrix meet.
std::vector<Eigen::Index> band_borders(Eigen::Index samples, int levels);

}  // namespace wavecurve
