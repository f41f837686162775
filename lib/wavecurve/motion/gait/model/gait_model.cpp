#include "wavecurve/motion/gait/model/gait_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/motion/gait/model/detail/deviation_basis.hpp"
#include "wavecurve/motion/gait/model/detail/fit_gammas.hpp"
#include "wavecurve/motion/gait/model/detail/fit_oscillator.hpp"
#include "wavecurve/motion/gait/model/detail/fit_series.hpp"
#include "wavecurve/motion/gait/model/detail/level_gammas.hpp"
#include "wavecurve/motion/gait/model/detail/model_table.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

template <Index number>
bool is_number(Index rows) {
  return rows == number;
}

bool is_odd(Index rows) { return rows % 2 == 1; }

VectorXd no_deviation(const PhaseMotion&, const VectorXd& difference, double, int) {
  return VectorXd::Zero(difference.size());
}

VectorXd gamma_deviation(const PhaseMotion& motion, const VectorXd& difference, double tau,
                         int order) {
  const auto gamma = motion.parameters.row(0).transpose().array();
  const double bend = order == 0 ? tau * tau - tau : 2 * tau - 1;
  return gamma.isNaN().select(0, gamma * difference.array() * bend);
}

VectorXd polynomial_deviation(const PhaseMotion& motion, const VectorXd&, double tau, int order) {
  const Index rows = motion.parameters.rows();
  return motion.parameters.transpose() *
         (order == 0 ? bridge_basis(tau, rows) : bridge_slope(tau, rows));
}

VectorXd oscillator_deviation(const PhaseMotion& motion, const VectorXd& difference, double tau,
                              int order) {
  const auto& parameters = motion.parameters;
  VectorXd result = VectorXd::Zero(difference.size());
  for (Index i = 0; i < result.size(); ++i) {
    if (std::isnan(parameters(0, i))) continue;
    const OscillatorDeviation f(parameters(0, i), parameters(1, i));
    result[i] = difference[i] * (order == 0 ? f.value(tau) : f.slope(tau));
  }
  return result;
}

VectorXd fourier_deviation(const PhaseMotion& motion, const VectorXd&, double tau, int order) {
  const Index rows = motion.parameters.rows();
  const double length = motion.end - motion.begin;
  const auto series = [&](double u) { return fourier_basis(u, rows); };
  const VectorXd rise = series(motion.end) - series(motion.begin);
  const VectorXd weights =
      order == 0 ? VectorXd(series(motion.begin + tau * length) - series(motion.begin) - tau * rise)
                 : VectorXd(length * fourier_slope(motion.begin + tau * length, rows) - rise);
  return motion.parameters.transpose() * weights;
}

MatrixXd no_parameters(const FitData& data) { return MatrixXd(0, data.coefficients()); }

MatrixXd gamma_of_each(const FitData& data) {
  return fit_gammas(data.data(), each_coefficient(data.coefficients()), data.setting.least_movement)
      .gamma.transpose();
}

MatrixXd gamma_of_limb(const FitData& data) {
  const Gammas gammas = fit_gammas(data.data(), all_coefficients(data.coefficients()), 0);
  return MatrixXd::Constant(1, data.coefficients(), gammas.gamma[0]);
}

MatrixXd gamma_of_levels(const FitData& data) {
  return fit_level_gammas(data.data(), data.setting).gamma.transpose();
}

template <int degree>
MatrixXd polynomial(const FitData& data) {
  return fit_polynomial(data.data(), degree);
}

MatrixXd constants(const FitData& data) {
  return fit_oscillator(data.data(), data.setting.least_movement, data.start);
}

MatrixXd series_terms(const FitData& data) {
  return fit_fourier(data.phases, data.setting.fourier_terms);
}

/// To add a model, add its name to the enumeration, and a row.
constexpr std::array table{
    ModelRow{GaitModel::linear, "linear", is_number<0>, no_deviation, no_parameters},
    ModelRow{GaitModel::quadratic, "quadratic", is_number<1>, gamma_deviation, gamma_of_each},
    ModelRow{GaitModel::quadratic_by_limb, "quadratic-by-limb", is_number<1>, gamma_deviation,
             gamma_of_limb},
    ModelRow{GaitModel::quadratic_by_level, "quadratic-by-level", is_number<1>,
             polynomial_deviation, gamma_of_levels, level_bend},
    ModelRow{GaitModel::cubic, "cubic", is_number<2>, polynomial_deviation, polynomial<3>},
    ModelRow{GaitModel::quartic, "quartic", is_number<3>, polynomial_deviation, polynomial<4>},
    ModelRow{GaitModel::quintic, "quintic", is_number<4>, polynomial_deviation, polynomial<5>},
    ModelRow{GaitModel::sextic, "sextic", is_number<5>, polynomial_deviation, polynomial<6>},
    ModelRow{GaitModel::oscillator, "oscillator", is_number<2>, oscillator_deviation, constants},
    ModelRow{GaitModel::fourier, "fourier", is_odd, fourier_deviation, series_terms},
};

constexpr auto models_of_table = [] {
  std::array<GaitModel, table.size()> models{};
  std::ranges::transform(table, models.begin(), &ModelRow::model);
  return models;
}();

}  // namespace

constinit const std::span<const GaitModel> gait_models = models_of_table;

const ModelRow& row_of(GaitModel model) {
  const auto* const row = std::ranges::find(table, model, &ModelRow::model);
  if (row == table.end()) throw std::invalid_argument("a model of gait that is none");
  return *row;
}

std::string_view model_name(GaitModel model) { return row_of(model).name; }

GaitModel find_gait_model(std::string_view name) {
  const auto* const row = std::ranges::find(table, name, &ModelRow::name);
  if (row != table.end()) return row->model;
  throw std::invalid_argument(unknown_name("model", name, table, &ModelRow::name));
}

bool has_rows(GaitModel model, Index rows) { return row_of(model).has_rows(rows); }

}  // namespace wavecurve::gait
