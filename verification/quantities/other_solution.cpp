#include "verification/quantities/other_solution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "wavecurve/elementary/root.hpp"

namespace wavecurve::verification {

namespace {

constexpr double tolerance = 1e-6;

double sum_of(const std::vector<double>& taps) {
  double sum = 0;
  for (const double tap : taps) sum += tap;
  return sum;
}

bool is_orthonormal(const std::vector<double>& taps) {
  for (std::size_t shift = 0; shift < taps.size(); shift += 2) {
    double product = 0;
    for (std::size_t i = 0; i + shift < taps.size(); ++i) product += taps[i] * taps[i + shift];
    if (std::abs(product - (shift == 0 ? 1 : 0)) > tolerance) return false;
  }
  return true;
}

/// sum_n s^n (n - centre)^p h_n, relative to the sum of the magnitudes.
double moment(const std::vector<double>& taps, double centre, int p, double s) {
  double sum = 0, magnitudes = 0, sign = 1;
  for (std::size_t n = 0; n < taps.size(); ++n, sign *= s) {
    const double term = whole_power(static_cast<double>(n) - centre, p) * taps[n];
    sum += sign * term;
    magnitudes += std::abs(term);
  }
  return magnitudes == 0 ? 0 : sum / magnitudes;
}

/// How many orders from `first` on vanish in a row.
int vanishing_orders(const std::vector<double>& taps, double centre, int first, double s) {
  int p = first;
  while (p < static_cast<int>(taps.size()) && std::abs(moment(taps, centre, p, s)) < tolerance) ++p;
  return p - first;
}

}  // namespace

std::string describe_solution(const std::vector<double>& taps) {
  const double sum = sum_of(taps);
  constexpr std::size_t shortest = 4;
  if (taps.size() < shortest || taps.size() % 2 != 0 || std::abs(sum) < tolerance) return "";
  std::vector<double> normal = taps;
  for (double& tap : normal) tap *= std::numbers::sqrt2 / sum;
  if (!is_orthonormal(normal)) return "";
  const int of_psi = vanishing_orders(normal, 0, 0, -1);
  double first_moment = 0;
  for (std::size_t n = 0; n < normal.size(); ++n)
    first_moment += static_cast<double>(n) * normal[n];
  const double centre = std::round(first_moment / std::numbers::sqrt2);
  const int of_phi = vanishing_orders(normal, centre, 1, 1);
  const int length = static_cast<int>(taps.size());
  const auto counted = [](int count) {
    return fmt::format("{} vanishing moment{}", count, count == 1 ? "" : "s");
  };
  if (length % 6 == 0 && of_psi >= length / 3 && of_phi >= length / 3 - 1) {
    return fmt::format(
        "a coiflet of this length ({} of psi, {} of phi): another solution of the same equations",
        counted(of_psi), of_phi);
  }
  if (of_psi == length / 2) {
    return fmt::format(
        "an orthonormal filter of this length with {}: another choice of the roots of the same "
        "polynomial",
        counted(of_psi));
  }
  if (2 * of_psi < length / 2) return "";
  return fmt::format("an orthonormal filter with {}", counted(of_psi));
}

}  // namespace wavecurve::verification
