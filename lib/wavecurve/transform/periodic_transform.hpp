#pragma once

#include <vector>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"
#include "wavecurve/transform/rotation_cascade.hpp"

namespace wavecurve {

/// One level of the cascade for one pair of filters, in polyphase form.
template <class Scalar>
class FilterPair {
 public:
  FilterPair(const Filter<Scalar>& low, const Filter<Scalar>& high);

  /// c_n = sum_l low_{l-2n} fine_l and d_n = sum_l high_{l-2n} fine_l, n = 0 .. half - 1, all
  /// indices of fine modulo 2 half. Publication, (2.8).
  void analyse(const Scalar* fine, Eigen::Index half, Scalar* c, Scalar* d, Scalar* buffer) const;
  /// fine_n = sum_l (low_{n-2l} c_l + high_{n-2l} d_l), n = 0 .. 2 half - 1. Publication, (2.9).
  void synthesise(const Scalar* c, const Scalar* d, Eigen::Index half, Scalar* fine,
                  Scalar* buffer) const;
  Eigen::Index buffer_size() const;

 private:
  /// Outputs computed at a time, so that the split samples stay in the first-level cache.
  static constexpr Eigen::Index block_size = 256;
  /// Taps 2t and 2t + 1, t = first .. first + pairs_ - 1, in this order and reversed.
  struct Polyphase {
    Eigen::Index first = 0;
    std::vector<Scalar> even, odd, reversed_even, reversed_odd;
  };
  static Polyphase polyphase(const Filter<Scalar>& filter, int pairs);

  int pairs_;
  Polyphase low_, high_;
  std::optional<RotationCascade<Scalar>> rotations_;  ///< of an orthonormal pair
};

/// The discrete periodic wavelet transform (DPWT) of a bank, any number of levels, any length that
/// 2^levels divides, also shorter than the filters. Coefficients are in global-to-local order (see
/// Band). Equal to plain::forward_transform and plain::inverse_transform up to rounding.
///
/// forward is S^-1 and inverse is S, the synthesis matrix; the adjoints are S^-T and S^T. Nothing
/// is allocated after construction: the caller lends a workspace of workspace_size() values. Input,
/// output and workspace must not overlap; their sizes are checked (std::invalid_argument).
/// Publication, section 2.1, (2.7)-(2.9).
template <class Scalar = double>
class PeriodicTransform {
 public:
  using Vector = Eigen::Vector<Scalar, Eigen::Dynamic>;
  using In = const Eigen::Ref<const Vector>&;
  using Out = Eigen::Ref<Vector>;

  /// Throws as multiscale_bands does.
  PeriodicTransform(const FilterBank<Scalar>& bank, Eigen::Index samples, int levels);

  Eigen::Index samples() const { return samples_; }
  int levels() const { return levels_; }
  Eigen::Index workspace_size() const;

  void forward(In samples, Out coefficients, Out workspace) const;
  void inverse(In coefficients, Out samples, Out workspace) const;
  void forward_adjoint(In coefficients, Out samples, Out workspace) const;
  void inverse_adjoint(In samples, Out coefficients, Out workspace) const;

 private:
  void analyse(const FilterPair<Scalar>& filters, In input, Out output, Out workspace) const;
  void synthesise(const FilterPair<Scalar>& filters, In input, Out output, Out workspace) const;
  void check_sizes(In input, const Out& output, const Out& workspace) const;

  Eigen::Index samples_;
  int levels_;
  FilterPair<Scalar> analysis_, synthesis_;
};

}  // namespace wavecurve
