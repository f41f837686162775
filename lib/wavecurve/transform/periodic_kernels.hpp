#pragma once

#include <Eigen/Core>

/// The loops that every periodic filter runs through, vectorised for the processor at hand. None
/// allocates; all work on raw pointers, since they are called a block at a time. Additions and
/// multiplications are never fused and come in the order of the formula: all processors give the
/// same bits, and so do single and interleaved signals (see Layout).
namespace wavecurve {

/// out_l = sum_{t < taps} (u_weight_t u_{l+t} + v_weight_t v_{l+t}),  l = 0 .. count - 1.
///
/// Two sequences at once, since both directions of a two-channel filter bank, in polyphase form,
/// are of this shape. u and v hold count + taps - 1 values; out overlaps neither.
template <class Scalar>
void correlate_pair(const Scalar* u_weight, const Scalar* v_weight, int taps, const Scalar* u,
                    const Scalar* v, Eigen::Index count, Scalar* out);

/// The same of each signal of a group: u_l, v_l and out_l are rows of group_size values, in_step
/// and out_step values from one to the next.
template <class Scalar>
void correlate_pair_of_group(const Scalar* u_weight, const Scalar* v_weight, int taps,
                             const Scalar* u, const Scalar* v, Eigen::Index in_step,
                             Eigen::Index count, Scalar* out, Eigen::Index out_step);

/// The rows source_{(begin + i) mod period}, i = 0 .. length - 1, of `row` values each: a pointer
/// into the source where none of them wraps, else a copy in the buffer (of that length).
template <class Scalar>
const Scalar* periodic_window(const Scalar* source, Eigen::Index period, Eigen::Index begin,
                              Eigen::Index length, Scalar* buffer, Eigen::Index row = 1);

/// even_i = source_{2p}, odd_i = source_{2p+1}, p = (begin + i) mod pairs, i = 0 .. length - 1.
template <class Scalar>
void split_pairs(const Scalar* source, Eigen::Index pairs, Eigen::Index begin, Eigen::Index length,
                 Scalar* even, Scalar* odd);

/// The inverse without wrapping: out_{2i} = even_i, out_{2i+1} = odd_i.
template <class Scalar>
void merge_pairs(const Scalar* even, const Scalar* odd, Eigen::Index length, Scalar* out);

}  // namespace wavecurve
