#pragma once

#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {

/// Which of the transforms of a PeriodicTransform.
enum class TransformDirection { forward, inverse, forward_adjoint, inverse_adjoint };

/// Transforms all columns of the input on several threads: each takes a share of the columns, with a
/// workspace of its own. A column's result is the same to the last bit whatever the number of
/// threads, since it is the same in whatever company. Threads: at least 1
/// (std::invalid_argument); no more are started than there are groups of columns, and with one all is
/// done by the calling thread. Otherwise as PeriodicTransform.
template <class Scalar>
void transform_batch(const PeriodicTransform<Scalar>& transform, TransformDirection direction,
                     typename PeriodicTransform<Scalar>::In input,
                     typename PeriodicTransform<Scalar>::Out output, int threads);

}  // namespace wavecurve
