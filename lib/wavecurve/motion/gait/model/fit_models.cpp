#include "wavecurve/motion/gait/model/fit_models.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/motion/gait/model/detail/deviation_basis.hpp"
#include "wavecurve/motion/gait/model/detail/fit_gammas.hpp"
#include "wavecurve/motion/gait/model/detail/fit_oscillator.hpp"
#include "wavecurve/motion/gait/model/detail/fit_series.hpp"
#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Bands of control points, down to four of them; rows of x and of y alike.
class Levels {
 public:
  Levels(const FilterBank<double>& bank, Index control_points)
      : levels_(levels_to_four(control_points)),
        transform_(bank, control_points, levels_),
        workspace_(transform_.workspace_size()) {}

  /// Of each row, the coefficients of x, then those of y; or back.
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

Gammas level_gammas(const PhaseData& data, const ModelSetting& setting) {
  Levels levels(setting.bank, data.runs.front().from.size() / 2);
  PhaseData analysed = data;
  for (PhaseRun& run : analysed.runs) {
    run.from = levels.analysed(run.from);
    run.to = levels.analysed(run.to);
    run.points = levels.analysed(run.points);
  }
  return fit_gammas(analysed, levels.bands(), setting.least_movement);
}

/// The row of a polynomial of degree 2 that the gammas of bands make of a movement q_1 - q_2.
MatrixXd level_bend(const VectorXd& gamma, const Eigen::RowVectorXd& difference,
                    const ModelSetting& setting) {
  Levels levels(setting.bank, difference.size() / 2);
  const Eigen::VectorXi band = levels.bands();
  MatrixXd moved = levels.analysed(difference);
  for (Index i = 0; i < moved.cols(); ++i) {
    const double g = gamma[band[i]];
    moved(0, i) *= std::isnan(g) ? 0 : -g;
  }
  return levels.synthesised(moved);
}

/// A fitted model before it is known for which key frames.
struct Fitted {
  PhaseMotion motion;
  VectorXd level_gamma;
};

Fitted fit(GaitModel model, const std::vector<PhaseData>& phases, std::size_t phase,
           const ModelSetting& setting, const MatrixXd& start = {}) {
  const PhaseData& data = phases[phase];
  const Index coefficients = data.runs.front().from.size();
  Fitted result{{model, MatrixXd(0, coefficients), data.begin, data.end}, {}};
  MatrixXd& parameters = result.motion.parameters;
  switch (model) {
    case GaitModel::linear:
      break;
    case GaitModel::quadratic:
      parameters = fit_gammas(data, each_coefficient(coefficients), setting.least_movement)
                       .gamma.transpose();
      break;
    case GaitModel::quadratic_by_limb:
      parameters = MatrixXd::Constant(1, coefficients,
                                      fit_gammas(data, all_coefficients(coefficients), 0).gamma[0]);
      break;
    case GaitModel::quadratic_by_level:
      result.level_gamma = level_gammas(data, setting).gamma;
      break;
    case GaitModel::oscillator:
      parameters = fit_oscillator(data, setting.least_movement, start);
      break;
    case GaitModel::fourier:
      parameters = fit_fourier(phases, setting.fourier_terms);
      break;
    default:
      parameters =
          fit_polynomial(data, 3 + static_cast<int>(model) - static_cast<int>(GaitModel::cubic));
  }
  return result;
}

PhaseMotion motion_between(const Fitted& fitted, const Eigen::RowVectorXd& from,
                           const Eigen::RowVectorXd& to, const ModelSetting& setting) {
  PhaseMotion motion = fitted.motion;
  if (motion.model == GaitModel::quadratic_by_level) {
    motion.parameters = level_bend(fitted.level_gamma, from - to, setting);
  }
  return motion;
}

Contour as_contour(const Eigen::RowVectorXd& coefficients) {
  return coefficients.reshaped(coefficients.size() / 2, 2);
}

struct Sum {
  double squares = 0, foot_squares = 0;
  Index count = 0, frames = 0;

  double root_mean_square() const { return std::sqrt(squares / static_cast<double>(count)); }
  double foot() const { return std::sqrt(foot_squares / static_cast<double>(frames)); }
};

/// Adds the squares of data less model of a run.
void add_residuals(const Fitted& fitted, const PhaseRun& run, const ModelSetting& setting,
                   Sum& sum) {
  const PhaseMotion motion = motion_between(fitted, run.from, run.to, setting);
  const Contour from = as_contour(run.from), to = as_contour(run.to);
  for (Index i = 0; i < run.tau.size(); ++i) {
    Eigen::RowVectorXd model;
    if (motion.model == GaitModel::fourier) {
      // As it was fitted: without key frames.
      const double u = motion.begin + run.tau[i] * (motion.end - motion.begin);
      model = fourier_basis(u, motion.parameters.rows()).transpose() * motion.parameters;
    } else {
      model = pose_between(motion, from, to, run.tau[i]).reshaped().transpose();
    }
    sum.squares += (run.points.row(i) - model).squaredNorm();
    sum.count += model.size();
    sum.foot_squares += std::pow(run.points(i, setting.foot) - model[setting.foot], 2);
    ++sum.frames;
  }
}

PhaseRun some_frames(const PhaseRun& run, Index fold, Index folds, bool of_fold) {
  PhaseRun part = run;
  Index size = 0;
  for (Index i = 0; i < run.tau.size(); ++i) {
    if ((i % folds == fold) != of_fold) continue;
    part.tau[size] = run.tau[i];
    part.points.row(size++) = run.points.row(i);
  }
  part.tau.conservativeResize(size);
  part.points.conservativeResize(size, Eigen::NoChange);
  return part;
}

/// The phases without a cycle; of a single cycle, without every fifth frame.
std::vector<PhaseData> training(const std::vector<PhaseData>& phases, Index fold, Index folds) {
  std::vector<PhaseData> rest = phases;
  for (PhaseData& data : rest) {
    if (data.runs.size() == 1) {
      data.runs[0] = some_frames(data.runs[0], fold, folds, false);
    } else if (fold < static_cast<Index>(data.runs.size())) {
      data.runs.erase(data.runs.begin() + fold);
    }
  }
  return rest;
}

}  // namespace

ModelFit fit_model(GaitModel model, const std::vector<PhaseData>& phases, std::size_t phase,
                   const ModelSetting& setting) {
  const PhaseData& data = phases[phase];
  const Fitted whole = fit(model, phases, phase, setting);
  Sum residuals, held_out;
  Eigen::RowVectorXd from = Eigen::RowVectorXd::Zero(data.runs.front().from.size()), to = from;
  for (const PhaseRun& run : data.runs) {
    add_residuals(whole, run, setting, residuals);
    from += run.from / static_cast<double>(data.runs.size());
    to += run.to / static_cast<double>(data.runs.size());
  }
  const auto runs = static_cast<Index>(data.runs.size());
  constexpr Index frame_folds = 5;
  const Index folds = runs > 1 ? runs : frame_folds;
  for (Index fold = 0; fold < folds; ++fold) {
    const Fitted part =
        fit(model, training(phases, fold, folds), phase, setting, whole.motion.parameters);
    const PhaseRun test = runs > 1 ? data.runs[static_cast<std::size_t>(fold)]
                                   : some_frames(data.runs[0], fold, folds, true);
    add_residuals(part, test, setting, held_out);
  }
  return {motion_between(whole, from, to, setting), residuals.root_mean_square(),
          held_out.root_mean_square(), residuals.foot()};
}

PhaseGammas phase_gammas(const PhaseData& data, const ModelSetting& setting) {
  const Index coefficients = data.runs.front().from.size();
  const Gammas each = fit_gammas(data, each_coefficient(coefficients), setting.least_movement);
  const Gammas limb = fit_gammas(data, all_coefficients(coefficients), 0);
  const Gammas level = level_gammas(data, setting);
  return {{},
          data.phase,
          each.gamma,
          each.standard_error,
          limb.gamma[0],
          limb.standard_error[0],
          level.gamma,
          level.standard_error};
}

}  // namespace wavecurve::gait
