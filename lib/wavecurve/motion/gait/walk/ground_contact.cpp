#include "wavecurve/motion/gait/walk/ground_contact.hpp"

#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::gait {

double CyclePart::since(double u) const {
  const double past = u - begin;
  return past - std::floor(past);
}

CyclePart ground_contact(const LimbPath& path, double facing) {
  constexpr int steps = 256;
  const LimbPath foot = path_of_point(path, path.foot);
  Eigen::VectorXd forwards(steps);
  for (int i = 0; i < steps; ++i) {
    forwards[i] = facing * pose_at(foot, i / static_cast<double>(steps))(0, 0);
  }
  int foremost = 0, rearmost = 0;
  const double excursion = forwards.maxCoeff(&foremost) - forwards.minCoeff(&rearmost);
  if (!(excursion > 0)) {
    throw std::invalid_argument(fmt::format("the foot of limb '{}' does not move", path.limb));
  }
  const double least = 0.7 * excursion / ((rearmost - foremost + steps) % steps);
  const auto at = [&](int i) { return forwards[(i + steps) % steps]; };
  // The speed over a 16th of the cycle, so that a foot that falters still stands.
  constexpr int reach = steps / 32;
  const auto stands = [&](int i) { return at(i - reach) - at(i + reach) > 2 * reach * least; };
  CyclePart longest;
  for (int begin = 0; begin < steps; ++begin) {
    if (!stands(begin) || stands(begin - 1)) continue;
    int length = 1;
    while (length < steps && stands(begin + length)) ++length;
    if (length > longest.length * steps) {
      longest = {begin / static_cast<double>(steps), length / static_cast<double>(steps)};
    }
  }
  return longest;
}

}  // namespace wavecurve::gait
