#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/filters/detail/whole_numbers.hpp"

namespace wavecurve::tracking {

/// A marked kernel: a fixed amount of work, known by its name for as long as the history lasts.
struct Kernel {
  std::string name;
  Eigen::Index size;  ///< the one that is tracked
  /// Everything but the work for a size; calling the result does the work once.
  std::function<std::function<void()>(Eigen::Index size)> prepare;

  /// Runs that are counted together: so many that the start of one does not matter.
  int counted_runs = 1;

  /// The growth that the documentation states, N or N log N, and the sizes that it is fitted over.
  enum class Growth { none, linear, linearithmic } growth = Growth::none;
  std::vector<Eigen::Index> sizes = {};

  /// What no implementation can do without, at the tracked size: bytes read and written once,
  /// additions and multiplications of the algorithm. 0: not known.
  double bytes = 0, operations = 0;
};

/// All of them. To mark one more, add it to the list of its room.
std::vector<Kernel> kernels();

std::vector<Kernel> transform_kernels();
std::vector<Kernel> operator_kernels();
std::vector<Kernel> dynamics_kernels();
std::vector<Kernel> curve_kernels();
std::vector<Kernel> certified_kernels();
/// Not part of kernels(): twins by the definition, O(N^2), marked as N log N. The self-test holds
/// that they are found out.
std::vector<Kernel> plain_kernels();

/// Throws std::invalid_argument naming those there are; knows the plain ones too.
Kernel find_kernel(const std::string& name);

}  // namespace wavecurve::tracking
