#include "wavecurve/transform/detail/periodic_kernels.hpp"

#include <algorithm>

#include "wavecurve/elementary/detail/highway_targets.hpp"
#include "wavecurve/transform/detail/interleave.hpp"
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "wavecurve/transform/detail/periodic_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace wavecurve::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Index = Eigen::Index;

/// `at_once` vectors of each output: enough independent chains to hide the latency of an addition,
/// and each vector of inputs is loaded once for both outputs. Vector i of tap t is at
/// i spacing + t step of u and v.
template <int at_once, class D, class T, class Store>
HWY_INLINE void correlate_vectors(D d, const PolyphaseTaps<T>& taps, const T* HWY_RESTRICT u,
                                  const T* HWY_RESTRICT v, Index step, Index spacing, Store store) {
  using V = hn::Vec<D>;
  V p[at_once], q[at_once], values[at_once];
  for (int i = 0; i < at_once; ++i) p[i] = q[i] = hn::Zero(d);
  const auto load = [&](const T* at) HWY_ATTR {
    for (int i = 0; i < at_once; ++i) values[i] = hn::LoadU(d, at + i * spacing);
  };
  const auto add = [&](const auto& weight, V* sum) HWY_ATTR {
    if (weight.zero) return;
    for (int i = 0; i < at_once; ++i) {
      sum[i] = hn::Add(sum[i], hn::Mul(hn::Set(d, weight.value), values[i]));
    }
  };
  for (const PolyphaseTap<T>& tap : taps) {
    load(u);
    add(tap.p_of_u, p);
    add(tap.q_of_u, q);
    load(v);
    add(tap.p_of_v, p);
    add(tap.q_of_v, q);
    u += step;
    v += step;
  }
  for (int i = 0; i < at_once; ++i) store(p[i], q[i], i);
}

constexpr int most_at_once = HWY_MAX_BYTES == 64 ? 8 : 4;

/// store(d, p, q, l) takes vectors of outputs from the l-th on.
template <class T, class Store>
HWY_INLINE void correlate(const PolyphaseTaps<T>& taps, const T* u, const T* v, Index count,
                          Store store) {
  const hn::ScalableTag<T> d;
  const Index lanes = static_cast<Index>(hn::Lanes(d));
  Index l = 0;
  const auto advance = [&](auto tag, auto at_once) HWY_ATTR {
    const Index spacing = static_cast<Index>(hn::Lanes(tag));
    for (; l + at_once * spacing <= count; l += at_once * spacing) {
      correlate_vectors<at_once>(tag, taps, u + l, v + l, 1, spacing,
                                 [&](auto p, auto q, int i)
                                     HWY_ATTR { store(tag, p, q, l + i * spacing); });
    }
  };
  advance(d, std::integral_constant<int, most_at_once>());
  advance(d, std::integral_constant<int, 1>());
  // The last vector computes some outputs again rather than the rest one by one.
  if (l < count && count >= lanes) {
    l = count - lanes;
    advance(d, std::integral_constant<int, 1>());
  }
  advance(hn::CappedTag<T, 1>(), std::integral_constant<int, 1>());
}

template <class T>
HWY_INLINE void correlate_apart(const PolyphaseTaps<T>& taps, const T* u, const T* v, Index count,
                                T* HWY_RESTRICT p_out, T* HWY_RESTRICT q_out) {
  correlate(taps, u, v, count, [&](auto d, auto p, auto q, Index l) HWY_ATTR {
    hn::StoreU(p, d, p_out + l);
    hn::StoreU(q, d, q_out + l);
  });
}

template <class T>
HWY_INLINE void correlate_merged(const PolyphaseTaps<T>& taps, const T* u, const T* v, Index count,
                                 T* HWY_RESTRICT out) {
  correlate(taps, u, v, count, [&](auto d, auto p, auto q, Index l) HWY_ATTR {
    if constexpr (hn::MaxLanes(decltype(d)()) == 1) {
      hn::StoreU(p, d, out + 2 * l);
      hn::StoreU(q, d, out + 2 * l + 1);
    } else {
      hn::StoreInterleaved2(p, q, d, out + 2 * l);
    }
  });
}

template <class T>
HWY_INLINE void correlate_group(const PolyphaseTaps<T>& taps, const T* u, const T* v, Index in_step,
                                Index count, T* p_out, T* q_out, Index out_step) {
  const hn::ScalableTag<T> d;
  const Index lanes = static_cast<Index>(hn::Lanes(d));
  for (Index s = 0; s < group_size<T>; s += lanes) {
    Index l = 0;
    const auto advance = [&](auto at_once) HWY_ATTR {
      for (; l + at_once <= count; l += at_once) {
        const Index in = l * in_step + s, out = l * out_step + s;
        correlate_vectors<at_once>(d, taps, u + in, v + in, in_step, in_step,
                                   [&](auto p, auto q, int i) HWY_ATTR {
                                     hn::StoreU(p, d, p_out + out + i * out_step);
                                     hn::StoreU(q, d, q_out + out + i * out_step);
                                   });
      }
    };
    advance(std::integral_constant<int, most_at_once>());
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

#define WAVECURVE_KERNELS(T)                                                                    \
  void correlate_##T(const PolyphaseTaps<T>& taps, const T* u, const T* v, Index count, T* p,   \
                     T* q) {                                                                    \
    correlate_apart(taps, u, v, count, p, q);                                                   \
  }                                                                                             \
  void correlate_merged_##T(const PolyphaseTaps<T>& taps, const T* u, const T* v, Index count,  \
                            T* out) {                                                           \
    correlate_merged(taps, u, v, count, out);                                                   \
  }                                                                                             \
  void correlate_group_##T(const PolyphaseTaps<T>& taps, const T* u, const T* v, Index in_step, \
                           Index count, T* p, T* q, Index out_step) {                           \
    correlate_group(taps, u, v, in_step, count, p, q, out_step);                                \
  }                                                                                             \
  void split_##T(const T* in, Index count, T* even, T* odd) { split(in, count, even, odd); }
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
  HWY_EXPORT(correlate_merged_##T);                                                              \
  HWY_EXPORT(correlate_group_##T);                                                               \
  HWY_EXPORT(split_##T);                                                                         \
  template <>                                                                                    \
  void correlate_pair(const PolyphaseTaps<T>& taps, const T* u, const T* v, Eigen::Index count,  \
                      T* p, T* q) {                                                              \
    HWY_DYNAMIC_DISPATCH(correlate_##T)(taps, u, v, count, p, q);                                \
  }                                                                                              \
  template <>                                                                                    \
  void correlate_pair_merged(const PolyphaseTaps<T>& taps, const T* u, const T* v,               \
                             Eigen::Index count, T* out) {                                       \
    HWY_DYNAMIC_DISPATCH(correlate_merged_##T)(taps, u, v, count, out);                          \
  }                                                                                              \
  template <>                                                                                    \
  void correlate_pair_of_group(const PolyphaseTaps<T>& taps, const T* u, const T* v,             \
                               Eigen::Index in_step, Eigen::Index count, T* p, T* q,             \
                               Eigen::Index out_step) {                                          \
    HWY_DYNAMIC_DISPATCH(correlate_group_##T)(taps, u, v, in_step, count, p, q, out_step);       \
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
  template const T* periodic_window(const T*, Eigen::Index, Eigen::Index, Eigen::Index, T*,      \
                                    Eigen::Index);
WAVECURVE_DISPATCH(double)
WAVECURVE_DISPATCH(float)
#undef WAVECURVE_DISPATCH

}  // namespace wavecurve
#endif
