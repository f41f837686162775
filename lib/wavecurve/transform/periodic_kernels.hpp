#pragma once

#include <Eigen/Core>

/// The loops that every periodic filter runs through. None allocates; all work on raw pointers,
/// since they are called a block at a time.
namespace wavecurve {

/// out_l = sum_{t < taps} (u_weight_t u_{l+t} + v_weight_t v_{l+t}),  l = 0 .. count - 1.
///
/// Two sequences at once, since both directions of a two-channel filter bank, in polyphase form,
/// are of this shape. u and v hold count + taps - 1 values; out overlaps neither.
template <class Scalar>
void correlate_pair(const Scalar* u_weight, const Scalar* v_weight, int taps, const Scalar* u,
                    const Scalar* v, Eigen::Index count, Scalar* out);

/// The values source_{(begin + i) mod period}, i = 0 .. length - 1: a pointer into the source where
/// none of them wraps, else a copy in the buffer (of that length).
template <class Scalar>
const Scalar* periodic_window(const Scalar* source, Eigen::Index period, Eigen::Index begin,
                              Eigen::Index length, Scalar* buffer);

/// even_i = source_{2p}, odd_i = source_{2p+1}, p = (begin + i) mod pairs, i = 0 .. length - 1.
template <class Scalar>
void split_pairs(const Scalar* source, Eigen::Index pairs, Eigen::Index begin, Eigen::Index length,
                 Scalar* even, Scalar* odd);

/// The inverse without wrapping: out_{2i} = even_i, out_{2i+1} = odd_i.
template <class Scalar>
void merge_pairs(const Scalar* even, const Scalar* odd, Eigen::Index length, Scalar* out);

}  // namespace wavecurve
