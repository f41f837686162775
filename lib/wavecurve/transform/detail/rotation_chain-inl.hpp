// What both directions share, compiled again for every instruction set: Highway's way of a header.
#if defined(WAVECURVE_ROTATION_CHAIN) == defined(HWY_TARGET_TOGGLE)
#ifdef WAVECURVE_ROTATION_CHAIN
#undef WAVECURVE_ROTATION_CHAIN
#else
#define WAVECURVE_ROTATION_CHAIN
#endif

#include <algorithm>

#include "wavecurve/transform/detail/rotation_kernels.hpp"
#include "wavecurve/transform/detail/rotation_level-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

/// Covers 0 .. half - 1 by whole vectors: the last run overlaps the one before it if need be, and
/// computes the same values again.
template <class L, class Run>
HWY_INLINE void cover(Index half, Run run) {
  const Index whole = half / L::advance() * L::advance();
  run(0, whole);
  if (whole < half) run(half - L::advance(), L::advance());
}

/// Several levels of one signal at once, a block after the other: what one level writes for the
/// next stays in a ring in the first-level cache.
template <int K, class T>
class Chain {
 public:
  using L = Level<K, Fill::along, hn::ScalableTag<T>>;

  HWY_INLINE Chain(const RotationCascade<T>& cascade, Index samples, T* rings)
      : cascade_(cascade), samples_(samples), rings_(rings) {}

  HWY_INLINE void forward(const T* fine, T* c, T* bands) {
    const Index delay = 1 - cascade_.size();
    c_shift_ = delay - cascade_.low_first;
    d_shift_ = delay - cascade_.high_first;
    for (int level = fused_levels; level > 1; --level) {
      done_[level - 1] =
          2 * (done_[level] - L::delay(cascade_.size())) + cascade_.parity - c_shift_;
    }
    for (Index end = block; end <= samples_ >> fused_levels; end += block) {
      forward_to(end, fused_levels, fine, c, bands);
    }
  }

  HWY_INLINE void backward(const T* c, const T* bands, T* fine) {
    c_shift_ = -cascade_.low_first;
    d_shift_ = -cascade_.high_first;
    for (int level = 1; level < fused_levels; ++level) {
      done_[level + 1] = pair_of(done_[level] - L::delay(cascade_.size()) + c_shift_);
    }
    constexpr Index finest_block = block << (fused_levels - 1);
    for (Index end = finest_block; end <= samples_ >> 1; end += finest_block) {
      backward_to(end, 1, c, bands, fine);
    }
  }

 private:
  /// Pairs of the coarsest level at a time.
  static constexpr Index block = ring_size >> fused_levels;

  /// The pair of samples that the n-th sample belongs to.
  HWY_INLINE Index pair_of(Index n) const { return (n - cascade_.parity) >> 1; }
  /// Ends on a whole vector, after the pairs that are done.
  HWY_INLINE Index whole_vectors(Index end, int level) const {
    const Index count = std::max(end - done_[level], Index{0});
    return done_[level] + (count + L::advance() - 1) / L::advance() * L::advance();
  }
  HWY_INLINE T* ring(int level) const { return rings_ + (level - 1) * ring_size; }

  void forward_to(Index end, int level, const T* fine, T* c, T* bands) {
    end = whole_vectors(end, level);
    if (level > 1) {
      forward_to(2 * end + cascade_.parity - c_shift_, level - 1, fine, c, bands);
    }
    const bool last = level == fused_levels;
    const Index half = samples_ >> level;
    L(cascade_, cascade_.tangents, level == 1 ? samples_ : ring_size, last ? half : ring_size, half)
        .forward(level == 1 ? fine : ring(level - 1), last ? c : ring(level), bands + half,
                 done_[level], end - done_[level], c_shift_, d_shift_);
    done_[level] = end;
  }

  void backward_to(Index end, int level, const T* c, const T* bands, T* fine) {
    end = whole_vectors(end, level);
    const bool last = level == fused_levels;
    if (!last) backward_to(pair_of(end - 1 + c_shift_) + 1, level + 1, c, bands, fine);
    const Index half = samples_ >> level;
    L(cascade_, cascade_.reversed_tangents, level == 1 ? samples_ : ring_size,
      last ? half : ring_size, half)
        .backward(last ? c : ring(level), bands + half, level == 1 ? fine : ring(level - 1),
                  done_[level], end - done_[level], c_shift_, d_shift_);
    done_[level] = end;
  }

  const RotationCascade<T>& cascade_;
  const Index samples_;
  T* const rings_;
  Index c_shift_ = 0, d_shift_ = 0;
  Index done_[fused_levels + 1] = {};  ///< of each level, the pairs in front of it are computed
};

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#undef WAVECURVE_BY_SIZE
#define WAVECURVE_BY_SIZE(function, ...) \
  switch (cascade.size()) {              \
    case 1:                              \
      return function<1>(__VA_ARGS__);   \
    case 2:                              \
      return function<2>(__VA_ARGS__);   \
    case 3:                              \
      return function<3>(__VA_ARGS__);   \
    case 4:                              \
      return function<4>(__VA_ARGS__);   \
    case 5:                              \
      return function<5>(__VA_ARGS__);   \
    case 6:                              \
      return function<6>(__VA_ARGS__);   \
    default:                             \
      return function<0>(__VA_ARGS__);   \
  }

#endif
