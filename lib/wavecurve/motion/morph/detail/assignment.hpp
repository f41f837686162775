#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace wavecurve::motion {

/// Throws std::domain_error, naming what is to be assigned, where optimal_assignment would take too long:
/// ten thousand million operations, at most, are some seconds. To be called before costs are computed.
void check_assignment(std::string_view what, std::size_t rows, std::size_t columns);

/// The column of each row such that no column is taken twice, as many rows as possible have one,
/// and the sum of their costs is least. The Hungarian algorithm (Kuhn 1955, with the potentials and
/// shortest augmenting paths of Jonker and Volgenant 1987): O(n^3).
/// Throws std::domain_error unless all costs are finite.
std::vector<std::optional<Eigen::Index>> optimal_assignment(
    const Eigen::Ref<const Eigen::MatrixXd>& cost);

}  // namespace wavecurve::motion
