#include "wavecurve/certified/detail/distance_to_exact_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/QR>

#include "wavecurve/certified/detail/relations.hpp"

namespace wavecurve::certified {

namespace {

using Eigen::Index;

Filter<double> middles(const Filter<Ball>& filter) {
  Filter<double> result{filter.first_index, {}};
  for (const Ball& tap : filter.taps) result.taps.push_back(tap.to_double());
  return result;
}

Eigen::VectorXd residuals(const FilterBank<double>& bank) {
  const auto relations = filter_relations(bank, std::sqrt(2.0));
  Eigen::VectorXd values(static_cast<Index>(relations.size()));
  std::ranges::transform(relations, values.begin(), &Relation<double>::residual);
  return values;
}

/// F' by one tap: half of F(h + e) - F(h - e), which is exact, since F is of second degree.
Eigen::VectorXd slope(FilterBank<double> bank, Filter<double> FilterBank<double>::*side,
                      std::size_t tap) {
  const bool orthonormal = bank.is_orthonormal();
  const auto moved_by = [&](double step) {
    FilterBank<double> moved = bank;
    (moved.*side).taps[tap] += step;
    if (orthonormal) moved.analysis_low = moved.synthesis_low;
    return residuals(moved);
  };
  return (moved_by(1) - moved_by(-1)) / 2;
}

/// F, of the balls, since it may be smaller than what doubles can tell.
Eigen::VectorXd residuals(FilterBank<Ball> bank) {
  for (auto* low : {&bank.analysis_low, &bank.synthesis_low}) {
    for (Ball& tap : low->taps) tap = tap.midpoint();
  }
  const auto relations = filter_relations(bank, sqrt(Ball(2)));
  Eigen::VectorXd values(static_cast<Index>(relations.size()));
  std::ranges::transform(relations, values.begin(),
                         [](const auto& relation) { return relation.residual.to_double(); });
  return values;
}

}  // namespace

FilterDistance distance_to_exact_filter(const FilterBank<Ball>& bank) {
  FilterBank<double> doubles;
  doubles.analysis_low = middles(bank.analysis_low);
  doubles.synthesis_low = middles(bank.synthesis_low);
  doubles.vanishing_moments = bank.vanishing_moments;
  doubles.dual_vanishing_moments = bank.dual_vanishing_moments;

  std::vector<Eigen::VectorXd> slopes;
  std::vector<double FilterDistance::*> sides;
  const auto append_side = [&](Filter<double> FilterBank<double>::*low,
                               double FilterDistance::*side) {
    const std::vector<double>& taps = (doubles.*low).taps;
    for (std::size_t k = 0; k < taps.size(); ++k) {
      if (taps[k] == 0) continue;
      slopes.push_back(slope(doubles, low, k));
      sides.push_back(side);
    }
  };
  append_side(&FilterBank<double>::synthesis_low, &FilterDistance::synthesis);
  if (!bank.is_orthonormal()) {
    append_side(&FilterBank<double>::analysis_low, &FilterDistance::analysis);
  }

  if (slopes.empty()) {  // taps below the range of doubles
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {infinity, infinity};
  }
  Eigen::VectorXd f = residuals(bank);
  Eigen::MatrixXd derivative(f.size(), static_cast<Index>(slopes.size()));
  for (std::size_t k = 0; k < slopes.size(); ++k) derivative.col(static_cast<Index>(k)) = slopes[k];
  // The moments are of very different size. A relation without slope cannot be mended.
  const Eigen::VectorXd scale = derivative.rowwise().norm().cwiseMax(1e-300).cwiseInverse();
  f.array() *= scale.array();
  derivative = scale.asDiagonal() * derivative;
  const Eigen::VectorXd step = derivative.completeOrthogonalDecomposition().solve(f);
  FilterDistance distance{0, 0};
  for (std::size_t k = 0; k < sides.size(); ++k) {
    double& largest = distance.*sides[k];
    largest = std::max(largest, std::abs(step[static_cast<Index>(k)]));
  }
  if (bank.is_orthonormal()) distance.analysis = distance.synthesis;
  return distance;
}

}  // namespace wavecurve::certified
