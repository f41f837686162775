#include "wavecurve/curves/shape_distance.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/curves/detail/contour_spectrum.hpp"
#include "wavecurve/curves/sample_contour.hpp"
#include "wavecurve/curves/signed_area.hpp"
#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/transform/bands.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

Contour clockwise(const Contour& points) {
  return signed_area(points) < 0 ? Contour(points.colwise().reverse()) : points;
}

void check_equal_numbers(const Contour& from, const Contour& to) {
  if (from.rows() == to.rows()) return;
  throw std::invalid_argument(
      fmt::format("{} points, but {} of the other curve", from.rows(), to.rows()));
}

/// sum_k conj(Z_k) W_k e^(i k shift): how well the curves agree, and by which angle w is ahead.
std::complex<double> agreement(const VectorXcd& z, const VectorXcd& w, double shift) {
  return z.dot(moved(w, shift, 0));
}

/// The shift of the greatest agreement about one between whose neighbours it lies: the golden section.
double refined(const VectorXcd& z, const VectorXcd& w, double shift) {
  const double step = 2 * std::numbers::pi / static_cast<double>(z.size());
  const auto value = [&](double at) { return std::norm(agreement(z, w, at)); };
  const double golden = std::numbers::phi - 1;
  double low = shift - step, high = shift + step;
  double left = high - golden * (high - low), right = low + golden * (high - low);
  double at_left = value(left), at_right = value(right);
  // Each step leaves 0.618 of the interval: forty leave 4e-9, where a square shows no more difference.
  for (int i = 0; i < 40; ++i) {
    if (at_left > at_right) {
      high = right;
      right = left, at_right = at_left;
      left = high - golden * (high - low), at_left = value(left);
    } else {
      low = left;
      left = right, at_left = at_right;
      right = low + golden * (high - low), at_right = value(right);
    }
  }
  return (low + high) / 2;
}

/// |sum_n filter_n e^(-i n omega)|^2 / 2.
double gain(const Filter<double>& filter, double omega) {
  std::complex<double> sum = 0;
  for (std::size_t n = 0; n < filter.taps.size(); ++n) {
    const double angle = -omega * static_cast<double>(n);
    sum += filter.taps[n] * std::complex<double>(cosine(angle), sine(angle));
  }
  return std::norm(sum) / 2;
}

/// How much of a wave of that frequency each band takes, the coarsest first. With decimation left out, all
/// starting points are taken into account alike.
VectorXd band_shares(const FilterBank<double>& bank, int levels, double omega) {
  VectorXd shares(levels + 1);
  double rest = 1;
  for (int level = 0; level < levels; ++level) {
    shares[levels - level] = rest * gain(bank.analysis_high, omega);
    rest *= gain(bank.analysis_low, omega);
    omega *= 2;
  }
  shares[0] = rest;
  return shares;
}

VectorXcd of_first_ellipse(const Contour& points) {
  const VectorXcd spectrum = without_place_and_size(contour_spectrum(clockwise(points)));
  const FirstEllipse ellipse = first_ellipse(spectrum);
  const double size = std::abs(spectrum[1]) + std::abs(spectrum[spectrum.size() - 1]);
  if (!(size > 0)) throw std::invalid_argument("the first ellipse of a curve has no size");
  return moved(spectrum, ellipse.shift, ellipse.angle) / size;
}

}  // namespace

ShapeDistance shape_distance(const Contour& from, const Contour& to, const FilterBank<double>& bank,
                             int levels, bool closed) {
  if (!bank.is_orthonormal()) {
    throw std::invalid_argument(
        "the distance by scale takes an orthonormal filter, as coif2, but " + bank.name +
        " is none");
  }
  check_samples(from.rows());
  check_equal_numbers(from, to);
  multiscale_bands(from.rows(), levels);
  const Contour first = closed ? clockwise(from) : from, second = closed ? clockwise(to) : to;
  const VectorXcd z = without_place_and_size(contour_spectrum(first));
  const VectorXcd w = without_place_and_size(contour_spectrum(second));
  const double step = 2 * std::numbers::pi / static_cast<double>(z.size());
  ShapeDistance distance;
  if (closed) {
    const Index shift = best_shift(first, second, Rotation::taken_out);
    distance.shift = refined(z, w, static_cast<double>(shift) * step);
  } else {
    const double here = std::abs(agreement(z, w, 0));
    const double there = std::abs(agreement(z, w, std::numbers::pi));
    distance.shift = there > here ? std::numbers::pi : 0;
  }
  const std::complex<double> agreed = agreement(z, w, distance.shift);
  distance.angle = agreed == 0.0 ? 0 : -arctangent(agreed.imag(), agreed.real());
  const VectorXd difference = (z - moved(w, distance.shift, distance.angle)).cwiseAbs2();
  VectorXd squares = VectorXd::Zero(levels + 1);
  for (Index i = 0; i < difference.size(); ++i) {
    squares += difference[i] * band_shares(bank, levels, step * static_cast<double>(i));
  }
  distance.by_scale = squares.cwiseSqrt();
  distance.total = std::sqrt(difference.sum());
  return distance;
}

double elliptic_fourier_distance(const Contour& from, const Contour& to, int harmonics) {
  check_equal_numbers(from, to);
  check_at_least("harmonics", harmonics, 1);
  check_at_least("the number of points", from.rows(), 2L * harmonics + 1);
  const VectorXcd z = of_first_ellipse(from), w = of_first_ellipse(to);
  double nearest = std::numeric_limits<double>::infinity();
  for (const double turn : {0.0, std::numbers::pi}) {
    const VectorXcd difference = z - moved(w, turn, turn);
    const double squares =
        difference.segment(1, harmonics).squaredNorm() + difference.tail(harmonics).squaredNorm();
    nearest = std::min(nearest, std::sqrt(squares));
  }
  return nearest;
}

}  // namespace wavecurve
