#include "wavecurve/transform/periodic_transform.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/periodic_kernels.hpp"
#include "wavecurve/transform/rotation_kernels.hpp"

namespace wavecurve {

namespace {

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
Eigen::Index FilterPair<Scalar>::buffer_size() const {
  return 4 * (block_size + pairs_ + std::abs(low_.first - high_.first));
}

template <class Scalar>
void FilterPair<Scalar>::analyse(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                                 Scalar* buffer) const {
  if (rotations_) return rotate_forward(*rotations_, fine, half, c, d);
  const Eigen::Index first = std::min(low_.first, high_.first);
  const Eigen::Index overlap = pairs_ - 1 + std::abs(low_.first - high_.first);
  Scalar* even = buffer;
  Scalar* odd = buffer + buffer_size() / 2;
  const auto filter = [&](const Polyphase& taps, Eigen::Index count, Scalar* out) {
    const Eigen::Index shift = taps.first - first;
    correlate_pair(taps.even.data(), taps.odd.data(), pairs_, even + shift, odd + shift, count,
                   out);
  };
  for (Eigen::Index n = 0; n < half; n += block_size) {
    const Eigen::Index count = std::min(block_size, half - n);
    split_pairs(fine, half, n + first, count + overlap, even, odd);
    filter(low_, count, c + n);
    filter(high_, count, d + n);
  }
}

template <class Scalar>
void FilterPair<Scalar>::synthesise(const Scalar* c, const Scalar* d, Eigen::Index half,
                                    Scalar* fine, Scalar* buffer) const {
  if (rotations_) return rotate_backward(*rotations_, c, d, half, fine);
  const Eigen::Index quarter = buffer_size() / 4;
  Scalar* even = buffer + 2 * quarter;
  Scalar* odd = buffer + 3 * quarter;
  // fine_{2n+r} takes c_{n-t} with the tap 2t + r: reversed taps on a window that starts earlier.
  const auto window = [&](const Scalar* band, const Polyphase& taps, Eigen::Index n,
                          Eigen::Index count, Scalar* copy) {
    return periodic_window(band, half, n - taps.first - (pairs_ - 1), count + pairs_ - 1, copy);
  };
  for (Eigen::Index n = 0; n < half; n += block_size) {
    const Eigen::Index count = std::min(block_size, half - n);
    const Scalar* u = window(c, low_, n, count, buffer);
    const Scalar* v = window(d, high_, n, count, buffer + quarter);
    correlate_pair(low_.reversed_even.data(), high_.reversed_even.data(), pairs_, u, v, count,
                   even);
    correlate_pair(low_.reversed_odd.data(), high_.reversed_odd.data(), pairs_, u, v, count, odd);
    merge_pairs(even, odd, count, fine + 2 * n);
  }
}

template <class Scalar>
PeriodicTransform<Scalar>::PeriodicTransform(const FilterBank<Scalar>& bank, Eigen::Index samples,
                                             int levels)
    : samples_(samples),
      levels_(levels),
      analysis_(bank.analysis_low, bank.analysis_high),
      synthesis_(bank.synthesis_low, bank.synthesis_high) {
  multiscale_bands(samples, levels);
}

template <class Scalar>
Eigen::Index PeriodicTransform<Scalar>::workspace_size() const {
  return samples_ + std::max(analysis_.buffer_size(), synthesis_.buffer_size());
}

template <class Scalar>
void PeriodicTransform<Scalar>::check_sizes(In input, const Out& output,
                                            const Out& workspace) const {
  if (input.size() != samples_ || output.size() != samples_) {
    throw std::invalid_argument(fmt::format("a transform of {} samples was given {} in and {} out",
                                            samples_, input.size(), output.size()));
  }
  if (workspace.size() < workspace_size()) {
    throw std::invalid_argument(fmt::format("the workspace holds {} values, but {} are needed",
                                            workspace.size(), workspace_size()));
  }
}

template <class Scalar>
void PeriodicTransform<Scalar>::analyse(const FilterPair<Scalar>& filters, In input, Out output,
                                        Out workspace) const {
  check_sizes(input, output, workspace);
  if (levels_ == 0) output = input;
  // The scaling coefficients alternate between the two halves of the workspace.
  Scalar* const buffer = workspace.data() + samples_;
  const Scalar* fine = input.data();
  for (int level = 1; level <= levels_; ++level) {
    const Eigen::Index half = samples_ >> level;
    Scalar* const alternate = workspace.data() + (level % 2) * (samples_ / 2);
    Scalar* const c = level == levels_ ? output.data() : alternate;
    filters.analyse(fine, half, c, output.data() + half, buffer);
    fine = c;
  }
}

template <class Scalar>
void PeriodicTransform<Scalar>::synthesise(const FilterPair<Scalar>& filters, In input, Out output,
                                           Out workspace) const {
  check_sizes(input, output, workspace);
  if (levels_ == 0) output = input;
  Scalar* const buffer = workspace.data() + samples_;
  const Scalar* c = input.data();
  for (int level = levels_; level >= 1; --level) {
    const Eigen::Index half = samples_ >> level;
    Scalar* const alternate = workspace.data() + (level % 2) * (samples_ / 2);
    Scalar* const fine = level == 1 ? output.data() : alternate;
    filters.synthesise(c, input.data() + half, half, fine, buffer);
    c = fine;
  }
}

template <class Scalar>
void PeriodicTransform<Scalar>::forward(In samples, Out coefficients, Out workspace) const {
  analyse(analysis_, samples, coefficients, workspace);
}

template <class Scalar>
void PeriodicTransform<Scalar>::inverse(In coefficients, Out samples, Out workspace) const {
  synthesise(synthesis_, coefficients, samples, workspace);
}

template <class Scalar>
void PeriodicTransform<Scalar>::forward_adjoint(In coefficients, Out samples, Out workspace) const {
  synthesise(analysis_, coefficients, samples, workspace);
}

template <class Scalar>
void PeriodicTransform<Scalar>::inverse_adjoint(In samples, Out coefficients, Out workspace) const {
  analyse(synthesis_, samples, coefficients, workspace);
}

template class FilterPair<double>;
template class FilterPair<float>;
template class PeriodicTransform<double>;
template class PeriodicTransform<float>;

}  // namespace wavecurve
