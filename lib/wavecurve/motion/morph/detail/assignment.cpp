#include "wavecurve/motion/morph/detail/assignment.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::motion {

namespace {

using Eigen::Index;

constexpr Index none = -1;

/// Rows enter one by one, each by the shortest augmenting path in reduced costs
/// cost(i, j) - row_potential(i) - column_potential(j) >= 0. Rows are at most as many as columns.
class Assignment {
 public:
  explicit Assignment(const Eigen::MatrixXd& cost)
      : cost_(cost),
        row_potential_(Eigen::VectorXd::Zero(cost.rows())),
        column_potential_(Eigen::VectorXd::Zero(cost.cols())),
        row_of_(Eigen::VectorX<Index>::Constant(cost.cols(), none)) {
    for (Index row = 0; row < cost.rows(); ++row) enter(row);
  }

  Index row_of(Index column) const { return row_of_(column); }

 private:
  void enter(Index row) {
    const Index columns = cost_.cols();
    Eigen::VectorXd distance =
        Eigen::VectorXd::Constant(columns, std::numeric_limits<double>::infinity());
    Eigen::VectorX<Index> before = Eigen::VectorX<Index>::Constant(columns, none);
    std::vector<bool> done(static_cast<std::size_t>(columns), false);
    Index column = none;
    do {
      const Index from = column == none ? row : row_of_(column);
      if (column != none) done[static_cast<std::size_t>(column)] = true;
      Index nearest = none;
      for (Index j = 0; j < columns; ++j) {
        if (done[static_cast<std::size_t>(j)]) continue;
        const double length = cost_(from, j) - row_potential_(from) - column_potential_(j);
        if (length < distance(j)) {
          distance(j) = length;
          before(j) = column;
        }
        if (nearest == none || distance(j) < distance(nearest)) nearest = j;
      }
      shift_potentials(row, distance(nearest), done, distance);
      column = nearest;
    } while (row_of_(column) != none);
    while (column != none) {
      row_of_(column) = before(column) == none ? row : row_of_(before(column));
      column = before(column);
    }
  }

  /// Makes the next column's reduced distance zero and keeps those of the tree so.
  void shift_potentials(Index row, double by, const std::vector<bool>& done,
                        Eigen::VectorXd& distance) {
    row_potential_(row) += by;
    for (Index j = 0; j < cost_.cols(); ++j) {
      if (done[static_cast<std::size_t>(j)]) {
        row_potential_(row_of_(j)) += by;
        column_potential_(j) -= by;
      } else {
        distance(j) -= by;
      }
    }
  }

  const Eigen::MatrixXd& cost_;
  Eigen::VectorXd row_potential_, column_potential_;
  Eigen::VectorX<Index> row_of_;
};

}  // namespace

void check_assignment(std::string_view what, std::size_t rows, std::size_t columns) {
  constexpr double most_operations = 1e10;
  const auto few = static_cast<double>(std::min(rows, columns));
  const auto many = static_cast<double>(std::max(rows, columns));
  if (few * few * many <= most_operations) return;
  throw std::domain_error(fmt::format(
      "{} and {} {} cannot be matched: the square of the smaller number times the larger one "
      "is {}, but must be at most {}",
      rows, columns, what, few * few * many, most_operations));
}

std::vector<std::optional<Index>> optimal_assignment(
    const Eigen::Ref<const Eigen::MatrixXd>& cost) {
  if (!cost.allFinite()) throw std::domain_error("the costs of an assignment must be finite");
  std::vector<std::optional<Index>> column_of(static_cast<std::size_t>(cost.rows()));
  const bool is_tall = cost.rows() > cost.cols();
  Eigen::MatrixXd wide = cost;
  if (is_tall) wide.transposeInPlace();
  const Assignment assignment(wide);
  for (Index column = 0; column < wide.cols(); ++column) {
    const Index row = assignment.row_of(column);
    if (row == none) continue;
    column_of[static_cast<std::size_t>(is_tall ? column : row)] = is_tall ? row : column;
  }
  return column_of;
}

}  // namespace wavecurve::motion
