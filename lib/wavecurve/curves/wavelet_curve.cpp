#include "wavecurve/curves/wavelet_curve.hpp"

#include <cmath>
#include <stdexcept>

#include "wavecurve/elementary/root.hpp"
#include "wavecurve/transform/detail/refinement_mask.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;

constexpr int prepared_orders = 3;

/// The coefficients, over whose chi a point in the first unit lies, at half the spacing: row i is
/// that of chi(x + i), and the point moves on by `bit` in the finer grid.
void halve(const std::vector<double>& mask, Index bit, Contour& window, Contour& finer) {
  const Index size = window.rows();
  for (Index j = 0; j < size; ++j) {
    Eigen::RowVector2d sum = Eigen::RowVector2d::Zero();
    for (Index i = 0; i < size; ++i) {
      const Index k = 2 * i + bit - j;
      if (k >= 0 && k <= size) sum += mask[static_cast<std::size_t>(k)] * window.row(i);
    }
    finer.row(j) = sum;
  }
  window.swap(finer);
}

/// c_n - c_{n-1} with period N, times N.
Contour backward_difference(const Contour& c) {
  const Index count = c.rows();
  Contour result(count, 2);
  for (Index n = 0; n < count; ++n) result.row(n) = c.row(n) - c.row((n + count - 1) % count);
  return static_cast<double>(count) * result;
}

}  // namespace

WaveletCurve::WaveletCurve(const FilterBank<double>& bank, const Contour& finest)
    : bank_(bank), finest_(finest) {
  orders_.push_back(refinable(0));
  try {
    while (orders_.size() < prepared_orders) {
      orders_.push_back(refinable(static_cast<int>(orders_.size())));
    }
  } catch (const std::domain_error&) {  // derivative says so, if it is asked for this order
  }
}

WaveletCurve::Refinable WaveletCurve::refinable(int order) const {
  Refinable result{finest_, refinement_mask(bank_, order), {}};
  result.integers = integer_values(result.mask);
  for (int i = 0; i < order; ++i) result.coefficients = backward_difference(result.coefficients);
  return result;
}

Eigen::Vector2d WaveletCurve::Refinable::value(double position, int first_index) const {
  constexpr int most_bits = 64;
  const Index size = integers.size() - 1, period = coefficients.rows();
  const double whole = std::floor(position);
  double x = position - whole;
  Contour window(size, 2), finer(size, 2);
  for (Index i = 0; i < size; ++i) {
    const Index n = (static_cast<Index>(whole) - first_index - i) % period;
    window.row(i) = coefficients.row(n < 0 ? n + period : n);
  }
  for (int i = 0; i < most_bits && x > 0; ++i) {
    x *= 2;
    const Index bit = x >= 1 ? 1 : 0;
    x -= static_cast<double>(bit);
    halve(mask, bit, window, finer);
  }
  return window.transpose() * integers.head(size);
}

Eigen::Vector2d WaveletCurve::derivative(double t, int order) const {
  const double position = (t - std::floor(t)) * static_cast<double>(finest_.rows());
  const int first_index = bank_.synthesis_low.first_index;
  if (order >= 0 && order < static_cast<int>(orders_.size())) {
    return orders_[static_cast<std::size_t>(order)].value(position, first_index);
  }
  return refinable(order).value(position, first_index);
}

Eigen::Vector2d WaveletCurve::tangent(double t) const { return derivative(t, 1).normalized(); }

double WaveletCurve::curvature(double t) const {
  const Eigen::Vector2d first = derivative(t, 1), second = derivative(t, 2);
  return (first.x() * second.y() - first.y() * second.x()) / whole_power(first.norm(), 3);
}

}  // namespace wavecurve
