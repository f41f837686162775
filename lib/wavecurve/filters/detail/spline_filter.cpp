#include "wavecurve/filters/detail/spline_filter.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "wavecurve/filters/detail/filter_name.hpp"

namespace wavecurve {

namespace {

using Integer = boost::multiprecision::cpp_int;

std::vector<Integer> product(const std::vector<Integer>& a, const std::vector<Integer>& b) {
  std::vector<Integer> c(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

/// (1 + x)^order.
std::vector<Integer> binomials(int order) {
  std::vector<Integer> row{1};
  for (int i = 0; i < order; ++i) row = product(row, {1, 1});
  return row;
}

/// 4^{K-1} P_K(y) in x = e^{-iw}, P_K(y) = sum_{k<K} binomial(K-1+k, k) y^k, y = (-1/x + 2 - x)
/// / 4.
std::vector<Integer> scaled_halfband(int half_sum) {
  const auto degree = static_cast<std::size_t>(half_sum - 1);
  std::vector<Integer> sum(2 * degree + 1, 0);
  std::vector<Integer> four_y_power{1};
  Integer binomial = 1;
  for (std::size_t k = 0; k <= degree; ++k) {
    const Integer weight = binomial << (2 * (degree - k));
    for (std::size_t i = 0; i < four_y_power.size(); ++i) {
      sum[degree - k + i] += weight * four_y_power[i];
    }
    binomial = binomial * (degree + k + 1) / (k + 1);
    four_y_power = product(four_y_power, {-1, 2, -1});
  }
  return sum;
}

/// The floating point number nearest to n sqrt 2 / 2^shift. n sqrt 2 = sqrt(2 n^2) is irrational
/// for n other than 0, so that its integer part, carried to more bits than Scalar has, decides the
/// rounding when a final 1 stands for the rest.
template <class Scalar>
Scalar round_root_two_multiple(const Integer& n, int shift) {
  if (n == 0) return Scalar(0);
  constexpr int digits = std::numeric_limits<Scalar>::digits;
  const Integer square = 2 * n * n;
  const int bits = static_cast<int>(msb(square)) + 1;
  const int scale = std::max(0, digits + 2 - bits / 2);
  Integer root = sqrt(Integer(square << (2 * scale)));
  const int excess = static_cast<int>(msb(root)) + 1 - digits;  // at least 1 bit to round away
  const Integer remainder = root & ((Integer(1) << excess) - 1);
  root >>= excess;
  const bool up =
      remainder >= (Integer(1) << (excess - 1));  // a tie lies above the half: irrational
  if (up) ++root;
  const auto magnitude = std::ldexp(static_cast<Scalar>(root), excess - scale - shift);
  return n < 0 ? -magnitude : magnitude;
}

template <class Scalar>
Filter<Scalar> rounded(int first_index, const std::vector<Integer>& numerators, int shift) {
  Filter<Scalar> filter{first_index, {}};
  for (const Integer& n : numerators) {
    filter.taps.push_back(round_root_two_multiple<Scalar>(n, shift));
  }
  return filter;
}

}  // namespace

template <class Scalar>
std::optional<FilterBank<Scalar>> spline_filter_bank(std::string_view name) {
  const auto orders = spline_orders(name);
  if (!orders) return std::nullopt;
  const auto [order, dual_order] = *orders;
  const int half_sum = (order + dual_order) / 2;
  const auto dual = product(binomials(dual_order), scaled_halfband(half_sum));
  auto bank = make_filter_bank(
      std::string(name),
      rounded<Scalar>(1 - half_sum - dual_order / 2, dual, dual_order + 2 * (half_sum - 1)),
      rounded<Scalar>(-(order / 2), binomials(order), order));
  bank.vanishing_moments = order;
  bank.dual_vanishing_moments = dual_order;
  bank.sobolev_exponent = order - 0.5;  // the Fourier transform decays like |w|^-D
  return bank;
}

template std::optional<FilterBank<double>> spline_filter_bank(std::string_view);
template std::optional<FilterBank<float>> spline_filter_bank(std::string_view);

}  // namespace wavecurve
