#include "wavecurve/transform/transform_batch.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <thread>
#include <vector>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/transform/detail/interleave.hpp"

namespace wavecurve {

namespace {

/// Workspaces up to this size stay with their thread, for the next call.
constexpr Eigen::Index largest_kept = Eigen::Index{1} << 22;

template <class Scalar>
using Workspace = Eigen::Vector<Scalar, Eigen::Dynamic>;

template <class Scalar>
void transform_columns(const PeriodicTransform<Scalar>& transform, TransformDirection direction,
                       typename PeriodicTransform<Scalar>::In input,
                       typename PeriodicTransform<Scalar>::Out output) {
  static thread_local Workspace<Scalar> workspace;
  const Eigen::Index needed = transform.workspace_size(input.cols());
  if (workspace.size() < needed) workspace.resize(needed);
  switch (direction) {
    case TransformDirection::forward:
      transform.forward(input, output, workspace);
      break;
    case TransformDirection::inverse:
      transform.inverse(input, output, workspace);
      break;
    case TransformDirection::forward_adjoint:
      transform.forward_adjoint(input, output, workspace);
      break;
    case TransformDirection::inverse_adjoint:
      transform.inverse_adjoint(input, output, workspace);
      break;
  }
  if (needed > largest_kept) workspace.resize(0);
}

}  // namespace

template <class Scalar>
void transform_batch(const PeriodicTransform<Scalar>& transform, TransformDirection direction,
                     typename PeriodicTransform<Scalar>::In input,
                     typename PeriodicTransform<Scalar>::Out output, int threads) {
  check_at_least("threads", threads, 1);
  const Eigen::Index columns = input.cols();
  const Eigen::Index groups = (columns + group_size<Scalar> - 1) / group_size<Scalar>;
  if (threads == 1 || groups < 2 || output.rows() != input.rows() || output.cols() != columns) {
    return transform_columns<Scalar>(transform, direction, input, output);
  }
  const auto shares = std::min<Eigen::Index>(threads, groups);
  std::vector<std::exception_ptr> failures(static_cast<std::size_t>(shares));
  const auto do_share = [&](Eigen::Index share) {
    const Eigen::Index first = share * groups / shares * group_size<Scalar>;
    const Eigen::Index end = std::min((share + 1) * groups / shares * group_size<Scalar>, columns);
    try {
      transform_columns<Scalar>(transform, direction, input.middleCols(first, end - first),
                                output.middleCols(first, end - first));
    } catch (...) {
      failures[static_cast<std::size_t>(share)] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    for (Eigen::Index share = 1; share < shares; ++share) others.emplace_back(do_share, share);
    do_share(0);
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

template void transform_batch<double>(const PeriodicTransform<double>&, TransformDirection,
                                      PeriodicTransform<double>::In, PeriodicTransform<double>::Out,
                                      int);
template void transform_batch<float>(const PeriodicTransform<float>&, TransformDirection,
                                     PeriodicTransform<float>::In, PeriodicTransform<float>::Out,
                                     int);

}  // namespace wavecurve
