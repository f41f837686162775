#include "wavecurve/transform/periodic_kernels.hpp"

#include <algorithm>

#include "wavecurve/transform/highway_targets.hpp"
#include "wavecurve/transform/interleave.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/periodic_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Index = Eigen::Index;

/// `sums` vectors of outputs at once: enough independent chains to hide the latency of an addition.
/// Vector i of tap t is at i spacing + t step of u and v.
template <int sums, class D, class T = hn::TFromD<D>>
HWY_INLINE void correlate_vectors(D d, const T* u_weight, const T* v_weight, int taps,
                                  const T* HWY_RESTRICT u, const T* HWY_RESTRICT v, Index step,
                                  Index spacing, T* HWY_RESTRICT out, Index out_spacing) {
  hn::Vec<D> sum[sums];
  for (int i = 0; i < sums; ++i) sum[i] = hn::Zero(d);
  for (int t = 0; t < taps; ++t) {
    const auto weight_of_u = hn::Set(d, u_weight[t]), weight_of_v = hn::Set(d, v_weight[t]);
    for (int i = 0; i < sums; ++i) {
      const Index at = t * step + i * spacing;
      sum[i] = hn::Add(sum[i], hn::Mul(weight_of_u, hn::LoadU(d, u + at)));
      sum[i] = hn::Add(sum[i], hn::Mul(weight_of_v, hn::LoadU(d, v + at)));
    }
  }
  for (int i = 0; i < sums; ++i) hn::StoreU(sum[i], d, out + i * out_spacing);
}

constexpr int sums_at_once = 8;

template <class T>
HWY_INLINE void correlate(const T* u_weight, const T* v_weight, int taps, const T* u, const T* v,
                          Index count, T* out) {
  const hn::ScalableTag<T> d;
  const Index lanes = static_cast<Index>(hn::Lanes(d));
  Index l = 0;
  const auto advance = [&](auto tag, auto sums) {
    const Index spacing = static_cast<Index>(hn::Lanes(tag));
    for (; l + sums * spacing <= count; l += sums * spacing) {
      correlate_vectors<sums>(tag, u_weight, v_weight, taps, u + l, v + l, 1, spacing, out + l,
                              spacing);
    }
  };
  advance(d, std::integral_constant<int, sums_at_once>());
  advance(d, std::integral_constant<int, 1>());
  // The last vector computes some outputs again rather than the rest one by one.
  if (l < count && count >= lanes) {
    l = count - lanes;
    advance(d, std::integral_constant<int, 1>());
  }
  advance(hn::CappedTag<T, 1>(), std::integral_constant<int, 1>());
}

template <class T>
HWY_INLINE void correlate_group(const T* u_weight, const T* v_weight, int taps, const T* u,
                                const T* v, Index in_step, Index count, T* out, Index out_step) {
  const hn::ScalableTag<T> d;
  const Index lanes = static_cast<Index>(hn::Lanes(d));
  for (Index s = 0; s < group_size<T>; s += lanes) {
    Index l = 0;
    const auto advance = [&](auto sums) {
      for (; l + sums <= count; l += sums) {
        correlate_vectors<sums>(d, u_weight, v_weight, taps, u + l * in_step + s,
                                v + l * in_step + s, in_step, in_step, out + l * out_step + s,
                                out_step);
      }
    };
    advance(std::integral_constant<int, sums_at_once>());
    advance(std::integral_constant<int, 1>());
  }
}

template <class T>
HWY_INLINE void split(const T* HWY_RESTRICT in, Index count, T* HWY_RESTRICT even,
                      T* HWY_RESTRICT odd) {
  const hn::ScalableTag<T> d;
  const Index lanes = static_cast<Index>(hn::Lanes(d));
  Index i = 0;
  for (; i + lanes <= count; i += lanes) {
    hn::Vec<decltype(d)> e, o;
    hn::LoadInterleaved2(d, in + 2 * i, e, o);
    hn::StoreU(e, d, even + i);
    hn::StoreU(o, d, odd + i);
  }
  for (; i < count; ++i) {
    even[i] = in[2 * i];
    odd[i] = in[2 * i + 1];
  }
}

template <class T>
HWY_INLINE void merge(const T* HWY_RESTRICT even, const T* HWY_RESTRICT odd, Index count,
                      T* HWY_RESTRICT out) {
  const hn::ScalableTag<T> d;
  const Index lanes = static_cast<Index>(hn::Lanes(d));
  Index i = 0;
  for (; i + lanes <= count; i += lanes) {
    hn::StoreInterleaved2(hn::LoadU(d, even + i), hn::LoadU(d, odd + i), d, out + 2 * i);
  }
  for (; i < count; ++i) {
    out[2 * i] = even[i];
    out[2 * i + 1] = odd[i];
  }
}

#define WAVECURVE_KERNELS(T)                                                                       \
  void correlate_##T(const T* u_weight, const T* v_weight, int taps, const T* u, const T* v,       \
                     Index count, T* out) {                                                        \
    correlate(u_weight, v_weight, taps, u, v, count, out);                                         \
  }                                                                                                \
  void correlate_group_##T(const T* u_weight, const T* v_weight, int taps, const T* u, const T* v, \
                           Index in_step, Index count, T* out, Index out_step) {                   \
    correlate_group(u_weight, v_weight, taps, u, v, in_step, count, out, out_step);                \
  }                                                                                                \
  void split_##T(const T* in, Index count, T* even, T* odd) { split(in, count, even, odd); }       \
  void merge_##T(const T* even, const T* odd, Index count, T* out) { merge(even, odd, count, out); }
WAVECURVE_KERNELS(double)
WAVECURVE_KERNELS(float)
#undef WAVECURVE_KERNELS

}  // namespace wavecurve::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wavecurve {

namespace {

Eigen::Index modulo(Eigen::Index n, Eigen::Index period) {
  const Eigen::Index remainder = n % period;
  return remainder < 0 ? remainder + period : remainder;
}

/// Calls visit(start, first, run) for each stretch without a wrap: places first .. first + run - 1
/// of the window are start .. start + run - 1 of the source.
template <class Visit>
void for_each_run(Eigen::Index period, Eigen::Index begin, Eigen::Index length, Visit visit) {
  Eigen::Index start = modulo(begin, period);
  for (Eigen::Index first = 0; first < length; start = 0) {
    const Eigen::Index run = std::min(length - first, period - start);
    visit(start, first, run);
    first += run;
  }
}

}  // namespace

template <class Scalar>
const Scalar* periodic_window(const Scalar* source, Eigen::Index period, Eigen::Index begin,
                              Eigen::Index length, Scalar* buffer, Eigen::Index row) {
  if (begin >= 0 && begin + length <= period) return source + begin * row;
  for_each_run(period, begin, length,
               [&](Eigen::Index start, Eigen::Index first, Eigen::Index run) {
                 std::copy_n(source + start * row, run * row, buffer + first * row);
               });
  return buffer;
}

#define WAVECURVE_DISPATCH(T)                                                                    \
  HWY_EXPORT(correlate_##T);                                                                     \
  HWY_EXPORT(correlate_group_##T);                                                               \
  HWY_EXPORT(split_##T);                                                                         \
  HWY_EXPORT(merge_##T);                                                                         \
  template <>                                                                                    \
  void correlate_pair(const T* u_weight, const T* v_weight, int taps, const T* u, const T* v,    \
                      Eigen::Index count, T* out) {                                              \
    HWY_DYNAMIC_DISPATCH(correlate_##T)(u_weight, v_weight, taps, u, v, count, out);             \
  }                                                                                              \
  template <>                                                                                    \
  void correlate_pair_of_group(const T* u_weight, const T* v_weight, int taps, const T* u,       \
                               const T* v, Eigen::Index in_step, Eigen::Index count, T* out,     \
                               Eigen::Index out_step) {                                          \
    HWY_DYNAMIC_DISPATCH(correlate_group_##T)                                                    \
    (u_weight, v_weight, taps, u, v, in_step, count, out, out_step);                             \
  }                                                                                              \
  template <>                                                                                    \
  void split_pairs(const T* source, Eigen::Index pairs, Eigen::Index begin, Eigen::Index length, \
                   T* even, T* odd) {                                                            \
    for_each_run(pairs, begin, length,                                                           \
                 [&](Eigen::Index start, Eigen::Index first, Eigen::Index run) {                 \
                   HWY_DYNAMIC_DISPATCH(split_##T)                                               \
                   (source + 2 * start, run, even + first, odd + first);                         \
                 });                                                                             \
  }                                                                                              \
  template <>                                                                                    \
  void merge_pairs(const T* even, const T* odd, Eigen::Index length, T* out) {                   \
    HWY_DYNAMIC_DISPATCH(merge_##T)(even, odd, length, out);                                     \
  }                                                                                              \
  template const T* periodic_window(const T*, Eigen::Index, Eigen::Index, Eigen::Index, T*,      \
                                    Eigen::Index);
WAVECURVE_DISPATCH(double)
WAVECURVE_DISPATCH(float)
#undef WAVECURVE_DISPATCH

}  // namespace wavecurve
#endif
