#include "wavecurve/filters/spline_filter.hpp"

#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

namespace wavecurve {

namespace {

using Integer = boost::multiprecision::cpp_int;

constexpr int highest_order = 100;

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

std::optional<int> whole_number(std::string_view text) {
  if (text.empty() || text.front() < '1' || text.front() > '9') return std::nullopt;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

void require_orders(std::string_view name, int order, int dual_order) {
  for (const int n : {order, dual_order}) {
    if (n < 1 || n > highest_order) {
      throw std::invalid_argument("filter " + std::string(name) + ": its order " +
                                  std::to_string(n) + " must lie in 1 .. " +
                                  std::to_string(highest_order));
    }
  }
  if ((order + dual_order) % 2 != 0) {
    throw std::invalid_argument("filter " + std::string(name) + ": the sum of its orders " +
                                std::to_string(order) + " + " + std::to_string(dual_order) +
                                " must be even");
  }
}

}  // namespace

template <class Scalar>
std::optional<FilterBank<Scalar>> spline_filter_bank(std::string_view name) {
  constexpr std::string_view prefix = "bspline";
  const auto dot = name.find('.');
  if (!name.starts_with(prefix) || dot == std::string_view::npos) return std::nullopt;
  const auto order = whole_number(name.substr(prefix.size(), dot - prefix.size()));
  const auto dual_order = whole_number(name.substr(dot + 1));
  if (!order || !dual_order) return std::nullopt;
  require_orders(name, *order, *dual_order);
  const int half_sum = (*order + *dual_order) / 2;
  const auto dual = product(binomials(*dual_order), scaled_halfband(half_sum));
  auto bank = make_filter_bank(
      std::string(name),
      rounded<Scalar>(1 - half_sum - *dual_order / 2, dual, *dual_order + 2 * (half_sum - 1)),
      rounded<Scalar>(-(*order / 2), binomials(*order), *order));
  bank.vanishing_moments = *order;
  bank.dual_vanishing_moments = *dual_order;
  bank.sobolev_exponent = *order - 0.5;  // the Fourier transform decays like |w|^-D
  return bank;
}

template std::optional<FilterBank<double>> spline_filter_bank(std::string_view);
template std::optional<FilterBank<float>> spline_filter_bank(std::string_view);

}  // namespace wavecurve
