#include "wavecurve/certified/moments.hpp"

#include <stdexcept>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

/// m_k = sum_n n^k a_n / 2, k = 0 .. highest.
std::vector<Ball> discrete_moments(const Filter<Ball>& a, int highest) {
  std::vector<Ball> result;
  for (int k = 0; k <= highest; ++k) {
    Ball sum(0);
    for (int n = a.first_index; n <= a.last_index(); ++n) {
      sum += pow(Ball(n), static_cast<unsigned long>(k)) * a[n];
    }
    result.push_back(sum / Ball(2));
  }
  return result;
}

/// sum_{k=first}^p binomial(p, k) m_k M_{p-k}.
Ball convolution(const std::vector<Ball>& m, const std::vector<Ball>& moments, int p, int first) {
  Ball sum(0);
  for (int k = first; k <= p; ++k) {
    const Rational binomial =
        Rational::binomial(static_cast<unsigned long>(p), static_cast<unsigned long>(k));
    sum +=
        Ball(binomial) * m[static_cast<std::size_t>(k)] * moments[static_cast<std::size_t>(p - k)];
  }
  return sum;
}

std::vector<Ball> scaling_moments(const Filter<Ball>& a, int highest) {
  const std::vector<Ball> m = discrete_moments(a, highest);
  std::vector<Ball> result{Ball(1)};
  for (int p = 1; p <= highest; ++p) {
    result.push_back(convolution(m, result, p, 1) / Ball(Rational::power_of_two(p) - Rational(1)));
  }
  return result;
}

}  // namespace

std::vector<Ball> moments(const FilterDefinition& definition, const BasisFunction& f, int highest,
                          long bits) {
  check_between("moment", highest, 0, highest_moment);
  if (f.derivative != 0) {
    throw std::invalid_argument("moments of " + name_of(f) +
                                " are those of its function, by parts");
  }
  const WorkingPrecision precision(bits);
  const FilterBank<Ball> bank = definition.bank(bits);
  std::vector<Ball> result =
      scaling_moments(two_scale_coefficients(bank, {false, f.dual, 0}), highest);
  if (!f.wavelet) return result;
  const std::vector<Ball> scaling = result;
  const std::vector<Ball> m = discrete_moments(two_scale_coefficients(bank, f), highest);
  const int vanishing = f.dual ? bank.vanishing_moments : bank.dual_vanishing_moments;
  for (int p = 0; p <= highest; ++p) {
    result[static_cast<std::size_t>(p)] =
        p < vanishing ? Ball(0) : convolution(m, scaling, p, 0) * Ball(Rational::power_of_two(-p));
  }
  return result;
}

}  // namespace wavecurve::certified
