#include "wavecurve/dynamics/modal/detail/modal_propagator.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace wavecurve::dynamics {

namespace {

/// a sum + b second + c third, mode by mode, in the place of sum; empty spectra are zero.
ModalCoefficients combination(const ModalBasis& basis, const Eigen::ArrayXd& a,
                              ModalCoefficients sum, const Eigen::ArrayXd& b,
                              const ModalCoefficients& second, const Eigen::ArrayXd& c,
                              const ModalCoefficients& third) {
  for (Eigen::Index j = 0; j < sum.cols(); ++j) {
    // The usual case in one pass, without a decision in its loop.
    if (second.size() > 0) {
      for (Eigen::Index k = 0; k < sum.rows(); ++k) {
        const Eigen::Index n = basis.mode(k);
        sum(k, j) = a[n] * sum(k, j) + b[n] * second(k, j);
      }
    } else {
      for (Eigen::Index k = 0; k < sum.rows(); ++k) sum(k, j) *= a[basis.mode(k)];
    }
    if (third.size() == 0) continue;
    for (Eigen::Index k = 0; k < sum.rows(); ++k) sum(k, j) += c[basis.mode(k)] * third(k, j);
  }
  return sum;
}

}  // namespace

Oscillator oscillator(const CirculantEigenvalues& modes, Eigen::Index mode) {
  return {modes.mass[mode], modes.damping[mode], modes.stiffness[mode]};
}

ModalPropagator::ModalPropagator(const CirculantEigenvalues& modes, double t,
                                 bool from_displacement_only) {
  const Eigen::Index size = modes.mass.size();
  qq_.resize(size);
  if (!from_displacement_only) {
    for (Eigen::ArrayXd* array : {&qv_, &vq_, &vv_, &qf_, &vf_}) array->resize(size);
  }
  constexpr Eigen::Index most = 256;  // at a time, so that they stay in the cache
  std::vector<Oscillator> oscillators;
  std::vector<Propagator> solutions(most);
  for (Eigen::Index first = 0; first < size; first += most) {
    oscillators.clear();
    for (Eigen::Index n = first; n < std::min(first + most, size); ++n) {
      oscillators.push_back(oscillator(modes, n));
    }
    propagators(oscillators, t, solutions);
    for (std::size_t i = 0; i < oscillators.size(); ++i) {
      const Eigen::Index n = first + static_cast<Eigen::Index>(i);
      const Propagator& p = solutions[i];
      qq_[n] = p.qq;
      if (from_displacement_only) continue;
      qv_[n] = p.qv;
      vq_[n] = p.vq;
      vv_[n] = p.vv;
      qf_[n] = p.qf;
      vf_[n] = p.vf;
    }
  }
}

ModalPropagator ModalPropagator::then(const ModalPropagator& other) const {
  ModalPropagator sum;
  sum.qq_ = other.qq_ * qq_ + other.qv_ * vq_;
  sum.qv_ = other.qq_ * qv_ + other.qv_ * vv_;
  sum.vq_ = other.vq_ * qq_ + other.vv_ * vq_;
  sum.vv_ = other.vq_ * qv_ + other.vv_ * vv_;
  sum.qf_ = other.qq_ * qf_ + other.qv_ * vf_ + other.qf_;
  sum.vf_ = other.vq_ * qf_ + other.vv_ * vf_ + other.vf_;
  return sum;
}

ModalState ModalPropagator::advance(const ModalBasis& basis, const ModalState& state,
                                    const ModalCoefficients& force, bool velocities) const {
  return advance(basis, state.displacement, state.velocity, force, velocities);
}

ModalState ModalPropagator::advance(const ModalBasis& basis, ModalCoefficients displacement,
                                    const ModalCoefficients& velocity,
                                    const ModalCoefficients& force, bool velocities) const {
  ModalState result;
  if (velocities) {
    result.velocity = combination(basis, vq_, displacement, vv_, velocity, vf_, force);
  }
  result.displacement = combination(basis, qq_, std::move(displacement), qv_, velocity, qf_, force);
  return result;
}

}  // namespace wavecurve::dynamics
