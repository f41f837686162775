#include "verification/stand_ins/footfalls.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace wavecurve::verification {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

double wrapped(double share) { return share - std::floor(share); }

/// Shares of the cycle, by the time of the record, at which a foot touches down and lifts off.
struct Events {
  std::vector<double> down, up;
};

Events events_of(const gait::LimbTracks& tracks, const gait::GaitCycle& cycle,
                 const gait::LimbCycle& limb) {
  const gait::LimbTrack* const track = gait::find_track(tracks, limb.limb);
  const Index steps = tracks.times.size() - 1;
  VectorXd time(steps), excess(steps);  // of the speed backwards, over half of the ground's
  for (Index i = 0; i < steps; ++i) {
    const auto now = static_cast<std::size_t>(i);
    const double way = track->outlines[now + 1](limb.foot, 0) - track->outlines[now](limb.foot, 0);
    time[i] = (tracks.times[i] + tracks.times[i + 1]) / 2 / cycle.period;
    excess[i] =
        -cycle.facing * way / (tracks.times[i + 1] - tracks.times[i]) - cycle.ground_speed / 2;
  }
  Events events;
  for (Index i = 0; i + 1 < steps; ++i) {
    if ((excess[i] > 0) == (excess[i + 1] > 0)) continue;
    const double share = excess[i] / (excess[i] - excess[i + 1]);
    (excess[i] > 0 ? events.up : events.down).push_back(time[i] + share * (time[i + 1] - time[i]));
  }
  return events;
}

/// From each touch-down to the lift-off after it.
double mean_duration(const Events& events) {
  double sum = 0;
  int count = 0;
  for (const double down : events.down) {
    const auto up = std::upper_bound(events.up.begin(), events.up.end(), down);
    if (up == events.up.end()) continue;
    sum += *up - down;
    ++count;
  }
  if (count == 0) throw std::invalid_argument("a foot of the record never stands");
  return sum / count;
}

/// The mean of shares of the cycle that lie close together, on the circle.
double mean_share(const std::vector<double>& times) {
  double sum = 0;
  for (const double time : times) sum += wrapped(time - times[0] + 0.5) - 0.5;
  return times[0] + sum / static_cast<double>(times.size());
}

Footfalls from_first(Footfalls stances) {
  const double zero = stances[0].begin;
  for (gait::CyclePart& stance : stances) stance.begin = wrapped(stance.begin - zero);
  return stances;
}

void check_count(std::size_t limbs) {
  if (limbs != 4) throw std::invalid_argument(fmt::format("{} limbs, not 4", limbs));
}

}  // namespace

Footfalls recorded_footfalls(const gait::LimbTracks& tracks, const gait::GaitCycle& cycle) {
  check_count(cycle.limbs.size());
  Footfalls stances;
  for (std::size_t i = 0; i < 4; ++i) {
    const Events events = events_of(tracks, cycle, cycle.limbs[i]);
    stances[i].length = mean_duration(events);
    stances[i].begin = mean_share(events.down);
  }
  return from_first(stances);
}

Footfalls model_footfalls(const std::vector<gait::LimbPath>& paths, double facing) {
  check_count(paths.size());
  Footfalls stances;
  for (std::size_t i = 0; i < 4; ++i) stances[i] = gait::ground_contact(paths[i], facing);
  return from_first(stances);
}

}  // namespace wavecurve::verification
