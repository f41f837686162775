#pragma once

#include <Eigen/Core>

namespace wavecurve {

/// How the kernels find their signals: one, contiguous; or a group of signals side by side, whose
/// values alternate, so that each has a lane of a vector of its own.
enum class Layout { single, interleaved };

/// Signals of a group: a cache line of values.
template <class Scalar>
constexpr Eigen::Index group_size = 64 / sizeof(Scalar);

/// Values from one sample to the next.
template <class Scalar>
constexpr Eigen::Index row_size(Layout layout) {
  return layout == Layout::interleaved ? group_size<Scalar> : 1;
}

/// group_{n group_size + s} = signals_{inner n + outer s}, n = 0 .. samples - 1, s = 0 .. count -
/// 1; the rest of the group, 1 <= count <= group_size, repeats the first signal.
template <class Scalar>
void interleave(const Scalar* signals, Eigen::Index inner, Eigen::Index outer, Eigen::Index count,
                Eigen::Index samples, Scalar* group);

/// The inverse: what interleave put into the group goes back to the signals.
template <class Scalar>
void separate(const Scalar* group, Eigen::Index samples, Scalar* signals, Eigen::Index inner,
              Eigen::Index outer, Eigen::Index count);

}  // namespace wavecurve
