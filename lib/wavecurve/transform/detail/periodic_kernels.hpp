#pragma once

#include <vector>

#include <Eigen/Core>

/// The loops that every periodic filter runs through, vectorised for the processor at hand. None
/// allocates; all work on raw pointers, since they are called a block at a time. Additions and
/// multiplications are never fused and come in the order of the formula: all processors give the
/// same bits, and so do single and interleaved signals (see Layout).
namespace wavecurve {

/// The weights of one tap t of both outputs of correlate_pair. Zeros, which fill up the shorter
/// filter, are skipped; asked for once, not in the loop.
template <class Scalar>
struct PolyphaseTap {
  struct Weight {
    Weight(Scalar w) : value(w), zero(w == 0) {}
    Scalar value;
    bool zero;
  };
  Weight p_of_u, p_of_v, q_of_u, q_of_v;
};
template <class Scalar>
using PolyphaseTaps = std::vector<PolyphaseTap<Scalar>>;

/// Both directions of a two-channel filter bank, in polyphase form, for l = 0 .. count - 1:
///   p_l = sum_t (p_of_u_t u_{l+t} + p_of_v_t v_{l+t}),
///   q_l = sum_t (q_of_u_t u_{l+t} + q_of_v_t v_{l+t}).
/// u and v hold count values and as many more as there are taps, less one; outputs overlap neither.
template <class Scalar>
void correlate_pair(const PolyphaseTaps<Scalar>& taps, const Scalar* u, const Scalar* v,
                    Eigen::Index count, Scalar* p, Scalar* q);

/// The same with out_{2l} = p_l, out_{2l+1} = q_l.
template <class Scalar>
void correlate_pair_merged(const PolyphaseTaps<Scalar>& taps, const Scalar* u, const Scalar* v,
                           Eigen::Index count, Scalar* out);

/// The same of each signal of a group: u_l, v_l, p_l and q_l are rows of group_size values, in_step
/// and out_step values from one to the next.
template <class Scalar>
void correlate_pair_of_group(const PolyphaseTaps<Scalar>& taps, const Scalar* u, const Scalar* v,
                             Eigen::Index in_step, Eigen::Index count, Scalar* p, Scalar* q,
                             Eigen::Index out_step);

/// The rows source_{(begin + i) mod period}, i = 0 .. length - 1, of `row` values each: a pointer
/// into the source where none of them wraps, else a copy in the buffer (of that length).
template <class Scalar>
const Scalar* periodic_window(const Scalar* source, Eigen::Index period, Eigen::Index begin,
                              Eigen::Index length, Scalar* buffer, Eigen::Index row = 1);

/// even_i = source_{2p}, odd_i = source_{2p+1}, p = (begin + i) mod pairs, i = 0 .. length - 1.
template <class Scalar>
void split_pairs(const Scalar* source, Eigen::Index pairs, Eigen::Index begin, Eigen::Index length,
                 Scalar* even, Scalar* odd);

}  // namespace wavecurve
