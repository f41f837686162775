#include "wavecurve/motion/gait/model/fit_subcycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/correspondence.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;

Contour mean_outline(const LimbTrack& track) {
  Contour mean = Contour::Zero(track.outlines.front().rows(), 2);
  for (const Contour& outline : track.outlines) mean += outline;
  return mean / static_cast<double>(track.outlines.size());
}

/// The track with the first point that corresponds to the other's.
LimbTrack started_like(const LimbTrack& track, const LimbTrack& other) {
  const Index shift = best_shift(mean_outline(other), mean_outline(track));
  LimbTrack result{track.limb, {}};
  for (const Contour& outline : track.outlines) {
    result.outlines.push_back(started_at(outline, shift));
  }
  return result;
}

/// The pair of a limb; where one is missing, its record is the other's, half a period later.
struct Pair {
  LimbTrack left, right;
  double left_delay = 0, right_delay = 0;
  Index foot = 0;
};

Pair find_pair(const LimbTracks& tracks, const GaitCycle& cycle, char which) {
  const double period = cycle.period;
  const auto first = std::find_if(cycle.limbs.begin(), cycle.limbs.end(),
                                  [&](const LimbCycle& limb) { return limb.limb[1] == which; });
  const LimbTrack* left = find_track(tracks, std::string("L") + which);
  const LimbTrack* right = find_track(tracks, std::string("R") + which);
  if (left && right) return {*left, started_like(*right, *left), 0, 0, first->foot};
  if (left) return {*left, *left, 0, period / 2, first->foot};
  return {*right, *right, period / 2, 0, first->foot};
}

/// All runs of the record between two times, any number of periods earlier or later.
void append_runs(const Eigen::VectorXd& times, const LimbTrack& track, double begin, double end,
                 double period, std::vector<PhaseRun>& runs) {
  const double first = times[0], last = times[times.size() - 1];
  const double earlier = std::floor((begin - first) / period) * period;
  // What rounding puts a little outside the record is inside.
  const double slack = 1e-9 * (last - first);
  for (double shift = -earlier; end + shift <= last + slack; shift += period) {
    PhaseRun run = phase_run(times, track, begin + shift, end + shift);
    if (run.tau.size() > 0) runs.push_back(std::move(run));
  }
}

void check(const std::array<double, 2>& keys, const Eigen::VectorXd& times, double period) {
  for (int i : {0, 1}) {
    const double key = keys[static_cast<std::size_t>(i)];
    if (!(key >= times[0] && key <= times[times.size() - 1])) {
      throw std::invalid_argument(
          fmt::format("key frame {} is at {}, but the record is from {} to {}", i + 1, key,
                      times[0], times[times.size() - 1]));
    }
  }
  if (!(keys[1] > keys[0] && keys[1] < keys[0] + period / 2)) {
    throw std::invalid_argument(
        fmt::format("key frame 2 is {} after key frame 1, but must be after it by less than half a "
                    "period, {}",
                    keys[1] - keys[0], period / 2));
  }
}

/// Key frames 1, 2, 1', 2' and 1 again, the number 0 .. 4.
double key_time(const std::array<double, 2>& keys, int number, double period) {
  return keys[static_cast<std::size_t>(number % 2)] + number / 2 * period / 2;
}

double after_touch_down(double time, const GaitCycle& cycle) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Reversal& reversal : cycle.limbs.front().reversals) {
    const double lag = time - reversal.time;
    if (reversal.touch_down && std::abs(lag) < std::abs(nearest)) nearest = lag;
  }
  const double share = nearest / cycle.period;
  return share - std::floor(share);
}

PhaseData runs_of(const Eigen::VectorXd& times, const Pair& pair, const std::array<double, 2>& keys,
                  int subcycle, double period) {
  PhaseData data{std::string(1, static_cast<char>('A' + subcycle)), {}, 0, 1};
  const double begin = key_time(keys, subcycle, period), end = key_time(keys, subcycle + 1, period);
  const double left = pair.left_delay, right = period / 2 + pair.right_delay;
  append_runs(times, pair.left, begin + left, end + left, period, data.runs);
  append_runs(times, pair.right, begin + right, end + right, period, data.runs);
  return data;
}

/// The pose of a left limb: at 1 and 2 its own, at 1' and 2' the right one's of 1 and 2.
Contour key_pose(const Eigen::VectorXd& times, const Pair& pair, const std::array<double, 2>& keys,
                 int number, double period) {
  const bool is_own = number < 2;
  double time = key_time(keys, number % 2, period) + (is_own ? pair.left_delay : pair.right_delay);
  if (time > times[times.size() - 1]) time -= period;
  return outline_at(times, is_own ? pair.left : pair.right, time);
}

}  // namespace

std::array<double, 2> automatic_key_frames(const GaitCycle& cycle) {
  for (const Reversal& reversal : cycle.limbs.front().reversals) {
    if (!reversal.touch_down) return {reversal.time, reversal.time + cycle.period / 4};
  }
  throw std::invalid_argument("no limb lifts off");
}

Subcycles fit_subcycles(const LimbTracks& tracks, const GaitCycle& cycle,
                        const std::array<double, 2>& keys, const ModelSetting& setting) {
  check(keys, tracks.times, cycle.period);
  const double offset = after_touch_down(keys[0], cycle);
  Subcycles result;
  for (char which : {'F', 'H'}) {
    const Pair pair = find_pair(tracks, cycle, which);
    LimbPath path{std::string("L") + which, pair.foot, offset, {}};
    for (int subcycle = 0; subcycle < 4; ++subcycle) {
      PhaseData data = runs_of(tracks.times, pair, keys, subcycle, cycle.period);
      if (data.runs.empty()) {
        throw std::invalid_argument(fmt::format(
            "the record shows no frame of subcycle {} of limb {}", data.phase, path.limb));
      }
      PhaseGammas gammas = phase_gammas(data, setting);
      gammas.limb = path.limb;
      const double key = key_time(keys, subcycle, cycle.period);
      path.spans.push_back({data.phase,
                            (key_time(keys, subcycle + 1, cycle.period) - key) / cycle.period,
                            key_pose(tracks.times, pair, keys, subcycle, cycle.period),
                            {GaitModel::quadratic, gammas.gamma.transpose(), 0, 1}});
      result.gammas.push_back(std::move(gammas));
      result.data.push_back(std::move(data));
    }
    result.paths.push_back(std::move(path));
  }
  return result;
}

}  // namespace wavecurve::gait
