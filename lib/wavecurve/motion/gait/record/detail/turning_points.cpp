#include "wavecurve/motion/gait/record/detail/turning_points.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

double usual_range(VectorXd values) {
  std::sort(values.begin(), values.end());
  const Index outside = values.size() / 20;
  return values[values.size() - 1 - outside] - values[outside];
}

/// Frames of extremes that both sides come back from by more than the threshold.
std::vector<Index> extremes(const VectorXd& values, double threshold) {
  std::vector<Index> found;
  Index highest = 0, lowest = 0;
  int direction = 0;  // 1: on the way up
  for (Index i = 1; i < values.size(); ++i) {
    if (values[i] > values[highest]) highest = i;
    if (values[i] < values[lowest]) lowest = i;
    if (direction >= 0 && values[highest] - values[i] > threshold) {
      found.push_back(highest);
      direction = -1;
      lowest = i;
    } else if (direction <= 0 && values[i] - values[lowest] > threshold) {
      found.push_back(lowest);
      direction = 1;
      highest = i;
    }
  }
  // The first frame is where the record begins, not where the foot turned.
  if (!found.empty() && found.front() == 0) found.erase(found.begin());
  return found;
}

TurningPoint vertex(const VectorXd& times, const VectorXd& values, Index at, double near) {
  Index first = at - 1, last = at + 1;
  while (first > 0 && std::abs(values[first - 1] - values[at]) < near) --first;
  while (last + 1 < values.size() && std::abs(values[last + 1] - values[at]) < near) ++last;
  const Index size = last - first + 1;
  const double unit = times[last] - times[first];
  const VectorXd t = (times.segment(first, size).array() - times[at]) / unit;
  Eigen::MatrixXd powers(size, 3);
  powers << VectorXd::Ones(size), t, t.cwiseAbs2();
  const Eigen::Vector3d c = powers.colPivHouseholderQr().solve(values.segment(first, size));
  const bool is_maximum = values[at] > values[first] || values[at] > values[last];
  const double place = c[2] == 0 ? 0 : -c[1] / (2 * c[2]);
  // A parabola that opens to the wrong side says nothing.
  if (is_maximum != (c[2] < 0) || place < t[0] || place > t[size - 1]) {
    return {times[at], values[at], is_maximum};
  }
  return {times[at] + place * unit, c[0] + place * (c[1] + place * c[2]), is_maximum};
}

}  // namespace

std::vector<TurningPoint> turning_points(const VectorXd& times, const VectorXd& values) {
  const double range = usual_range(values);
  std::vector<TurningPoint> turns;
  for (Index at : extremes(values, 0.4 * range)) {
    turns.push_back(vertex(times, values, at, 0.1 * range));
  }
  return turns;
}

}  // namespace wavecurve::gait
