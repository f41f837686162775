#include "wavecurve/motion/gait/model/phase_motion.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/motion/gait/model/detail/deviation_basis.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr std::array<std::string_view, gait_models.size()> names{
    "linear",     "quadratic", "quadratic-by-limb", "quadratic-by-level",
    "cubic",      "quartic",   "quintic",           "sextic",
    "oscillator", "fourier"};

/// D or its derivative at tau; difference is q_1 - q_2.
VectorXd deviation(const PhaseMotion& motion, const VectorXd& difference, double tau, int order) {
  const auto& parameters = motion.parameters;
  switch (motion.model) {
    case GaitModel::linear:
      return VectorXd::Zero(difference.size());
    case GaitModel::quadratic:
    case GaitModel::quadratic_by_limb: {
      const double bend = order == 0 ? tau * tau - tau : 2 * tau - 1;
      return (parameters.row(0).transpose().array().isNaN())
          .select(0, parameters.row(0).transpose().array() * difference.array() * bend);
    }
    case GaitModel::oscillator: {
      VectorXd result = VectorXd::Zero(difference.size());
      for (Index i = 0; i < result.size(); ++i) {
        if (std::isnan(parameters(0, i))) continue;
        const OscillatorDeviation f(parameters(0, i), parameters(1, i));
        result[i] = difference[i] * (order == 0 ? f.value(tau) : f.slope(tau));
      }
      return result;
    }
    case GaitModel::fourier: {
      const Index rows = parameters.rows();
      const double length = motion.end - motion.begin;
      const auto series = [&](double u) { return fourier_basis(u, rows); };
      const VectorXd rise = series(motion.end) - series(motion.begin);
      const VectorXd weights =
          order == 0
              ? VectorXd(series(motion.begin + tau * length) - series(motion.begin) - tau * rise)
              : VectorXd(length * fourier_slope(motion.begin + tau * length, rows) - rise);
      return parameters.transpose() * weights;
    }
    default: {
      const Index rows = parameters.rows();
      return parameters.transpose() *
             (order == 0 ? bridge_basis(tau, rows) : bridge_slope(tau, rows));
    }
  }
}

void check(const PhaseMotion& motion, const Contour& from, const Contour& to) {
  if (from.rows() != to.rows() ||
      (motion.parameters.rows() > 0 && motion.parameters.cols() != 2 * from.rows())) {
    throw std::invalid_argument(
        fmt::format("key frames of {} and {} control points, and parameters of {} coefficients",
                    from.rows(), to.rows(), motion.parameters.cols()));
  }
}

}  // namespace

std::string_view model_name(GaitModel model) { return names[static_cast<std::size_t>(model)]; }

std::optional<GaitModel> find_gait_model(std::string_view name) {
  for (GaitModel model : gait_models) {
    if (model_name(model) == name) return model;
  }
  return std::nullopt;
}

bool has_rows(GaitModel model, Index rows) {
  switch (model) {
    case GaitModel::linear:
      return rows == 0;
    case GaitModel::quadratic:
    case GaitModel::quadratic_by_limb:
    case GaitModel::quadratic_by_level:
      return rows == 1;
    case GaitModel::oscillator:
      return rows == 2;
    case GaitModel::fourier:
      return rows % 2 == 1;
    default:
      return rows == 2 + static_cast<Index>(model) - static_cast<Index>(GaitModel::cubic);
  }
}

Contour pose_between(const PhaseMotion& motion, const Contour& from, const Contour& to,
                     double tau) {
  check(motion, from, to);
  const Contour difference = from - to;
  const VectorXd extra = deviation(motion, difference.reshaped(), tau, 0);
  // Exact at both ends, so that a path closes to the last bit.
  Contour pose = (1 - tau) * from + tau * to;
  pose.reshaped() += extra;
  return pose;
}

Contour velocity_between(const PhaseMotion& motion, const Contour& from, const Contour& to,
                         double tau) {
  check(motion, from, to);
  const Contour difference = from - to;
  const VectorXd extra = deviation(motion, difference.reshaped(), tau, 1);
  Contour velocity = -difference;
  velocity.reshaped() += extra;
  return velocity;
}

}  // namespace wavecurve::gait
