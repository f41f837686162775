// "The same idea can be used for the derivation of the off-diagonal blocks": every block between two levels, by two-scale
// relations, against sums over a fine grid.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/dyadic_values.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::off_diagonal_blocks_claim {

namespace {

constexpr int samples = 32, levels = 3;
constexpr int coarsest_grid = 7, finest_grid = 13;  // log2 of the points of a period

/// The derivatives of all basis functions at 2^grid points of [0, 1), one column each.
Eigen::MatrixXd slopes(const FilterBank<double>& bank, int grid) {
  const Eigen::Index points = Eigen::Index{1} << grid;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(points, samples);
  for (const Band& band : multiscale_bands(samples, levels)) {
    // Band of level j: 2^(j/2) f(2^j x - n), with the factor 2^j of the derivative.
    const auto size = static_cast<double>(band.size);
    const int finer = grid - static_cast<int>(std::lround(std::log2(size)));
    const DyadicValues f =
        band.is_scaling ? scaling_values(bank, finer, 1) : wavelet_values(bank, finer, 1);
    const double scale = size * std::sqrt(size);
    const Eigen::Index step = points / band.size;
    const auto first = static_cast<Eigen::Index>(std::lround(std::ldexp(f.first, finer)));
    for (Eigen::Index n = 0; n < band.size; ++n) {
      for (Eigen::Index i = 0; i < f.values.size(); ++i) {
        const Eigen::Index place = (first + i + n * step) % points;
        result((place + points) % points, band.offset + n) += scale * f.values[i];
      }
    }
  }
  return result;
}

struct Block {
  std::string name;
  Eigen::Index row, column, rows, columns;
};

std::vector<Block> cross_level_blocks() {
  const auto bands = multiscale_bands(samples, levels);
  const auto name = [](const Band& band) {
    return fmt::format("{} of {}", band.is_scaling ? "φ" : "ψ", band.size);
  };
  std::vector<Block> blocks;
  for (std::size_t a = 0; a < bands.size(); ++a) {
    for (std::size_t b = a + 1; b < bands.size(); ++b) {
      blocks.push_back({name(bands[a]) + " × " + name(bands[b]), bands[a].offset, bands[b].offset,
                        bands[a].size, bands[b].size});
    }
  }
  return blocks;
}

/// The distance of the sums from the block, both as root mean squares, by grid.
std::vector<std::vector<double>> distances(const FilterBank<double>& bank,
                                           const std::vector<Block>& blocks) {
  const Eigen::MatrixXd exact = stiffness(bank, samples, levels);
  std::vector<std::vector<double>> by_grid;
  for (int grid = coarsest_grid; grid <= finest_grid; ++grid) {
    const Eigen::MatrixXd b = slopes(bank, grid);
    const Eigen::MatrixXd sums = b.transpose() * b / static_cast<double>(b.rows());
    std::vector<double> row;
    for (const auto& [name, i, j, rows, columns] : blocks) {
      const auto block = exact.block(i, j, rows, columns);
      row.push_back((sums.block(i, j, rows, columns) - block).norm() / block.norm());
    }
    by_grid.push_back(row);
  }
  return by_grid;
}

Outcome evaluate() {
  const FilterBank<double> bank = find_filter_bank("db4");
  const std::vector<Block> blocks = cross_level_blocks();
  const auto by_grid = distances(bank, blocks);
  Chart chart{
      "off-diagonal-blocks",
      {fmt::format(
           "Distance between each block by two-scale relations and the sums over 2^g points, relative to "
           "the block; D8, N = {}, {} levels",
           samples, levels),
       {"g"},
       {}},
      fmt::format("set xlabel 'points of a period, log_2'\nset ylabel 'relative distance'\n"
                  "set logscale y\nset format y '10^{{%T}}'\nset key right top\n"
                  "plot for [i=2:{}] data using 1:i with linespoints\n",
                  blocks.size() + 1)};
  for (const Block& block : blocks) chart.data.columns.push_back(block.name);
  for (std::size_t g = 0; g < by_grid.size(); ++g) {
    std::vector<std::string> row{std::to_string(coarsest_grid + static_cast<int>(g))};
    for (const double distance : by_grid[g]) row.push_back(fmt::format("{:.2e}", distance));
    chart.data.rows.push_back(row);
  }
  // Each grid has twice the points of the one before: the orders at which distances fall, over all grids.
  double slowest = HUGE_VAL, largest = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const double order =
        std::log2(by_grid.front()[b] / by_grid.back()[b]) / (finest_grid - coarsest_grid);
    slowest = std::min(slowest, order);
    largest = std::max(largest, by_grid.back()[b]);
  }
  // Derivatives lie in H^σ for σ below the Sobolev exponent of φ less 1, and so does a product of two, since σ > 1/2. Its sum over
  // n points errs by its Fourier coefficients at the multiples of n, together O(n^-σ) by Schwarz's inequality.
  const bool holds = slowest > bank.sobolev_exponent - 1;
  Outcome outcome;
  outcome.verdict = holds ? ClaimVerdict::holds : ClaimVerdict::does_not_hold;
  outcome.finding = {
      "all {} blocks between levels agree with sums over the grid: the distance falls with order {} or faster, to {}",
      {counted("blocks between levels", std::ssize(blocks)), to_digits("slowest order", slowest, 2),
       to_digits("largest distance on the finest grid", largest, 1)}};
  outcome.summary =
      "An entry between two levels is a combination of entries of the finer one, by the two-scale relation, once for each level "
      "between them. Sums over a grid, which use no such relation between the blocks, converge to the same entries.";
  outcome.evidence = {chart};
  return outcome;
}

const RegisterClaim registered(
    {"off-diagonal-blocks", "Derivation of the off-diagonal blocks", "Section 3.2, below (3.14)",
     "The same idea can be used for the derivation of the off-diagonal blocks", evaluate});

}  // namespace

}  // namespace wavecurve::verification::off_diagonal_blocks_claim
