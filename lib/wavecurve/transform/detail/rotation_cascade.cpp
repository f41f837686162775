#include "wavecurve/transform/detail/rotation_cascade.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wavecurve {

namespace {

using Row = Eigen::RowVector2d;

/// Taps of two filters, a row for each pair of taps: low_k and high_k act on (u_{n+k}, v_{n+k}).
struct PolyphasePair {
  std::vector<Row> low, high;
};

template <class Scalar>
std::vector<Row> pairs_of(const Filter<Scalar>& filter) {
  std::vector<Row> pairs;
  for (int n = filter.first_index; n < filter.last_index(); n += 2) {
    pairs.emplace_back(static_cast<double>(filter[n]), static_cast<double>(filter[n + 1]));
  }
  return pairs;
}

/// Takes the last rotation off. For an orthonormal pair the first rows are parallel, the last ones
/// too, and one rotation clears the last of low and the first of high; of both the tangent is
/// taken, weighted by their size.
double take_off_rotation(PolyphasePair& taps) {
  const Row low_0 = taps.low.front(), high_0 = taps.high.front();
  const Row low_n = taps.low.back(), high_n = taps.high.back();
  const double t =
      (low_n.dot(high_n) - low_0.dot(high_0)) / (low_0.squaredNorm() + high_n.squaredNorm());
  const double cosine = 1 / std::sqrt(1 + t * t), sine = t * cosine;
  for (std::size_t k = 0; k < taps.low.size(); ++k) {
    const Row low = taps.low[k], high = taps.high[k];
    taps.low[k] = cosine * low - sine * high;
    taps.high[k] = sine * low + cosine * high;
  }
  taps.low.pop_back();
  taps.high.erase(taps.high.begin());
  return t;
}

/// The filters that the cascade amounts to.
PolyphasePair expand(const std::vector<double>& tangents, double scale) {
  PolyphasePair taps{{scale * Row(1, tangents[0])}, {scale * Row(-tangents[0], 1)}};
  for (std::size_t k = 1; k < tangents.size(); ++k) {
    taps.low.push_back(Row::Zero());
    taps.high.insert(taps.high.begin(), Row::Zero());
    for (std::size_t i = 0; i <= k; ++i) {
      const Row low = taps.low[i], high = taps.high[i];
      taps.low[i] = low + tangents[k] * high;
      taps.high[i] = high - tangents[k] * low;
    }
  }
  return taps;
}

double largest_difference(const std::vector<Row>& a, const std::vector<Row>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, (a[k] - b[k]).cwiseAbs().maxCoeff());
  }
  return largest;
}

/// The determinant of the polyphase matrix at z = 1: +1 or -1 for an orthonormal pair.
double determinant(const PolyphasePair& taps) {
  Row low = Row::Zero(), high = Row::Zero();
  for (const Row& row : taps.low) low += row;
  for (const Row& row : taps.high) high += row;
  return low[0] * high[1] - low[1] * high[0];
}

}  // namespace

template <class Scalar>
std::optional<RotationCascade<Scalar>> rotation_cascade(const Filter<Scalar>& low,
                                                        const Filter<Scalar>& high) {
  const int parity = low.first_index & 1;
  if (low.size() % 2 != 0 || low.size() == 0 || high.size() != low.size() ||
      low.size() > 2 * RotationCascade<Scalar>::max_size || (high.first_index & 1) != parity) {
    return std::nullopt;
  }
  PolyphasePair taps{pairs_of(low), pairs_of(high)};
  // A rotation has determinant 1: the other sign belongs to high.
  const double sign = determinant(taps) < 0 ? -1 : 1;
  for (Row& row : taps.high) row *= sign;
  PolyphasePair rest = taps;
  std::vector<double> tangents;
  while (rest.low.size() > 1) tangents.push_back(take_off_rotation(rest));
  const Row low_0 = rest.low.front(), high_0 = rest.high.front();
  tangents.push_back((low_0[1] - high_0[0]) / (low_0[0] + high_0[1]));
  std::reverse(tangents.begin(), tangents.end());

  double gain = 1;
  for (double& t : tangents) {
    t = static_cast<double>(static_cast<Scalar>(t));  // the scale and the check are of what is used
    gain *= std::sqrt(1 + t * t);
  }
  const double scale = (low_0[0] < 0 ? -1 : 1) / gain;
  if (!(gain <= 0x1p30)) return std::nullopt;
  const PolyphasePair expanded = expand(tangents, scale);
  // A tap passes through K rotations, each with a rounded tangent: relative to the filter's norm 1
  // an error of half a unit each, and as much again where the double tables are the input.
  const double tolerance =
      tangents.size() * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  if (!(largest_difference(expanded.low, taps.low) <= tolerance &&
        largest_difference(expanded.high, taps.high) <= tolerance)) {
    return std::nullopt;
  }

  RotationCascade<Scalar> cascade;
  cascade.tangents.assign(tangents.begin(), tangents.end());
  cascade.reversed_tangents.assign(tangents.rbegin(), tangents.rend());
  cascade.low_scale = static_cast<Scalar>(scale);
  cascade.high_scale = static_cast<Scalar>(sign * scale);
  cascade.parity = parity;
  cascade.low_first = (low.first_index - parity) / 2;
  cascade.high_first = (high.first_index - parity) / 2;
  return cascade;
}

template std::optional<RotationCascade<double>> rotation_cascade(const Filter<double>&,
                                                                 const Filter<double>&);
template std::optional<RotationCascade<float>> rotation_cascade(const Filter<float>&,
                                                                const Filter<float>&);

}  // namespace wavecurve
