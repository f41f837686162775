#include "wavecurve/curves/correspondence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/transform/fourier_transform.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using In = const Eigen::Ref<const Contour>&;

/// The points as complex numbers about their mean, scaled to norm 1 unless they are all the same.
VectorXcd normalised(In contour) {
  Contour centred(contour.rows(), 2);
  for (Index j = 0; j < 2; ++j) {
    centred.col(j) = contour.col(j).array() - contour.col(j).mean();
  }
  const double norm = centred.norm();
  if (!std::isfinite(norm)) {
    throw std::domain_error(
        "contours that are to correspond have coordinates beyond what can be added up");
  }
  if (norm > 0) centred *= 1 / norm;
  VectorXcd points(contour.rows());
  points.real() = centred.col(0);
  points.imag() = centred.col(1);
  return points;
}

void check_sizes(In from, In to) {
  if (from.rows() == to.rows() && from.rows() > 0) return;
  throw std::invalid_argument(
      fmt::format("contours of {} and {} points; to correspond they need the same number, at "
                  "least 1",
                  from.rows(), to.rows()));
}

/// The first of the shifts whose correlation is the largest but for rounding. For contours of
/// norm 1, as these are, an FFT of length N errs by at most a few log2 N units of rounding, and a sum of N
/// products by N.
Index first_best(const VectorXcd& correlation, Rotation rotation) {
  const double rounding =
      std::numeric_limits<double>::epsilon() * static_cast<double>(correlation.size());
  Eigen::VectorXd value = correlation.real();
  if (rotation == Rotation::taken_out) value = correlation.cwiseAbs2();
  double least = value.maxCoeff() - rounding;
  if (rotation == Rotation::taken_out) {
    least = std::max(std::sqrt(value.maxCoeff()) - rounding, 0.0);
    least *= least;
  }
  Index shift = 0;
  while (!(value(shift) >= least)) ++shift;
  return shift;
}

}  // namespace

Eigen::Index best_shift(In from, In to, Rotation rotation) {
  check_sizes(from, to);
  if (!from.allFinite() || !to.allFinite()) {
    throw std::domain_error("contours that are to correspond must have finite coordinates");
  }
  VectorXcd z = normalised(from), w = normalised(to);
  FourierTransform fourier(z.size());
  fourier.forward(z);
  fourier.forward(w);
  for (Index k = 0; k < w.size(); ++k) {
    // conj(z) w, without the check for infinities that std::complex pays for.
    w(k) = {z(k).real() * w(k).real() + z(k).imag() * w(k).imag(),
            z(k).real() * w(k).imag() - z(k).imag() * w(k).real()};
  }
  fourier.inverse(w);
  return first_best(w, rotation);
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
  const VectorXcd z = normalised(from), w = normalised(to);
  const Index count = z.size();
  VectorXcd correlation = VectorXcd::Zero(count);
  for (Index s = 0; s < count; ++s) {
    for (Index i = 0; i < count; ++i) correlation(s) += std::conj(z(i)) * w((i + s) % count);
  }
  return first_best(correlation, rotation);
}

}  // namespace wavecurve::plain
