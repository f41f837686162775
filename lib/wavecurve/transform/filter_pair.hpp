#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/transform/interleave.hpp"
#include "wavecurve/transform/rotation_cascade.hpp"

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
  /// Taps 2t and 2t + 1, t = first .. first + pairs_ - 1, in this order and reversed.
  struct Polyphase {
    Eigen::Index first = 0;
    std::vector<Scalar> even, odd, reversed_even, reversed_odd;
  };
  static Polyphase polyphase(const Filter<Scalar>& filter, int pairs);

  void analyse_one(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                   Scalar* buffer) const;
  void analyse_group(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d,
                     Scalar* buffer) const;
  /// The pairs of samples from the first that c_n or d_n needs to the last that c_{n + count - 1}
  /// or d_{n + count - 1} needs: `count` more than this.
  Eigen::Index overlap() const;

  int pairs_;
  Polyphase low_, high_;
  std::optional<RotationCascade<Scalar>> rotations_;  ///< of an orthonormal pair
};

}  // namespace wavecurve
