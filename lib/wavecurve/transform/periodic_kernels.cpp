#include "wavecurve/transform/periodic_kernels.hpp"

#include <algorithm>

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
void correlate_pair(const Scalar* u_weight, const Scalar* v_weight, int taps, const Scalar* u,
                    const Scalar* v, Eigen::Index count, Scalar* out) {
  // Eight 16-byte registers of sums: enough independent chains to hide the latency of an addition.
  // Named one by one, since compilers keep a loop-carried array of them in memory.
  constexpr int width = 16 / sizeof(Scalar);
  using Lane = Eigen::Array<Scalar, width, 1>;
  const auto lane = [](const Scalar* values, int i) {
    return Eigen::Map<const Lane>(values + i * width);
  };
  Eigen::Index l = 0;
  for (; l + 8 * width <= count; l += 8 * width) {
    Lane s0 = Lane::Zero(), s1 = s0, s2 = s0, s3 = s0, s4 = s0, s5 = s0, s6 = s0, s7 = s0;
    const auto add = [&](Scalar weight, const Scalar* values) {
      s0 += weight * lane(values, 0);
      s1 += weight * lane(values, 1);
      s2 += weight * lane(values, 2);
      s3 += weight * lane(values, 3);
      s4 += weight * lane(values, 4);
      s5 += weight * lane(values, 5);
      s6 += weight * lane(values, 6);
      s7 += weight * lane(values, 7);
    };
    for (int t = 0; t < taps; ++t) {
      add(u_weight[t], u + l + t);
      add(v_weight[t], v + l + t);
    }
    int i = 0;
    for (const Lane* s : {&s0, &s1, &s2, &s3, &s4, &s5, &s6, &s7}) {
      Eigen::Map<Lane>(out + l + width * i++) = *s;
    }
  }
  for (; l < count; ++l) {
    Scalar sum(0);
    for (int t = 0; t < taps; ++t) {
      sum += u_weight[t] * u[l + t];
      sum += v_weight[t] * v[l + t];
    }
    out[l] = sum;
  }
}

template <class Scalar>
const Scalar* periodic_window(const Scalar* source, Eigen::Index period, Eigen::Index begin,
                              Eigen::Index length, Scalar* buffer) {
  if (begin >= 0 && begin + length <= period) return source + begin;
  for_each_run(period, begin, length,
               [&](Eigen::Index start, Eigen::Index first, Eigen::Index run) {
                 std::copy_n(source + start, run, buffer + first);
               });
  return buffer;
}

template <class Scalar>
void split_pairs(const Scalar* source, Eigen::Index pairs, Eigen::Index begin, Eigen::Index length,
                 Scalar* even, Scalar* odd) {
  for_each_run(pairs, begin, length, [&](Eigen::Index start, Eigen::Index first, Eigen::Index run) {
    const Scalar* in = source + 2 * start;
    for (Eigen::Index i = 0; i < run; ++i) {
      even[first + i] = in[2 * i];
      odd[first + i] = in[2 * i + 1];
    }
  });
}

template <class Scalar>
void merge_pairs(const Scalar* even, const Scalar* odd, Eigen::Index length, Scalar* out) {
  for (Eigen::Index i = 0; i < length; ++i) {
    out[2 * i] = even[i];
    out[2 * i + 1] = odd[i];
  }
}

#define WAVECURVE_INSTANTIATE(Scalar)                                                             \
  template void correlate_pair(const Scalar*, const Scalar*, int, const Scalar*, const Scalar*,   \
                               Eigen::Index, Scalar*);                                            \
  template const Scalar* periodic_window(const Scalar*, Eigen::Index, Eigen::Index, Eigen::Index, \
                                         Scalar*);                                                \
  template void split_pairs(const Scalar*, Eigen::Index, Eigen::Index, Eigen::Index, Scalar*,     \
                            Scalar*);                                                             \
  template void merge_pairs(const Scalar*, const Scalar*, Eigen::Index, Scalar*);
WAVECURVE_INSTANTIATE(double)
WAVECURVE_INSTANTIATE(float)
#undef WAVECURVE_INSTANTIATE

}  // namespace wavecurve
