#include "wavecurve/transform/synthesis_matrix.hpp"

#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/detail/strided_block.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve {

Eigen::SparseMatrix<double> synthesis_matrix(const FilterBank<double>& bank, Eigen::Index samples,
                                             int levels) {
  const PeriodicTransform<double> transform(bank, samples, levels);
  Eigen::VectorXd unit = Eigen::VectorXd::Zero(samples), column(samples);
  Eigen::VectorXd workspace(transform.workspace_size());
  std::vector<std::vector<StridedBlock>> blocks;
  // All functions of a band are shifts of its first.
  for (const Band& band : multiscale_bands(samples, levels)) {
    unit[band.offset] = 1;
    transform.inverse(unit, column, workspace);
    unit[band.offset] = 0;
    blocks.push_back({StridedBlock::with_fine_rows(column, band.size)});
  }
  return assemble(blocks);
}

}  // namespace wavecurve
