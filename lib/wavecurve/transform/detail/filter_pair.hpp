#pragma once

#include <optional>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/transform/detail/interleave.hpp"
#include "wavecurve/transform/detail/periodic_kernels.hpp"
#include "wavecurve/transform/detail/rotation_cascade.hpp"

namespace wavecurve {

/// One level of the cascade for one pair of filters, in polyphase form; of one signal, or of each
/// signal of an interleaved group, with the same bits.
template <class Scalar>
class FilterPair {
 public:
  FilterPair(const Filter<Scalar>& low, const Filter<Scalar>& high);

  /// c_n = sum_l low_{l-2n} fine_l and d_n = sum_l high_{l-2n} fine_l, n = 0 .. half - 1, all
  /// indices of fine modulo 2 half. Publication, (2.8).
  void analyse(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d, Scalar* buffer,
               Layout layout) const;
  /// fine_n = sum_l (low_{n-2l} c_l + high_{n-2l} d_l), n = 0 .. 2 half - 1. Publication, (2.9).
  void synthesise(const Scalar* c, const Scalar* d, Eigen::Index half, Scalar* fine, Scalar* buffer,
                  Layout layout) const;
  Eigen::Index buffer_size(Layout layout) const;

  /// The levels that the following take at once from a signal of that many samples on, 1 if none.
  int levels_at_once(Eigen::Index samples, Layout layout) const;
  /// As analyse and synthesise, of so many levels; d of level j is at bands + samples / 2^j.
  void analyse_levels(const Scalar* fine, Eigen::Index samples, Scalar* c, Scalar* bands,
                      Scalar* buffer) const;
  void synthesise_levels(const Scalar* c, const Scalar* bands, Eigen::Index samples, Scalar* fine,
                         Scalar* buffer) const;

 private:
  void analyse_one(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                   Scalar* buffer) const;
  void analyse_group(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                     Scalar* buffer) const;

  Eigen::Index first_;               ///< the first pair of samples that c_0 or d_0 needs
  Eigen::Index c_delay_, d_delay_;   ///< the first of c, of d, that fine_0 needs, is at - delay
  PolyphaseTaps<Scalar> analysis_;   ///< of the even and the odd samples, to c and d
  PolyphaseTaps<Scalar> synthesis_;  ///< of c and d, to the even and the odd samples
  std::optional<RotationCascade<Scalar>> rotations_;  ///< of an orthonormal pair
};

}  // namespace wavecurve
