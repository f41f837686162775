// One level by rotations, compiled again for every instruction set: Highway's way of a header.
#if defined(WAVECURVE_ROTATION_LEVEL) == defined(HWY_TARGET_TOGGLE)
#ifdef WAVECURVE_ROTATION_LEVEL
#undef WAVECURVE_ROTATION_LEVEL
#else
#define WAVECURVE_ROTATION_LEVEL
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

#include <hwy/highway.h>

#include "wavecurve/transform/detail/interleave.hpp"
#include "wavecurve/transform/detail/rotation_cascade.hpp"

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
    if constexpr (K != 1) {  // else GCC 14 warns of the loop that is never entered
      for (int k = 1; k < rotations_.size; ++k) rotations_.held[k] = hn::Zero(d_);
    }
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

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
