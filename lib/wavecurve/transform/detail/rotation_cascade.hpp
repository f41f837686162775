#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"

namespace wavecurve {

/// An orthonormal pair of filters of 2 K taps as a product of K rotations, half the multiplications
/// of the sums of products. Polyphase pairs (u, v)_i = x_{2i + parity}, x_{2i + 1 + parity} pass
///   (u_i, v_i) <- (u_{i-1}, v_i)                          but for the first rotation,
///   (u_i, v_i) <- (u_i + t_k v_i, v_i - t_k u_i)          k = 0 .. K - 1,
/// and the last pairs, scaled, are c and d, late by K - 1. The transpose is the same cascade, of
/// (d, c), with the tangents t in reverse order. P. P. Vaidyanathan, P.-Q. Hoang, Lattice
/// structures for optimal design and robust implementation of two-channel perfect-reconstruction
/// QMF banks, IEEE Trans. ASSP 36 (1988).
template <class Scalar>
struct RotationCascade {
  /// The kernels hold their state on the stack.
  static constexpr int max_size = 64;
  std::vector<Scalar> tangents, reversed_tangents;
  Scalar low_scale = 1, high_scale = 1;
  Eigen::Index parity = 0;
  /// The first pair that c_0 and d_0 depend on.
  Eigen::Index low_first = 0, high_first = 0;

  int size() const { return static_cast<int>(tangents.size()); }
};

/// The cascade of a pair, or none where the pair is not orthonormal to working precision, where it
/// has more than 2 max_size taps, or where
/// the unscaled rotations would enlarge a signal by more than 2^30.
template <class Scalar>
std::optional<RotationCascade<Scalar>> rotation_cascade(const Filter<Scalar>& low,
                                                        const Filter<Scalar>& high);

}  // namespace wavecurve
