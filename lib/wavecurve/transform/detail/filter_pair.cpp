#include "wavecurve/transform/detail/filter_pair.hpp"

#include <algorithm>

#include "wavecurve/filters/detail/whole_numbers.hpp"
#include "wavecurve/transform/detail/rotation_kernels.hpp"

namespace wavecurve {

namespace {

/// Outputs computed at a time, so that what they are computed from stays in the first-level cache.
Eigen::Index block_size(Layout layout) { return layout == Layout::interleaved ? 32 : 256; }

/// Inputs beyond the number of outputs.
template <class Scalar>
Eigen::Index overlap(const PolyphaseTaps<Scalar>& taps) {
  return static_cast<Eigen::Index>(taps.size()) - 1;
}

}  // namespace

template <class Scalar>
FilterPair<Scalar>::FilterPair(const Filter<Scalar>& low, const Filter<Scalar>& high)
    : rotations_(rotation_cascade(low, high)) {
  const int low_first = floor_half(low.first_index), low_last = floor_half(low.last_index());
  const int high_first = floor_half(high.first_index), high_last = floor_half(high.last_index());
  first_ = std::min(low_first, high_first);
  for (int t = std::min(low_first, high_first); t <= std::max(low_last, high_last); ++t) {
    analysis_.push_back({low[2 * t], low[2 * t + 1], high[2 * t], high[2 * t + 1]});
  }
  // Each band has its own window, so that taps meet however the filters are shifted.
  const int pairs = std::max(low_last - low_first, high_last - high_first) + 1;
  c_delay_ = low_first + pairs - 1;
  d_delay_ = high_first + pairs - 1;
  for (int k = pairs - 1; k >= 0; --k) {
    const int l = 2 * (low_first + k), h = 2 * (high_first + k);
    synthesis_.push_back({low[l], high[h], low[l + 1], high[h + 1]});
  }
}

template <class Scalar>
Eigen::Index FilterPair<Scalar>::buffer_size(Layout layout) const {
  const Eigen::Index rings = rotations_ ? (fused_levels - 1) * ring_size : 0;
  return std::max(rings, 2 * row_size<Scalar>(layout) * (block_size(layout) + overlap(analysis_)));
}

template <class Scalar>
int FilterPair<Scalar>::levels_at_once(Eigen::Index samples, Layout layout) const {
  const bool fused = rotations_ && layout == Layout::single && samples >= fused_from &&
                     samples % (ring_size << fused_levels) == 0;
  return fused ? fused_levels : 1;
}

template <class Scalar>
void FilterPair<Scalar>::analyse_levels(const Scalar* fine, Eigen::Index samples, Scalar* c,
                                        Scalar* bands, Scalar* buffer) const {
  rotate_forward_fused(*rotations_, fine, samples, c, bands, buffer);
}

template <class Scalar>
void FilterPair<Scalar>::synthesise_levels(const Scalar* c, const Scalar* bands,
                                           Eigen::Index samples, Scalar* fine,
                                           Scalar* buffer) const {
  rotate_backward_fused(*rotations_, c, bands, samples, fine, buffer);
}

template <class Scalar>
void FilterPair<Scalar>::analyse(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                                 Scalar* buffer, Layout layout) const {
  if (rotations_) return rotate_forward(*rotations_, fine, half, c, d, layout);
  if (layout == Layout::interleaved) return analyse_group(fine, half, c, d, buffer);
  analyse_one(fine, half, c, d, buffer);
}

template <class Scalar>
void FilterPair<Scalar>::analyse_one(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                                     Scalar* buffer) const {
  const Eigen::Index block = block_size(Layout::single);
  Scalar* even = buffer;
  Scalar* odd = buffer + block + overlap(analysis_);
  for (Eigen::Index n = 0; n < half; n += block) {
    const Eigen::Index count = std::min(block, half - n);
    split_pairs(fine, half, n + first_, count + overlap(analysis_), even, odd);
    correlate_pair(analysis_, even, odd, count, c + n, d + n);
  }
}

template <class Scalar>
void FilterPair<Scalar>::analyse_group(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                                       Scalar* buffer) const {
  constexpr Eigen::Index row = group_size<Scalar>;
  const Eigen::Index block = block_size(Layout::interleaved);
  for (Eigen::Index n = 0; n < half; n += block) {
    const Eigen::Index count = std::min(block, half - n);
    const Scalar* pairs =
        periodic_window(fine, half, n + first_, count + overlap(analysis_), buffer, 2 * row);
    correlate_pair_of_group(analysis_, pairs, pairs + row, 2 * row, count, c + n * row, d + n * row,
                            row);
  }
}

template <class Scalar>
void FilterPair<Scalar>::synthesise(const Scalar* c, const Scalar* d, Eigen::Index half,
                                    Scalar* fine, Scalar* buffer, Layout layout) const {
  if (rotations_) return rotate_backward(*rotations_, c, d, half, fine, layout);
  const Eigen::Index row = row_size<Scalar>(layout), block = block_size(layout);
  // fine_{2n+r} takes c_{n-t} with the tap 2t + r: reversed taps on a window that starts earlier.
  for (Eigen::Index n = 0; n < half; n += block) {
    const Eigen::Index count = std::min(block, half - n);
    const Eigen::Index length = count + overlap(synthesis_);
    const Scalar* u = periodic_window(c, half, n - c_delay_, length, buffer, row);
    const Scalar* v =
        periodic_window(d, half, n - d_delay_, length, buffer + buffer_size(layout) / 2, row);
    Scalar* const out = fine + 2 * n * row;
    if (layout == Layout::interleaved) {
      correlate_pair_of_group(synthesis_, u, v, row, count, out, out + row, 2 * row);
    } else {
      correlate_pair_merged(synthesis_, u, v, count, out);
    }
  }
}

template class FilterPair<double>;
template class FilterPair<float>;

}  // namespace wavecurve
