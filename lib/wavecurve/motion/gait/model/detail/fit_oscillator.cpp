#include "wavecurve/motion/gait/model/detail/fit_oscillator.hpp"

#include <cmath>
#include <limits>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include <Eigen/Dense>

#include "wavecurve/motion/gait/model/detail/deviation_basis.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Residuals of one coefficient; the unknowns are the roots of e_0 and f_0, which keeps them from
/// becoming negative.
struct Residuals {
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  const VectorXd& tau;
  const VectorXd& movement;  ///< q_1 - q_2, of each frame
  const VectorXd& off_line;

  int inputs() const { return 2; }
  int values() const { return static_cast<int>(tau.size()); }

  int operator()(const VectorXd& roots, VectorXd& residuals) const {
    const OscillatorDeviation f(roots[0] * roots[0], roots[1] * roots[1]);
    for (Index i = 0; i < tau.size(); ++i) {
      residuals[i] = movement[i] * f.value(tau[i]) - off_line[i];
    }
    return residuals.allFinite() ? 0 : -1;
  }
};

Eigen::Vector2d fit_one(const VectorXd& tau, const VectorXd& movement, const VectorXd& off_line,
                        const Eigen::Vector2d& start) {
  Eigen::NumericalDiff<Residuals> residuals(Residuals{tau, movement, off_line});
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Residuals>> solver(residuals);
  solver.parameters.maxfev = 100;
  VectorXd roots = start.cwiseSqrt();
  solver.minimize(roots);
  return roots.cwiseAbs2();
}

}  // namespace

MatrixXd fit_oscillator(const PhaseData& data, double least_movement, const MatrixXd& start) {
  Index frames = 0;
  for (const PhaseRun& run : data.runs) frames += run.tau.size();
  const Index coefficients = data.runs.front().from.size();
  VectorXd tau(frames);
  MatrixXd movement(frames, coefficients), rest(frames, coefficients);
  VectorXd mean_square = VectorXd::Zero(coefficients);
  Index row = 0;
  for (const PhaseRun& run : data.runs) {
    const Index size = run.tau.size();
    tau.segment(row, size) = run.tau;
    movement.middleRows(row, size).rowwise() = run.from - run.to;
    rest.middleRows(row, size) = off_line(run);
    mean_square += (run.from - run.to).cwiseAbs2().transpose();
    row += size;
  }
  mean_square /= static_cast<double>(data.runs.size());
  MatrixXd result = MatrixXd::Constant(2, coefficients, std::numeric_limits<double>::quiet_NaN());
  // The constants of cos(pi tau / 2), lightly damped.
  const Eigen::Vector2d quarter_swing(0.5, 2.5);
  for (Index i = 0; i < coefficients; ++i) {
    if (!(mean_square[i] >= least_movement * least_movement) || frames < 2) continue;
    const bool has_start = start.cols() == coefficients && !std::isnan(start(0, i));
    result.col(i) = fit_one(tau, movement.col(i), rest.col(i),
                            has_start ? Eigen::Vector2d(start.col(i)) : quarter_swing);
  }
  return result;
}

}  // namespace wavecurve::gait
