#include "wavecurve/transform/rotation_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include "wavecurve/transform/highway_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/rotation_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Index = Eigen::Index;

/// How a vector is filled. along: with successive pairs of one signal; across: with the same pair
/// of as many signals, whose values alternate in memory; one: a vector of one lane, scalar code.
enum class Fill { along, across, one };

/// (previous, u) seen one pair earlier: along, the last lane of previous and all of u but its last.
template <Fill fill, class D, class V>
HWY_INLINE V delayed([[maybe_unused]] D d, [[maybe_unused]] V u, V previous) {
  using T = hn::TFromD<D>;
  [[maybe_unused]] constexpr std::size_t size = hn::MaxLanes(D()) * sizeof(T);
  if constexpr (fill != Fill::along || hn::MaxLanes(D()) == 1) {
    return previous;
  }
#if HWY_TARGET <= HWY_AVX3 && HWY_ARCH_X86
  else if constexpr (size == 64) {
    const hn::RebindToUnsigned<D> bits;
    using Bits = hn::Vec<decltype(bits)>;
    const auto high = hn::BitCast(bits, u).raw, low = hn::BitCast(bits, previous).raw;
    if constexpr (sizeof(T) == 8) return hn::BitCast(d, Bits{_mm512_alignr_epi64(high, low, 7)});
    if constexpr (sizeof(T) == 4) return hn::BitCast(d, Bits{_mm512_alignr_epi32(high, low, 15)});
  }
#endif
#if HWY_TARGET != HWY_SCALAR
  else {
    // Blocks of 16 bytes: each is shifted in from the block before it.
    V before = previous;
    if constexpr (size == 32) before = hn::ConcatLowerUpper(d, u, previous);
    return hn::CombineShiftRightBytes<16 - sizeof(T)>(d, u, before);
  }
#endif
}

constexpr int max_rotations = RotationCascade<double>::max_size;

HWY_INLINE Index modulo(Index n, Index period) {
  if (n < 0 && n >= -period) return n + period;  // mostly, and without a division
  if (n >= 0 && n < period) return n;
  const Index remainder = n % period;
  return remainder < 0 ? remainder + period : remainder;
}

/// K rotations and what they hold back; K = 0: as many as the cascade has, at most max_rotations.
template <int K, Fill fill, class D>
struct Rotations {
  using V = hn::Vec<D>;

  HWY_INLINE Rotations() {}  // an implicit one would not be compiled for the target

  /// `count` vectors, one behind the other. A rotation of all before the next rotation: neighbours
  /// in the program are independent, so that the processor need not look far ahead.
  template <int count>
  HWY_INLINE void step(V* u, V* v) {
    const int rotations = K == 0 ? size : K;
    for (int k = 0; k < rotations; ++k) {
      for (int i = 0; i < count; ++i) {
        if (k > 0) {
          const V entering = u[i];
          u[i] = delayed<fill>(D(), entering, held[k]);
          held[k] = entering;
        }
        const V rotated = hn::Add(u[i], hn::Mul(tangent[k], v[i]));
        v[i] = hn::Sub(v[i], hn::Mul(tangent[k], u[i]));
        u[i] = rotated;
      }
    }
  }

  int size;
  V tangent[K == 0 ? max_rotations : K], held[K == 0 ? max_rotations : K];
};

/// One level. The samples and the bands are periodic in memory, each with its own period: that of
/// the level, or that of a ring which holds what another level has just written.
template <int K, Fill fill, class D>
class Level {
 public:
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;

  HWY_INLINE Level(const RotationCascade<T>& cascade, const std::vector<T>& tangents,
                   Index fine_period, Index c_period, Index d_period)
      : fine_period_(fine_period),
        c_period_(c_period),
        d_period_(d_period),
        parity_(cascade.parity),
        c_scale_(hn::Set(d_, cascade.low_scale)),
        d_scale_(hn::Set(d_, cascade.high_scale)) {
    rotations_.size = cascade.size();
    for (int k = 0; k < cascade.size(); ++k) {
      rotations_.tangent[k] = hn::Set(d_, tangents[static_cast<std::size_t>(k)]);
    }
  }

  /// The pairs a vector holds: half must not be smaller.
  static HWY_INLINE Index advance() { return fill == Fill::along ? lanes() : 1; }
  static HWY_INLINE Index lanes() { return static_cast<Index>(hn::Lanes(D())); }

  /// The pairs in front of the first, in whole vectors, that fill the delays.
  static HWY_INLINE Index delay(int rotations) {
    return (rotations - 1 + advance() - 1) / advance() * advance();
  }

  /// The output pairs first .. first + count - 1 of the cascade, count a multiple of advance().
  HWY_INLINE void forward(const T* HWY_RESTRICT fine, T* HWY_RESTRICT c, T* HWY_RESTRICT d,
                          Index first, Index count, Index c_shift, Index d_shift) {
    const auto wrapped = [&](const Place& at, bool silent) HWY_ATTR {
      T pairs[2 * copied];
      V u, v;
      load_pairs(copy_in(fine, at.fine, 2 * advance(), fine_period_, pairs), u, v);
      rotations_.template step<1>(&u, &v);
      if (silent) return;
      store_periodic(hn::Mul(u, c_scale_), c, at.c, c_period_);
      store_periodic(hn::Mul(v, d_scale_), d, at.d, d_period_);
    };
    const auto straight = [&](const Place& at, Index pairs, bool silent) HWY_ATTR {
      straight_forward(fine + at.fine * row, c + at.c * row, d + at.d * row, pairs, silent);
    };
    cover(first, count, c_shift, d_shift, wrapped, straight);
  }

  HWY_INLINE void backward(const T* HWY_RESTRICT c, const T* HWY_RESTRICT d, T* HWY_RESTRICT fine,
                           Index first, Index count, Index c_shift, Index d_shift) {
    const auto wrapped = [&](const Place& at, bool silent) HWY_ATTR {
      T c_copy[copied], d_copy[copied], pairs[2 * copied];
      V u = hn::Mul(hn::LoadU(d_, copy_in(d, at.d, advance(), d_period_, d_copy)), d_scale_);
      V v = hn::Mul(hn::LoadU(d_, copy_in(c, at.c, advance(), c_period_, c_copy)), c_scale_);
      rotations_.template step<1>(&u, &v);
      if (silent) return;
      store_pairs(v, u, pairs);
      copy_out(pairs, 2 * advance(), fine, at.fine, fine_period_);
    };
    const auto straight = [&](const Place& at, Index pairs, bool silent) HWY_ATTR {
      straight_backward(c + at.c * row, d + at.d * row, fine + at.fine * row, pairs, silent);
    };
    cover(first, count, c_shift, d_shift, wrapped, straight);
  }

 private:
  /// A copy for the loop, which compilers keep in registers; too large for that where K = 0.
  using InRegisters = std::conditional_t<K == 0, Rotations<K, fill, D>&, Rotations<K, fill, D>>;
  /// Vectors a step takes at once; of many rotations the state alone fills the registers.
  static constexpr int at_once = K == 0 || K > 4 ? 1 : HWY_MAX_BYTES == 64 ? 4 : 2;

  /// Where a vector of pairs is among the samples and in the two bands.
  struct Place {
    Index fine, c, d;
  };

  /// Pairs that lie across no end. Silent ones only fill the delays.
  HWY_INLINE void straight_forward(const T* HWY_RESTRICT in, T* HWY_RESTRICT c, T* HWY_RESTRICT d,
                                   Index pairs, bool silent) {
    InRegisters rotations = rotations_;
    const V c_scale = c_scale_, d_scale = d_scale_;
    Index i = 0;
    for (; !silent && i + at_once * advance() <= pairs; i += at_once * advance()) {
      V u[at_once], v[at_once];
      for (int k = 0; k < at_once; ++k) load_pairs(in + 2 * (i + k * advance()) * row, u[k], v[k]);
      rotations.template step<at_once>(u, v);
      for (int k = 0; k < at_once; ++k) {
        hn::StoreU(hn::Mul(u[k], c_scale), d_, c + (i + k * advance()) * row);
        hn::StoreU(hn::Mul(v[k], d_scale), d_, d + (i + k * advance()) * row);
      }
    }
    for (; i < pairs; i += advance()) {
      V u, v;
      load_pairs(in + 2 * i * row, u, v);
      rotations.template step<1>(&u, &v);
      if (silent) continue;
      hn::StoreU(hn::Mul(u, c_scale), d_, c + i * row);
      hn::StoreU(hn::Mul(v, d_scale), d_, d + i * row);
    }
    rotations_ = rotations;
  }

  HWY_INLINE void straight_backward(const T* HWY_RESTRICT c, const T* HWY_RESTRICT d,
                                    T* HWY_RESTRICT out, Index pairs, bool silent) {
    InRegisters rotations = rotations_;
    const V c_scale = c_scale_, d_scale = d_scale_;
    Index i = 0;
    for (; !silent && i + at_once * advance() <= pairs; i += at_once * advance()) {
      V u[at_once], v[at_once];
      for (int k = 0; k < at_once; ++k) {
        u[k] = hn::Mul(hn::LoadU(d_, d + (i + k * advance()) * row), d_scale);
        v[k] = hn::Mul(hn::LoadU(d_, c + (i + k * advance()) * row), c_scale);
      }
      rotations.template step<at_once>(u, v);
      for (int k = 0; k < at_once; ++k) {
        store_pairs(v[k], u[k], out + 2 * (i + k * advance()) * row);
      }
    }
    for (; i < pairs; i += advance()) {
      V u = hn::Mul(hn::LoadU(d_, d + i * row), d_scale);
      V v = hn::Mul(hn::LoadU(d_, c + i * row), c_scale);
      rotations.template step<1>(&u, &v);
      if (!silent) store_pairs(v, u, out + 2 * i * row);
    }
    rotations_ = rotations;
  }

  /// Takes the pairs up to first + count - 1, from those that fill the delays on (silent), through
  /// wrapped(place, silent), a vector of which a part lies across an end, or straight(place, pairs,
  /// silent).
  template <class Wrapped, class Straight>
  HWY_INLINE void cover(Index first, Index count, Index c_shift, Index d_shift, Wrapped wrapped,
                        Straight straight) {
    for (int k = 1; k < rotations_.size; ++k) rotations_.held[k] = hn::Zero(d_);
    const Index before = delay(rotations_.size);
    first -= before;
    Place at{modulo(2 * first + parity_, fine_period_), modulo(first + c_shift, c_period_),
             modulo(first + d_shift, d_period_)};
    for (Index left = before + count, pairs; left > 0; left -= pairs) {
      const bool silent = left > count;
      pairs = whole(std::min({silent ? left - count : left, (fine_period_ - at.fine) / 2,
                              c_period_ - at.c, d_period_ - at.d}));
      if (pairs > 0) {
        straight(at, pairs, silent);
      } else {
        pairs = advance();
        wrapped(at, silent);
      }
      at = {wrap(at.fine + 2 * pairs, fine_period_), wrap(at.c + pairs, c_period_),
            wrap(at.d + pairs, d_period_)};
    }
  }

  /// Values from one sample to the next.
  static constexpr Index row = fill == Fill::across ? group_size<T> : 1;
  static constexpr Index max_lanes = static_cast<Index>(hn::MaxLanes(D()));
  static constexpr Index copied = std::max(row, max_lanes);
  /// Neighbours in memory of one sample.
  static HWY_INLINE Index run() { return fill == Fill::across ? lanes() : 1; }
  static HWY_INLINE Index whole(Index pairs) { return pairs / advance() * advance(); }
  static HWY_INLINE Index wrap(Index n, Index period) { return n < period ? n : n - period; }

  HWY_INLINE void load_pairs(const T* HWY_RESTRICT in, V& u, V& v) {
    if constexpr (fill != Fill::along) {
      u = hn::LoadU(d_, in);
      v = hn::LoadU(d_, in + row);
    } else {
      hn::LoadInterleaved2(d_, in, u, v);
    }
  }
  HWY_INLINE void store_pairs(V u, V v, T* HWY_RESTRICT out) {
    if constexpr (fill != Fill::along) {
      hn::StoreU(u, d_, out);
      hn::StoreU(v, d_, out + row);
    } else {
      hn::StoreInterleaved2(u, v, d_, out);
    }
  }

  /// `count` values from `at` on, those beyond the period from its beginning.
  static HWY_INLINE const T* copy_in(const T* source, Index at, Index count, Index period,
                                     T* copy) {
    if (at + count <= period) return source + at * row;
    for (Index j = 0; j < count; ++j) {
      std::copy_n(source + wrap(at + j, period) * row, run(), copy + j * row);
    }
    return copy;
  }
  static HWY_INLINE void copy_out(const T* values, Index count, T* target, Index at, Index period) {
    for (Index j = 0; j < count; ++j) {
      std::copy_n(values + j * row, run(), target + wrap(at + j, period) * row);
    }
  }
  HWY_INLINE void store_periodic(V values, T* target, Index at, Index period) {
    T copy[copied];
    hn::StoreU(values, d_, copy);
    copy_out(copy, advance(), target, at, period);
  }

  const D d_;
  const Index fine_period_, c_period_, d_period_, parity_;
  const V c_scale_, d_scale_;
  Rotations<K, fill, D> rotations_;
};

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
