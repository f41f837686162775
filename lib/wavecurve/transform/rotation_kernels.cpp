#include "wavecurve/transform/rotation_kernels.hpp"

#include <algorithm>

#include "wavecurve/transform/highway_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/rotation_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "wavecurve/transform/rotation_level-inl.hpp"

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

template <class L, class T>
HWY_INLINE void forward_level(const RotationCascade<T>& cascade, const T* fine, Index half, T* c,
                              T* d) {
  L level(cascade, cascade.tangents, 2 * half, half, half);
  const Index delay = 1 - cascade.size();
  cover<L>(half, [&](Index first, Index count) {
    level.forward(fine, c, d, first, count, delay - cascade.low_first, delay - cascade.high_first);
  });
}

template <class L, class T>
HWY_INLINE void backward_level(const RotationCascade<T>& cascade, const T* c, const T* d,
                               Index half, T* fine) {
  L level(cascade, cascade.reversed_tangents, 2 * half, half, half);
  cover<L>(half, [&](Index first, Index count) {
    level.backward(c, d, fine, first, count, -cascade.low_first, -cascade.high_first);
  });
}

template <int K, class T>
HWY_NOINLINE void forward(const RotationCascade<T>& cascade, const T* fine, Index half, T* c, T* d,
                          Layout layout) {
  using Wide = Level<K, Fill::along, hn::ScalableTag<T>>;
  using Single = Level<K, Fill::one, hn::CappedTag<T, 1>>;
  using Group = Level<K, Fill::across, hn::ScalableTag<T>>;
  if (layout == Layout::interleaved) {
    for (Index s = 0; s < group_size<T>; s += Group::lanes()) {
      forward_level<Group>(cascade, fine + s, half, c + s, d + s);
    }
    return;
  }
  if (half >= Wide::advance()) return forward_level<Wide>(cascade, fine, half, c, d);
  forward_level<Single>(cascade, fine, half, c, d);
}

template <int K, class T>
HWY_NOINLINE void backward(const RotationCascade<T>& cascade, const T* c, const T* d, Index half,
                           T* fine, Layout layout) {
  using Wide = Level<K, Fill::along, hn::ScalableTag<T>>;
  using Single = Level<K, Fill::one, hn::CappedTag<T, 1>>;
  using Group = Level<K, Fill::across, hn::ScalableTag<T>>;
  if (layout == Layout::interleaved) {
    for (Index s = 0; s < group_size<T>; s += Group::lanes()) {
      backward_level<Group>(cascade, c + s, d + s, half, fine + s);
    }
    return;
  }
  if (half >= Wide::advance()) return backward_level<Wide>(cascade, c, d, half, fine);
  backward_level<Single>(cascade, c, d, half, fine);
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

template <int K, class T>
HWY_NOINLINE void forward_chain(const RotationCascade<T>& cascade, const T* fine, Index samples,
                                T* c, T* bands, T* rings) {
  Chain<K, T>(cascade, samples, rings).forward(fine, c, bands);
}

template <int K, class T>
HWY_NOINLINE void backward_chain(const RotationCascade<T>& cascade, const T* c, const T* bands,
                                 Index samples, T* fine, T* rings) {
  Chain<K, T>(cascade, samples, rings).backward(c, bands, fine);
}

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
void forward_double(const RotationCascade<double>& cascade, const double* fine, Index half,
                    double* c, double* d, Layout layout) {
  WAVECURVE_BY_SIZE(forward, cascade, fine, half, c, d, layout)
}
void forward_float(const RotationCascade<float>& cascade, const float* fine, Index half, float* c,
                   float* d, Layout layout) {
  WAVECURVE_BY_SIZE(forward, cascade, fine, half, c, d, layout)
}
void backward_double(const RotationCascade<double>& cascade, const double* c, const double* d,
                     Index half, double* fine, Layout layout) {
  WAVECURVE_BY_SIZE(backward, cascade, c, d, half, fine, layout)
}
void backward_float(const RotationCascade<float>& cascade, const float* c, const float* d,
                    Index half, float* fine, Layout layout) {
  WAVECURVE_BY_SIZE(backward, cascade, c, d, half, fine, layout)
}
void forward_chain_double(const RotationCascade<double>& cascade, const double* fine, Index samples,
                          double* c, double* bands, double* rings) {
  WAVECURVE_BY_SIZE(forward_chain, cascade, fine, samples, c, bands, rings)
}
void backward_chain_double(const RotationCascade<double>& cascade, const double* c,
                           const double* bands, Index samples, double* fine, double* rings) {
  WAVECURVE_BY_SIZE(backward_chain, cascade, c, bands, samples, fine, rings)
}
void forward_chain_float(const RotationCascade<float>& cascade, const float* fine, Index samples,
                         float* c, float* bands, float* rings) {
  WAVECURVE_BY_SIZE(forward_chain, cascade, fine, samples, c, bands, rings)
}
void backward_chain_float(const RotationCascade<float>& cascade, const float* c, const float* bands,
                          Index samples, float* fine, float* rings) {
  WAVECURVE_BY_SIZE(backward_chain, cascade, c, bands, samples, fine, rings)
}
#undef WAVECURVE_BY_SIZE

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve {

HWY_EXPORT(forward_double);
HWY_EXPORT(forward_float);
HWY_EXPORT(backward_double);
HWY_EXPORT(backward_float);

template <>
void rotate_forward(const RotationCascade<double>& cascade, const double* fine, Eigen::Index half,
                    double* c, double* d, Layout layout) {
  HWY_DYNAMIC_DISPATCH(forward_double)(cascade, fine, half, c, d, layout);
}
template <>
void rotate_forward(const RotationCascade<float>& cascade, const float* fine, Eigen::Index half,
                    float* c, float* d, Layout layout) {
  HWY_DYNAMIC_DISPATCH(forward_float)(cascade, fine, half, c, d, layout);
}
template <>
void rotate_backward(const RotationCascade<double>& cascade, const double* c, const double* d,
                     Eigen::Index half, double* fine, Layout layout) {
  HWY_DYNAMIC_DISPATCH(backward_double)(cascade, c, d, half, fine, layout);
}
template <>
void rotate_backward(const RotationCascade<float>& cascade, const float* c, const float* d,
                     Eigen::Index half, float* fine, Layout layout) {
  HWY_DYNAMIC_DISPATCH(backward_float)(cascade, c, d, half, fine, layout);
}

HWY_EXPORT(forward_chain_double);
HWY_EXPORT(backward_chain_double);
template <>
void rotate_forward_fused(const RotationCascade<double>& cascade, const double* fine,
                          Eigen::Index samples, double* c, double* bands, double* rings) {
  HWY_DYNAMIC_DISPATCH(forward_chain_double)(cascade, fine, samples, c, bands, rings);
}
template <>
void rotate_backward_fused(const RotationCascade<double>& cascade, const double* c,
                           const double* bands, Eigen::Index samples, double* fine, double* rings) {
  HWY_DYNAMIC_DISPATCH(backward_chain_double)(cascade, c, bands, samples, fine, rings);
}

HWY_EXPORT(forward_chain_float);
HWY_EXPORT(backward_chain_float);
template <>
void rotate_forward_fused(const RotationCascade<float>& cascade, const float* fine,
                          Eigen::Index samples, float* c, float* bands, float* rings) {
  HWY_DYNAMIC_DISPATCH(forward_chain_float)(cascade, fine, samples, c, bands, rings);
}
template <>
void rotate_backward_fused(const RotationCascade<float>& cascade, const float* c,
                           const float* bands, Eigen::Index samples, float* fine, float* rings) {
  HWY_DYNAMIC_DISPATCH(backward_chain_float)(cascade, c, bands, samples, fine, rings);
}

}  // namespace wavecurve
#endif
