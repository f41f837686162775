#include "wavecurve/curves/correspondence.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <unsupported/Eigen/FFT>

#include <fmt/format.h>

namespace wavecurve {

namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using In = const Eigen::Ref<const Contour>&;

/// The points as complex numbers about their mean.
VectorXcd centred(In contour) {
  VectorXcd points(contour.rows());
  points.real() = contour.col(0).array() - contour.col(0).mean();
  points.imag() = contour.col(1).array() - contour.col(1).mean();
  return points;
}

void check_sizes(In from, In to) {
  if (from.rows() == to.rows() && from.rows() > 0) return;
  throw std::invalid_argument(
      fmt::format("contours of {} and {} points; to correspond they need the same number, at "
                  "least 1",
                  from.rows(), to.rows()));
}

/// The first of the shifts whose correlation is the largest but for rounding. An FFT of length N
/// errs by at most a few log2 N units of rounding of the norms, and a sum of N products by N.
Index first_best(const VectorXcd& correlation, Rotation rotation, double rounding) {
  const Eigen::VectorXd value = rotation == Rotation::taken_out
                                    ? Eigen::VectorXd(correlation.cwiseAbs())
                                    : Eigen::VectorXd(correlation.real());
  const double least = value.maxCoeff() - rounding;
  Index shift = 0;
  while (!(value(shift) >= least)) ++shift;
  return shift;
}

double rounding(const VectorXcd& z, const VectorXcd& w) {
  return std::numeric_limits<double>::epsilon() * static_cast<double>(z.size()) * z.norm() *
         w.norm();
}

}  // namespace

Eigen::Index best_shift(In from, In to, Rotation rotation) {
  check_sizes(from, to);
  if (!from.allFinite() || !to.allFinite()) {
    throw std::domain_error("contours that are to correspond must have finite coordinates");
  }
  if (from.rows() == 1) return 0;  // Eigen's FFT takes no single point
  const VectorXcd z = centred(from), w = centred(to);
  Eigen::FFT<double> fft;
  VectorXcd z_hat(z.size()), w_hat(w.size()), correlation(z.size());
  fft.fwd(z_hat, z);
  fft.fwd(w_hat, w);
  w_hat = z_hat.conjugate().cwiseProduct(w_hat);
  fft.inv(correlation, w_hat);
  return first_best(correlation, rotation, rounding(z, w));
}

Contour started_at(In contour, Eigen::Index shift) {
  const Index count = contour.rows();
  if (shift < 0 || (shift >= count && shift > 0)) {
    throw std::invalid_argument(
        fmt::format("start {} lies outside the points 0 .. {} of the contour", shift, count - 1));
  }
  Contour started(count, 2);
  started << contour.bottomRows(count - shift), contour.topRows(shift);
  return started;
}

}  // namespace wavecurve

namespace wavecurve::plain {

Eigen::Index best_shift(In from, In to, Rotation rotation) {
  check_sizes(from, to);
  const VectorXcd z = centred(from), w = centred(to);
  const Index count = z.size();
  VectorXcd correlation = VectorXcd::Zero(count);
  for (Index s = 0; s < count; ++s) {
    for (Index i = 0; i < count; ++i) correlation(s) += std::conj(z(i)) * w((i + s) % count);
  }
  return first_best(correlation, rotation, rounding(z, w));
}

}  // namespace wavecurve::plain
