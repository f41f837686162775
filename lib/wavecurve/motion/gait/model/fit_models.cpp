#include "wavecurve/motion/gait/model/fit_models.hpp"

#include <cmath>

#include "wavecurve/elementary/root.hpp"
#include "wavecurve/motion/gait/model/detail/deviation_basis.hpp"
#include "wavecurve/motion/gait/model/detail/fit_gammas.hpp"
#include "wavecurve/motion/gait/model/detail/fit_oscillator.hpp"
#include "wavecurve/motion/gait/model/detail/fit_series.hpp"
#include "wavecurve/motion/gait/model/detail/level_gammas.hpp"
#include "wavecurve/motion/gait/model/detail/model_table.hpp"
#include "wavecurve/transform/bands.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// The motion as it is fitted, before it is known between which key frames.
PhaseMotion fit(GaitModel model, const std::vector<PhaseData>& phases, std::size_t phase,
                const ModelSetting& setting, const MatrixXd& start = {}) {
  const PhaseData& data = phases[phase];
  return {model, row_of(model).fit({phases, phase, setting, start}), data.begin, data.end};
}

PhaseMotion motion_between(const PhaseMotion& fitted, const Eigen::RowVectorXd& from,
                           const Eigen::RowVectorXd& to, const ModelSetting& setting) {
  const auto between = row_of(fitted.model).between;
  if (!between) return fitted;
  PhaseMotion motion = fitted;
  motion.parameters = between(fitted.parameters, from - to, setting);
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
void add_residuals(const PhaseMotion& fitted, const PhaseRun& run, const ModelSetting& setting,
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
    sum.foot_squares += whole_power(run.points(i, setting.foot) - model[setting.foot], 2);
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
  const PhaseMotion whole = fit(model, phases, phase, setting);
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
    const PhaseMotion part =
        fit(model, training(phases, fold, folds), phase, setting, whole.parameters);
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
  const Gammas level = fit_level_gammas(data, setting);
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
