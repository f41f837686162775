#include "wavecurve/motion/gait/model/detail/level_gammas.hpp"

#include <cmath>
#include <utility>

#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::gait {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Bands of control points, down to four of them; rows of x and of y alike.
class Levels {
 public:
  Levels(const FilterBank<double>& bank, Index control_points)
      : levels_(levels_to_four(control_points)),
        transform_(bank, control_points, levels_),
        workspace_(transform_.workspace_size()) {}

  /// Transforms, in each row, the coefficients of x, then those of y; or back.
  MatrixXd analysed(MatrixXd rows) { return each_half(std::move(rows), true); }
  MatrixXd synthesised(MatrixXd rows) { return each_half(std::move(rows), false); }

  /// The band of each coefficient.
  Eigen::VectorXi bands() const {
    const Index size = transform_.samples();
    Eigen::VectorXi band(2 * size);
    int number = 0;
    for (const Band& b : multiscale_bands(size, levels_)) {
      for (Index axis = 0; axis < 2; ++axis) {
        band.segment(axis * size + b.offset, b.size).setConstant(number);
      }
      ++number;
    }
    return band;
  }

 private:
  static int levels_to_four(Index control_points) {
    int levels = 0;
    while (control_points >> (levels + 1) >= 4) ++levels;
    return levels;
  }

  MatrixXd each_half(MatrixXd rows, bool forward) {
    const Index size = transform_.samples();
    for (Index i = 0; i < rows.rows(); ++i) {
      for (Index axis = 0; axis < 2; ++axis) {
        VectorXd half = rows.row(i).segment(axis * size, size).transpose();
        if (forward) {
          transform_.forward(half, half, workspace_);
        } else {
          transform_.inverse(half, half, workspace_);
        }
        rows.row(i).segment(axis * size, size) = half.transpose();
      }
    }
    return rows;
  }

  int levels_;
  PeriodicTransform<double> transform_;
  VectorXd workspace_;
};

}  // namespace

Gammas fit_level_gammas(const PhaseData& data, const ModelSetting& setting) {
  Levels levels(setting.bank, data.runs.front().from.size() / 2);
  PhaseData analysed = data;
  for (PhaseRun& run : analysed.runs) {
    run.from = levels.analysed(run.from);
    run.to = levels.analysed(run.to);
    run.points = levels.analysed(run.points);
  }
  return fit_gammas(analysed, levels.bands(), setting.least_movement);
}

MatrixXd level_bend(const MatrixXd& gamma, const Eigen::RowVectorXd& difference,
                    const ModelSetting& setting) {
  Levels levels(setting.bank, difference.size() / 2);
  const Eigen::VectorXi band = levels.bands();
  MatrixXd moved = levels.analysed(difference);
  for (Index i = 0; i < moved.cols(); ++i) {
    const double g = gamma(0, band[i]);
    moved(0, i) *= std::isnan(g) ? 0 : -g;
  }
  return levels.synthesised(moved);
}

}  // namespace wavecurve::gait
