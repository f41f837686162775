#pragma once

#include <type_traits>

#include <Eigen/Core>

#include "wavecurve/filters/filter_bank.hpp"

/// Plain twins: written straight from the publication's equations, slow, and the specification
/// that the fast paths are tested against.
namespace wavecurve::plain {

template <class Scalar>
using Vector = Eigen::Vector<Scalar, Eigen::Dynamic>;

/// A read-only vector argument from which Scalar is not deduced.
template <class Scalar>
using ConstVectorRef = Eigen::Ref<const Vector<std::type_identity_t<Scalar>>>;

/// h~_l = sum_k h_{l + period k}, l = 0 .. period - 1. Publication, (2.7).
template <class Scalar>
Vector<Scalar> periodized(const Filter<Scalar>& filter, Eigen::Index period);

/// Samples to coefficients in global-to-local order by the analysis filters. Publication, (2.8).
/// Throws as multiscale_bands does.
template <class Scalar>
Vector<Scalar> forward_transform(const FilterBank<Scalar>& bank, int levels,
                                 const ConstVectorRef<Scalar>& samples);

/// Coefficients in global-to-local order to samples by the synthesis filters. Publication, (2.9).
/// Throws as multiscale_bands does.
template <class Scalar>
Vector<Scalar> inverse_transform(const FilterBank<Scalar>& bank, int levels,
                                 const ConstVectorRef<Scalar>& coefficients);

}  // namespace wavecurve::plain
