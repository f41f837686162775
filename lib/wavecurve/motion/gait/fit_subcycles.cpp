#include "wavecurve/motion/gait/fit_subcycles.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/curves/correspondence.hpp"
#include "wavecurve/motion/gait/fit_gammas.hpp"

namespace wavecurve {

namespace {

using Eigen::Index;

const LimbTrack* find_track(const LimbTracks& tracks, const std::string& limb) {
  const auto found = std::find_if(tracks.limbs.begin(), tracks.limbs.end(),
                                  [&](const LimbTrack& track) { return track.limb == limb; });
  return found == tracks.limbs.end() ? nullptr : &*found;
}

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

}  // namespace

std::array<double, 2> automatic_key_frames(const GaitCycle& cycle) {
  for (const Reversal& reversal : cycle.limbs.front().reversals) {
    if (!reversal.touch_down) return {reversal.time, reversal.time + cycle.period / 4};
  }
  throw std::invalid_argument("no limb lifts off");
}

std::vector<LimbPath> fit_subcycles(const LimbTracks& tracks, const GaitCycle& cycle,
                                    const std::array<double, 2>& keys, const ModelSetting& setting,
                                    std::vector<PhaseGammas>& gammas) {
  const Eigen::VectorXd& times = tracks.times;
  check(keys, times, cycle.period);
  double offset = 0;
  for (const Reversal& reversal : cycle.limbs.front().reversals) {
    if (reversal.touch_down) offset = (keys[0] - reversal.time) / cycle.period;
  }
  std::vector<LimbPath> paths;
  for (char which : {'F', 'H'}) {
    const Pair pair = find_pair(tracks, cycle, which);
    LimbPath path{std::string("L") + which, pair.foot, offset - std::floor(offset), {}};
    for (int i = 0; i < 4; ++i) {
      const auto key = [&](int k) {
        return keys[static_cast<std::size_t>(k % 2)] + k / 2 * cycle.period / 2;
      };
      const double begin = key(i), end = key(i + 1), half = cycle.period / 2;
      PhaseData data{std::string(1, static_cast<char>('A' + i)), {}, 0, 1};
      append_runs(times, pair.left, begin + pair.left_delay, end + pair.left_delay, cycle.period,
                  data.runs);
      append_runs(times, pair.right, begin + half + pair.right_delay, end + half + pair.right_delay,
                  cycle.period, data.runs);
      if (data.runs.empty()) {
        throw std::invalid_argument(fmt::format(
            "the record shows no frame of subcycle {} of limb {}", data.phase, path.limb));
      }
      PhaseGammas fitted = phase_gammas(data, setting);
      fitted.limb = path.limb;
      const bool is_left = i < 2;  // then the left limb is where the right one was half a cycle ago
      const LimbTrack& track = is_left ? pair.left : pair.right;
      const double delay = is_left ? pair.left_delay : pair.right_delay;
      const double time = keys[static_cast<std::size_t>(i % 2)] + delay;
      path.spans.push_back({data.phase,
                            (end - begin) / cycle.period,
                            outline_at(times, track, std::min(time, times[times.size() - 1])),
                            {GaitModel::quadratic, fitted.gamma.transpose(), 0, 1}});
      gammas.push_back(std::move(fitted));
    }
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace wavecurve
