#include "wavecurve/motion/morph/detail/assignment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace wavecurve::motion {
namespace {

using Eigen::Index;

/// The least sum over all ways to give each row (of at most as many as columns) a column.
double least_cost(const Eigen::MatrixXd& cost) {
  std::vector<Index> columns(static_cast<std::size_t>(cost.cols()));
  std::iota(columns.begin(), columns.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0;
    for (Index i = 0; i < cost.rows(); ++i) sum += cost(i, columns[static_cast<std::size_t>(i)]);
    least = std::min(least, sum);
  } while (std::next_permutation(columns.begin(), columns.end()));
  return least;
}

RC_GTEST_PROP(OptimalAssignment, EqualsTheBestOfAllPermutations, ()) {
  Eigen::MatrixXd cost(*rc::gen::inRange(0, 7), *rc::gen::inRange(0, 7));
  for (double& value : cost.reshaped()) value = *rc::gen::inRange(-20, 20);  // many ties
  const auto column_of = optimal_assignment(cost);
  double sum = 0;
  std::set<Index> taken;
  for (std::size_t i = 0; i < column_of.size(); ++i) {
    if (!column_of[i]) continue;
    sum += cost(static_cast<Index>(i), *column_of[i]);
    taken.insert(*column_of[i]);
  }
  RC_ASSERT(static_cast<Index>(taken.size()) == std::min(cost.rows(), cost.cols()));
  if (cost.rows() > cost.cols()) cost.transposeInPlace();
  RC_ASSERT(sum == least_cost(cost));
}

TEST(OptimalAssignment, RefusesWhatIsNotFinite) {
  EXPECT_THROW(optimal_assignment(Eigen::MatrixXd::Constant(2, 2, std::nan(""))),
               std::domain_error);
}

}  // namespace
}  // namespace wavecurve::motion
