#include "wavecurve/motion/gait/model/detail/fit_series.hpp"

#include <algorithm>

#include <Eigen/Dense>

#include "wavecurve/motion/gait/model/detail/deviation_basis.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// basis * unknowns = values, one row a frame.
struct LinearFit {
  MatrixXd basis, values;
  Index wanted = 0;  ///< rows of the result
};

Index frames_of(const PhaseData& data) {
  Index frames = 0;
  for (const PhaseRun& run : data.runs) frames += run.tau.size();
  return frames;
}

Index coefficients_of(const PhaseData& data) { return data.runs.front().from.size(); }

LinearFit polynomial_system(const PhaseData& data, int degree) {
  const Index frames = frames_of(data), wanted = degree - 1;
  const Index terms = std::min(wanted, frames);
  LinearFit fit{MatrixXd(frames, terms), MatrixXd(frames, coefficients_of(data)), wanted};
  Index row = 0;
  for (const PhaseRun& run : data.runs) {
    fit.values.middleRows(row, run.tau.size()) = off_line(run);
    for (double tau : run.tau) fit.basis.row(row++) = bridge_basis(tau, terms).transpose();
  }
  return fit;
}

LinearFit fourier_system(const std::vector<PhaseData>& phases, int terms) {
  Index frames = 0;
  for (const PhaseData& data : phases) frames += frames_of(data);
  LinearFit fit{MatrixXd(frames, terms), MatrixXd(frames, coefficients_of(phases.front())), terms};
  Index row = 0;
  for (const PhaseData& data : phases) {
    for (const PhaseRun& run : data.runs) {
      fit.values.middleRows(row, run.tau.size()) = run.points;
      for (double tau : run.tau) {
        const double u = data.begin + tau * (data.end - data.begin);
        fit.basis.row(row++) = fourier_basis(u, terms).transpose();
      }
    }
  }
  return fit;
}

MatrixXd padded(const MatrixXd& solution, Index rows) {
  MatrixXd result = MatrixXd::Zero(rows, solution.cols());
  result.topRows(solution.rows()) = solution;
  return result;
}

MatrixXd by_normal_equations(const LinearFit& fit) {
  const MatrixXd normal = fit.basis.transpose() * fit.basis;
  return padded(normal.ldlt().solve(fit.basis.transpose() * fit.values), fit.wanted);
}

MatrixXd by_qr(const LinearFit& fit) {
  MatrixXd solution(fit.basis.cols(), fit.values.cols());
  for (Index i = 0; i < solution.cols(); ++i) {
    solution.col(i) = fit.basis.colPivHouseholderQr().solve(fit.values.col(i));
  }
  return padded(solution, fit.wanted);
}

}  // namespace

MatrixXd fit_polynomial(const PhaseData& data, int degree) {
  return by_normal_equations(polynomial_system(data, degree));
}

MatrixXd fit_fourier(const std::vector<PhaseData>& phases, int terms) {
  return by_normal_equations(fourier_system(phases, terms));
}

namespace plain {

MatrixXd fit_polynomial(const PhaseData& data, int degree) {
  return by_qr(polynomial_system(data, degree));
}

MatrixXd fit_fourier(const std::vector<PhaseData>& phases, int terms) {
  return by_qr(fourier_system(phases, terms));
}

}  // namespace plain

}  // namespace wavecurve::gait
