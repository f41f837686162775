#include "wavecurve/motion/gait/model/phase_motion.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/motion/gait/model/detail/deviation_basis.hpp"
#include "wavecurve/motion/gait/model/detail/model_table.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::VectorXd;

void check(const PhaseMotion& motion, const Contour& from, const Contour& to) {
  if (from.rows() != to.rows() ||
      (motion.parameters.rows() > 0 && motion.parameters.cols() != 2 * from.rows())) {
    throw std::invalid_argument(
        fmt::format("key frames of {} and {} control points, and parameters of {} coefficients",
                    from.rows(), to.rows(), motion.parameters.cols()));
  }
}

}  // namespace

Contour pose_between(const PhaseMotion& motion, const Contour& from, const Contour& to,
                     double tau) {
  check(motion, from, to);
  const Contour difference = from - to;
  const VectorXd extra = row_of(motion.model).deviation(motion, difference.reshaped(), tau, 0);
  // Exact at both ends, so that a path closes to the last bit.
  Contour pose = (1 - tau) * from + tau * to;
  pose.reshaped() += extra;
  return pose;
}

Contour velocity_between(const PhaseMotion& motion, const Contour& from, const Contour& to,
                         double tau) {
  check(motion, from, to);
  const Contour difference = from - to;
  const VectorXd extra = row_of(motion.model).deviation(motion, difference.reshaped(), tau, 1);
  Contour velocity = -difference;
  velocity.reshaped() += extra;
  return velocity;
}

}  // namespace wavecurve::gait
