#include "wavecurve/transform/detail/interleave.hpp"

#include <array>

#include "wavecurve/elementary/detail/highway_targets.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/detail/interleave.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Index = Eigen::Index;

/// The signals of a group by their first values; missing ones are the first again.
template <class T>
HWY_INLINE std::array<T*, group_size<std::remove_const_t<T>>> signal_pointers(T* signals,
                                                                              Index outer,
                                                                              Index count) {
  std::array<T*, group_size<std::remove_const_t<T>>> pointers;
  for (Index s = 0; s < static_cast<Index>(pointers.size()); ++s) {
    pointers[static_cast<std::size_t>(s)] = signals + (s < count ? s * outer : 0);
  }
  return pointers;
}

#if HWY_TARGET != HWY_SCALAR
/// Two blocks of 16 bytes at most: wider ones take more shuffles a value.
template <class T>
using SquareTag = hn::CappedTag<T, 32 / sizeof(T)>;
template <class T>
constexpr Index side = static_cast<Index>(hn::MaxLanes(SquareTag<T>()));

/// Transposes, in each block of 16 bytes, the square that as many vectors hold.
template <class D, class V>
HWY_INLINE void transpose_blocks(D d, V* v) {
  if constexpr (sizeof(hn::TFromD<D>) == 8) {
    const V low = hn::InterleaveLower(d, v[0], v[1]);
    v[1] = hn::InterleaveUpper(d, v[0], v[1]);
    v[0] = low;
  } else {
    const V even_low = hn::InterleaveLower(d, v[0], v[2]);
    const V even_high = hn::InterleaveUpper(d, v[0], v[2]);
    const V odd_low = hn::InterleaveLower(d, v[1], v[3]);
    const V odd_high = hn::InterleaveUpper(d, v[1], v[3]);
    v[0] = hn::InterleaveLower(d, even_low, odd_low);
    v[1] = hn::InterleaveUpper(d, even_low, odd_low);
    v[2] = hn::InterleaveLower(d, even_high, odd_high);
    v[3] = hn::InterleaveUpper(d, even_high, odd_high);
  }
}

/// Transposes the square that `side` vectors hold.
template <class D, class V>
HWY_INLINE void transpose(D d, V* v) {
  constexpr Index block = 16 / sizeof(hn::TFromD<D>);
  transpose_blocks(d, v);
  if constexpr (hn::MaxLanes(D()) > block) {
    transpose_blocks(d, v + block);
    for (Index i = 0; i < block; ++i) {
      const V low = hn::ConcatLowerLower(d, v[i + block], v[i]);
      v[i + block] = hn::ConcatUpperUpper(d, v[i + block], v[i]);
      v[i] = low;
    }
  }
}
#endif

template <class T>
HWY_INLINE void interleave_signals(const T* signals, Index inner, Index outer, Index count,
                                   Index samples, T* HWY_RESTRICT group) {
  const auto pointers = signal_pointers(signals, outer, count);
  Index n = 0;
#if HWY_TARGET != HWY_SCALAR
  const SquareTag<T> d;
  for (; inner == 1 && n + side<T> <= samples; n += side<T>) {
    for (Index s = 0; s < group_size<T>; s += side<T>) {
      hn::Vec<SquareTag<T>> v[side<T>];
      for (Index i = 0; i < side<T>; ++i) {
        v[i] = hn::LoadU(d, pointers[static_cast<std::size_t>(s + i)] + n);
      }
      transpose(d, v);
      for (Index i = 0; i < side<T>; ++i) hn::StoreU(v[i], d, group + (n + i) * group_size<T> + s);
    }
  }
#endif
  for (; n < samples; ++n) {
    T* const row = group + n * group_size<T>;
    for (std::size_t s = 0; s < pointers.size(); ++s) row[s] = pointers[s][n * inner];
  }
}

template <class T>
HWY_INLINE void separate_signals(const T* HWY_RESTRICT group, Index samples, T* signals,
                                 Index inner, Index outer, Index count) {
  const auto pointers = signal_pointers(signals, outer, count);
  Index n = 0;
#if HWY_TARGET != HWY_SCALAR
  const SquareTag<T> d;
  for (; inner == 1 && n + side<T> <= samples; n += side<T>) {
    for (Index s = 0; s < group_size<T>; s += side<T>) {
      hn::Vec<SquareTag<T>> v[side<T>];
      for (Index i = 0; i < side<T>; ++i) {
        v[i] = hn::LoadU(d, group + (n + i) * group_size<T> + s);
      }
      transpose(d, v);
      for (Index i = 0; i < side<T>; ++i) {
        hn::StoreU(v[i], d, pointers[static_cast<std::size_t>(s + i)] + n);
      }
    }
  }
#endif
  for (; n < samples; ++n) {
    const T* const row = group + n * group_size<T>;
    for (std::size_t s = 0; s < pointers.size(); ++s) pointers[s][n * inner] = row[s];
  }
}

void interleave_double(const double* signals, Index inner, Index outer, Index count, Index samples,
                       double* group) {
  interleave_signals(signals, inner, outer, count, samples, group);
}
void interleave_float(const float* signals, Index inner, Index outer, Index count, Index samples,
                      float* group) {
  interleave_signals(signals, inner, outer, count, samples, group);
}
void separate_double(const double* group, Index samples, double* signals, Index inner, Index outer,
                     Index count) {
  separate_signals(group, samples, signals, inner, outer, count);
}
void separate_float(const float* group, Index samples, float* signals, Index inner, Index outer,
                    Index count) {
  separate_signals(group, samples, signals, inner, outer, count);
}

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve {

HWY_EXPORT(interleave_double);
HWY_EXPORT(interleave_float);
HWY_EXPORT(separate_double);
HWY_EXPORT(separate_float);

template <>
void interleave(const double* signals, Eigen::Index inner, Eigen::Index outer, Eigen::Index count,
                Eigen::Index samples, double* group) {
  HWY_DYNAMIC_DISPATCH(interleave_double)(signals, inner, outer, count, samples, group);
}
template <>
void interleave(const float* signals, Eigen::Index inner, Eigen::Index outer, Eigen::Index count,
                Eigen::Index samples, float* group) {
  HWY_DYNAMIC_DISPATCH(interleave_float)(signals, inner, outer, count, samples, group);
}
template <>
void separate(const double* group, Eigen::Index samples, double* signals, Eigen::Index inner,
              Eigen::Index outer, Eigen::Index count) {
  HWY_DYNAMIC_DISPATCH(separate_double)(group, samples, signals, inner, outer, count);
}
template <>
void separate(const float* group, Eigen::Index samples, float* signals, Eigen::Index inner,
              Eigen::Index outer, Eigen::Index count) {
  HWY_DYNAMIC_DISPATCH(separate_float)(group, samples, signals, inner, outer, count);
}

}  // namespace wavecurve
#endif
