#include "wavecurve/motion/gait/model/detail/deviation_basis.hpp"

#include <cmath>
#include <numbers>

#include "wavecurve/elementary/sine_cosine.hpp"

namespace wavecurve::gait {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

/// P_k and their derivatives at x: (k + 1) P_{k+1} = (2 k + 1) x P_k - k P_{k-1}.
void legendre(double x, VectorXd& values, VectorXd& slopes) {
  const Index size = values.size();
  for (Index k = 0; k < size; ++k) {
    if (k < 2) {
      values[k] = k == 0 ? 1 : x;
      slopes[k] = k == 0 ? 0 : 1;
      continue;
    }
    const auto n = static_cast<double>(k);
    values[k] = ((2 * n - 1) * x * values[k - 1] - (n - 1) * values[k - 2]) / n;
    slopes[k] = slopes[k - 2] + (2 * n - 1) * values[k - 1];
  }
}

}  // namespace

VectorXd bridge_basis(double tau, Index size) {
  VectorXd values(size), slopes(size);
  legendre(2 * tau - 1, values, slopes);
  return tau * (1 - tau) * values;
}

VectorXd bridge_slope(double tau, Index size) {
  VectorXd values(size), slopes(size);
  legendre(2 * tau - 1, values, slopes);
  return (1 - 2 * tau) * values + 2 * tau * (1 - tau) * slopes;
}

VectorXd fourier_basis(double u, Index size) {
  VectorXd basis(size);
  for (Index i = 0; i < size; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>((i + 1) / 2) * u;
    basis[i] = i % 2 == 0 && i > 0 ? sine(angle) : cosine(angle);
  }
  return basis;
}

VectorXd fourier_slope(double u, Index size) {
  VectorXd slope(size);
  for (Index i = 0; i < size; ++i) {
    const double rate = 2 * std::numbers::pi * static_cast<double>((i + 1) / 2);
    slope[i] = i % 2 == 0 && i > 0 ? rate * cosine(rate * u) : -rate * sine(rate * u);
  }
  return slope;
}

OscillatorDeviation::OscillatorDeviation(double e, double k) : oscillator_{1, e, k} {
  const dynamics::Propagator whole = dynamics::propagator(oscillator_, 1);
  start_ = -whole.qq / whole.qv;
}

double OscillatorDeviation::value(double tau) const {
  const dynamics::Propagator now = dynamics::propagator(oscillator_, tau);
  return now.qq + now.qv * start_ - 1 + tau;
}

double OscillatorDeviation::slope(double tau) const {
  const dynamics::Propagator now = dynamics::propagator(oscillator_, tau);
  return now.vq + now.vv * start_ + 1;
}

}  // namespace wavecurve::gait
