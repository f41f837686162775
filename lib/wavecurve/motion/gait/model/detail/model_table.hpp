#pragma once

#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "wavecurve/motion/gait/model/fit_models.hpp"
#include "wavecurve/motion/gait/model/gait_model.hpp"
#include "wavecurve/motion/gait/model/phase_data.hpp"
#include "wavecurve/motion/gait/model/phase_motion.hpp"

namespace wavecurve::gait {

/// What a model is fitted to: one of the phases of a limb. `start`: parameters of a fit to more
/// data, from which a fit that iterates sets out; empty if there are none.
struct FitData {
  const std::vector<PhaseData>& phases;
  std::size_t phase;
  const ModelSetting& setting;
  const Eigen::MatrixXd& start;

  const PhaseData& data() const { return phases[phase]; }
  Eigen::Index coefficients() const { return data().runs.front().from.size(); }
};

/// All that sets a model apart from the others.
struct ModelRow {
  GaitModel model;
  std::string_view name;
  bool (*has_rows)(Eigen::Index rows);
  /// D of PhaseMotion at tau, or its derivative of order 1; difference is q_1 - q_2.
  Eigen::VectorXd (*deviation)(const PhaseMotion& motion, const Eigen::VectorXd& difference,
                               double tau, int order);
  Eigen::MatrixXd (*fit)(const FitData& data);
  /// The parameters of the motion between two key frames from what was fitted; none: the same.
  Eigen::MatrixXd (*between)(const Eigen::MatrixXd& fitted, const Eigen::RowVectorXd& difference,
                             const ModelSetting& setting) = nullptr;
};

const ModelRow& row_of(GaitModel model);

}  // namespace wavecurve::gait
