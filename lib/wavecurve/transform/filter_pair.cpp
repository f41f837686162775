#include "wavecurve/transform/filter_pair.hpp"

#include <algorithm>

#include "wavecurve/transform/periodic_kernels.hpp"
#include "wavecurve/transform/rotation_kernels.hpp"

namespace wavecurve {

namespace {

/// Outputs computed at a time, so that what they are computed from stays in the first-level cache.
Eigen::Index block_size(Layout layout) { return layout == Layout::interleaved ? 32 : 256; }

int floor_half(int n) { return (n - (n & 1)) / 2; }

template <class Scalar>
int pair_count(const Filter<Scalar>& filter) {
  return floor_half(filter.last_index()) - floor_half(filter.first_index) + 1;
}

}  // namespace

template <class Scalar>
FilterPair<Scalar>::FilterPair(const Filter<Scalar>& low, const Filter<Scalar>& high)
    : pairs_(std::max(pair_count(low), pair_count(high))),
      low_(polyphase(low, pairs_)),
      high_(polyphase(high, pairs_)),
      rotations_(rotation_cascade(low, high)) {}

template <class Scalar>
typename FilterPair<Scalar>::Polyphase FilterPair<Scalar>::polyphase(const Filter<Scalar>& filter,
                                                                     int pairs) {
  Polyphase result;
  const int first = floor_half(filter.first_index);
  result.first = first;
  for (int t = first; t < first + pairs; ++t) {
    result.even.push_back(filter[2 * t]);
    result.odd.push_back(filter[2 * t + 1]);
  }
  result.reversed_even.assign(result.even.rbegin(), result.even.rend());
  result.reversed_odd.assign(result.odd.rbegin(), result.odd.rend());
  return result;
}

template <class Scalar>
Eigen::Index FilterPair<Scalar>::overlap() const {
  return pairs_ - 1 + std::abs(low_.first - high_.first);
}

template <class Scalar>
Eigen::Index FilterPair<Scalar>::buffer_size(Layout layout) const {
  const Eigen::Index rings = rotations_ ? (fused_levels - 1) * ring_size : 0;
  return std::max(rings, 4 * row_size<Scalar>(layout) * (block_size(layout) + overlap()));
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
  const Eigen::Index first = std::min(low_.first, high_.first);
  const Eigen::Index block = block_size(Layout::single);
  Scalar* even = buffer;
  Scalar* odd = buffer + block + overlap();
  const auto filter = [&](const Polyphase& taps, Eigen::Index count, Scalar* out) {
    const Eigen::Index shift = taps.first - first;
    correlate_pair(taps.even.data(), taps.odd.data(), pairs_, even + shift, odd + shift, count,
                   out);
  };
  for (Eigen::Index n = 0; n < half; n += block) {
    const Eigen::Index count = std::min(block, half - n);
    split_pairs(fine, half, n + first, count + overlap(), even, odd);
    filter(low_, count, c + n);
    filter(high_, count, d + n);
  }
}

template <class Scalar>
void FilterPair<Scalar>::analyse_group(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                                       Scalar* buffer) const {
  constexpr Eigen::Index row = group_size<Scalar>;
  const Eigen::Index first = std::min(low_.first, high_.first);
  const Eigen::Index block = block_size(Layout::interleaved);
  for (Eigen::Index n = 0; n < half; n += block) {
    const Eigen::Index count = std::min(block, half - n);
    const Scalar* pairs =
        periodic_window(fine, half, n + first, count + overlap(), buffer, 2 * row);
    const auto filter = [&](const Polyphase& taps, Scalar* out) {
      const Scalar* even = pairs + (taps.first - first) * 2 * row;
      correlate_pair_of_group(taps.even.data(), taps.odd.data(), pairs_, even, even + row, 2 * row,
                              count, out, row);
    };
    filter(low_, c + n * row);
    filter(high_, d + n * row);
  }
}

template <class Scalar>
void FilterPair<Scalar>::synthesise(const Scalar* c, const Scalar* d, Eigen::Index half,
                                    Scalar* fine, Scalar* buffer, Layout layout) const {
  if (rotations_) return rotate_backward(*rotations_, c, d, half, fine, layout);
  const Eigen::Index row = row_size<Scalar>(layout), block = block_size(layout);
  const Eigen::Index quarter = buffer_size(layout) / 4;
  Scalar* even = buffer + 2 * quarter;
  Scalar* odd = buffer + 3 * quarter;
  // fine_{2n+r} takes c_{n-t} with the tap 2t + r: reversed taps on a window that starts earlier.
  const auto window = [&](const Scalar* band, const Polyphase& taps, Eigen::Index n,
                          Eigen::Index count, Scalar* copy) {
    return periodic_window(band, half, n - taps.first - (pairs_ - 1), count + pairs_ - 1, copy,
                           row);
  };
  for (Eigen::Index n = 0; n < half; n += block) {
    const Eigen::Index count = std::min(block, half - n);
    const Scalar* u = window(c, low_, n, count, buffer);
    const Scalar* v = window(d, high_, n, count, buffer + quarter);
    if (layout == Layout::interleaved) {
      Scalar* out = fine + 2 * n * row;
      correlate_pair_of_group(low_.reversed_even.data(), high_.reversed_even.data(), pairs_, u, v,
                              row, count, out, 2 * row);
      correlate_pair_of_group(low_.reversed_odd.data(), high_.reversed_odd.data(), pairs_, u, v,
                              row, count, out + row, 2 * row);
      continue;
    }
    correlate_pair(low_.reversed_even.data(), high_.reversed_even.data(), pairs_, u, v, count,
                   even);
    correlate_pair(low_.reversed_odd.data(), high_.reversed_odd.data(), pairs_, u, v, count, odd);
    merge_pairs(even, odd, count, fine + 2 * n);
  }
}

template class FilterPair<double>;
template class FilterPair<float>;

}  // namespace wavecurve
