#include "wavecurve/transform/rotation_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>

// Instruction sets that no kernel is built for. SVE and RVV: vectors without a size known to the
// compiler could not be members of an array; such processors run the baseline kernels. SSSE3: so do
// the processors that stop short of SSE4 (scalar code, with Highway 1.0).
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/rotation_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Index = Eigen::Index;

/// How a vector is filled. along: with successive pairs of one signal; across: with the same pair
/// of as many signals, whose values alternate in memory. One lane across is plain scalar code.
enum class Fill { along, across };

/// (previous, u) seen one pair earlier: along, the last lane of previous and all of u but its last.
template <Fill fill, class D, class V>
HWY_INLINE V delayed([[maybe_unused]] D d, [[maybe_unused]] V u, V previous) {
  using T = hn::TFromD<D>;
  [[maybe_unused]] constexpr std::size_t size = hn::MaxLanes(D()) * sizeof(T);
  if constexpr (fill == Fill::across || hn::MaxLanes(D()) == 1) {
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
  const Index remainder = n % period;
  return remainder < 0 ? remainder + period : remainder;
}

/// K rotations and what they hold back; K = 0: as many as the cascade has, at most max_rotations.
template <int K, Fill fill, class D>
struct Rotations {
  using V = hn::Vec<D>;

  HWY_INLINE void step(V& u, V& v) {
    const int count = K == 0 ? size : K;
    for (int k = 0; k < count; ++k) {
      if (k > 0) {
        const V entering = u;
        u = delayed<fill>(D(), entering, held[k]);
        held[k] = entering;
      }
      const V rotated = hn::Add(u, hn::Mul(tangent[k], v));
      v = hn::Sub(v, hn::Mul(tangent[k], u));
      u = rotated;
    }
  }

  int size;
  V tangent[K == 0 ? max_rotations : K], held[K == 0 ? max_rotations : K];
};

/// One level.
template <int K, Fill fill, class D>
class Level {
 public:
  using T = hn::TFromD<D>;
  using V = hn::Vec<D>;

  HWY_INLINE Level(const RotationCascade<T>& cascade, const std::vector<T>& tangents, Index half)
      : half_(half),
        parity_(cascade.parity),
        c_scale_(hn::Set(d_, cascade.low_scale)),
        d_scale_(hn::Set(d_, cascade.high_scale)) {
    rotations_.size = cascade.size();
    for (int k = 0; k < cascade.size(); ++k) {
      rotations_.tangent[k] = hn::Set(d_, tangents[static_cast<std::size_t>(k)]);
    }
  }

  /// The pairs a vector holds: half must not be smaller.
  static HWY_INLINE Index advance() { return fill == Fill::across ? 1 : lanes(); }

  /// The output pairs first .. first + count - 1 of the cascade, count a multiple of advance().
  HWY_INLINE void forward(const T* HWY_RESTRICT fine, T* HWY_RESTRICT c, T* HWY_RESTRICT d,
                          Index first, Index count, Index c_shift, Index d_shift) {
    Index left = start(first, count);
    Index n = modulo(first_ + c_shift, half_), m = modulo(first_ + d_shift, half_);
    Index at = modulo(2 * first_ + parity_, 2 * half_);
    V u, v;
    const auto advance_by = [&](Index pairs) {
      left -= pairs;
      n = wrap(n + pairs, half_);
      m = wrap(m + pairs, half_);
      at = wrap(at + 2 * pairs, 2 * half_);
    };
    while (left > 0) {
      const Index plain = whole(std::min({left, (2 * half_ - at) / 2, half_ - n, half_ - m}));
      if (plain == 0 || left > count) {
        T pairs[2 * max_lanes];
        load_pairs(copy_in(fine, at, 2 * advance(), 2 * half_, pairs), u, v);
        rotations_.step(u, v);
        if (left <= count) {
          store_periodic(hn::Mul(u, c_scale_), c, n);
          store_periodic(hn::Mul(v, d_scale_), d, m);
        }
        advance_by(advance());
        continue;
      }
      const T* HWY_RESTRICT in = fine + at * width();
      T* HWY_RESTRICT c_out = c + n * width();
      T* HWY_RESTRICT d_out = d + m * width();
      InRegisters rotations = rotations_;
      const V c_scale = c_scale_, d_scale = d_scale_;
      for (Index i = 0; i < plain * width(); i += lanes()) {
        load_pairs(in + 2 * i, u, v);
        rotations.step(u, v);
        hn::StoreU(hn::Mul(u, c_scale), d_, c_out + i);
        hn::StoreU(hn::Mul(v, d_scale), d_, d_out + i);
      }
      rotations_ = rotations;
      advance_by(plain);
    }
  }

  HWY_INLINE void backward(const T* HWY_RESTRICT c, const T* HWY_RESTRICT d, T* HWY_RESTRICT fine,
                           Index first, Index count, Index c_shift, Index d_shift) {
    Index left = start(first, count);
    Index n = modulo(first_ + c_shift, half_), m = modulo(first_ + d_shift, half_);
    Index at = modulo(2 * first_ + parity_, 2 * half_);
    const auto advance_by = [&](Index pairs) {
      left -= pairs;
      n = wrap(n + pairs, half_);
      m = wrap(m + pairs, half_);
      at = wrap(at + 2 * pairs, 2 * half_);
    };
    while (left > 0) {
      const Index plain = whole(std::min({left, (2 * half_ - at) / 2, half_ - n, half_ - m}));
      if (plain == 0 || left > count) {
        T c_copy[max_lanes], d_copy[max_lanes], pairs[2 * max_lanes];
        V u = hn::Mul(hn::LoadU(d_, copy_in(d, m, advance(), half_, d_copy)), d_scale_);
        V v = hn::Mul(hn::LoadU(d_, copy_in(c, n, advance(), half_, c_copy)), c_scale_);
        rotations_.step(u, v);
        if (left <= count) {
          store_pairs(v, u, pairs);
          copy_out(pairs, 2 * advance(), fine, at, 2 * half_);
        }
        advance_by(advance());
        continue;
      }
      const T* HWY_RESTRICT c_in = c + n * width();
      const T* HWY_RESTRICT d_in = d + m * width();
      T* HWY_RESTRICT out = fine + at * width();
      InRegisters rotations = rotations_;
      const V c_scale = c_scale_, d_scale = d_scale_;
      for (Index i = 0; i < plain * width(); i += lanes()) {
        V u = hn::Mul(hn::LoadU(d_, d_in + i), d_scale);
        V v = hn::Mul(hn::LoadU(d_, c_in + i), c_scale);
        rotations.step(u, v);
        store_pairs(v, u, out + 2 * i);
      }
      rotations_ = rotations;
      advance_by(plain);
    }
  }

 private:
  /// A copy for the loop, which compilers keep in registers; too large for that where K = 0.
  using InRegisters = std::conditional_t<K == 0, Rotations<K, fill, D>&, Rotations<K, fill, D>>;
  static constexpr Index max_lanes = static_cast<Index>(hn::MaxLanes(D()));
  static HWY_INLINE Index lanes() { return static_cast<Index>(hn::Lanes(D())); }
  static HWY_INLINE Index width() { return fill == Fill::across ? lanes() : 1; }
  static HWY_INLINE Index whole(Index pairs) { return pairs / advance() * advance(); }
  static HWY_INLINE Index wrap(Index n, Index period) { return n < period ? n : n - period; }

  /// Forgets what went before: the vectors in front of `first` fill the delays.
  HWY_INLINE Index start(Index first, Index count) {
    for (int k = 1; k < rotations_.size; ++k) rotations_.held[k] = hn::Zero(d_);
    const Index before = (rotations_.size - 1 + advance() - 1) / advance() * advance();
    first_ = first - before;
    return before + count;
  }

  HWY_INLINE void load_pairs(const T* HWY_RESTRICT in, V& u, V& v) {
    if constexpr (fill == Fill::across) {
      u = hn::LoadU(d_, in);
      v = hn::LoadU(d_, in + lanes());
    } else {
      hn::LoadInterleaved2(d_, in, u, v);
    }
  }
  HWY_INLINE void store_pairs(V u, V v, T* HWY_RESTRICT out) {
    if constexpr (fill == Fill::across) {
      hn::StoreU(u, d_, out);
      hn::StoreU(v, d_, out + lanes());
    } else {
      hn::StoreInterleaved2(u, v, d_, out);
    }
  }

  /// `count` values from `at` on, those beyond the period from its beginning.
  static HWY_INLINE const T* copy_in(const T* source, Index at, Index count, Index period,
                                     T* copy) {
    if (at + count <= period) return source + at * width();
    for (Index j = 0; j < count; ++j) {
      std::copy_n(source + wrap(at + j, period) * width(), width(), copy + j * width());
    }
    return copy;
  }
  static HWY_INLINE void copy_out(const T* values, Index count, T* target, Index at, Index period) {
    for (Index j = 0; j < count; ++j) {
      std::copy_n(values + j * width(), width(), target + wrap(at + j, period) * width());
    }
  }
  HWY_INLINE void store_periodic(V values, T* target, Index at) {
    T copy[max_lanes];
    hn::StoreU(values, d_, copy);
    copy_out(copy, advance(), target, at, half_);
  }

  const D d_;
  const Index half_, parity_;
  const V c_scale_, d_scale_;
  Rotations<K, fill, D> rotations_;
  Index first_ = 0;
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
  L level(cascade, cascade.tangents, half);
  const Index delay = 1 - cascade.size();
  cover<L>(half, [&](Index first, Index count) {
    level.forward(fine, c, d, first, count, delay - cascade.low_first, delay - cascade.high_first);
  });
}

template <class L, class T>
HWY_INLINE void backward_level(const RotationCascade<T>& cascade, const T* c, const T* d,
                               Index half, T* fine) {
  L level(cascade, cascade.reversed_tangents, half);
  cover<L>(half, [&](Index first, Index count) {
    level.backward(c, d, fine, first, count, -cascade.low_first, -cascade.high_first);
  });
}

template <int K, class T>
HWY_NOINLINE void forward(const RotationCascade<T>& cascade, const T* fine, Index half, T* c,
                          T* d) {
  using Wide = Level<K, Fill::along, hn::ScalableTag<T>>;
  using Single = Level<K, Fill::across, hn::CappedTag<T, 1>>;
  if (half >= Wide::advance()) return forward_level<Wide>(cascade, fine, half, c, d);
  forward_level<Single>(cascade, fine, half, c, d);
}

template <int K, class T>
HWY_NOINLINE void backward(const RotationCascade<T>& cascade, const T* c, const T* d, Index half,
                           T* fine) {
  using Wide = Level<K, Fill::along, hn::ScalableTag<T>>;
  using Single = Level<K, Fill::across, hn::CappedTag<T, 1>>;
  if (half >= Wide::advance()) return backward_level<Wide>(cascade, c, d, half, fine);
  backward_level<Single>(cascade, c, d, half, fine);
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
                    double* c, double* d) {
  WAVECURVE_BY_SIZE(forward, cascade, fine, half, c, d)
}
void forward_float(const RotationCascade<float>& cascade, const float* fine, Index half, float* c,
                   float* d) {
  WAVECURVE_BY_SIZE(forward, cascade, fine, half, c, d)
}
void backward_double(const RotationCascade<double>& cascade, const double* c, const double* d,
                     Index half, double* fine) {
  WAVECURVE_BY_SIZE(backward, cascade, c, d, half, fine)
}
void backward_float(const RotationCascade<float>& cascade, const float* c, const float* d,
                    Index half, float* fine) {
  WAVECURVE_BY_SIZE(backward, cascade, c, d, half, fine)
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
                    double* c, double* d) {
  HWY_DYNAMIC_DISPATCH(forward_double)(cascade, fine, half, c, d);
}
template <>
void rotate_forward(const RotationCascade<float>& cascade, const float* fine, Eigen::Index half,
                    float* c, float* d) {
  HWY_DYNAMIC_DISPATCH(forward_float)(cascade, fine, half, c, d);
}
template <>
void rotate_backward(const RotationCascade<double>& cascade, const double* c, const double* d,
                     Eigen::Index half, double* fine) {
  HWY_DYNAMIC_DISPATCH(backward_double)(cascade, c, d, half, fine);
}
template <>
void rotate_backward(const RotationCascade<float>& cascade, const float* c, const float* d,
                     Eigen::Index half, float* fine) {
  HWY_DYNAMIC_DISPATCH(backward_float)(cascade, c, d, half, fine);
}

}  // namespace wavecurve
#endif
