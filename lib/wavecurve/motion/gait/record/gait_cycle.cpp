#include "wavecurve/motion/gait/record/gait_cycle.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <stdexcept>

#include <Eigen/Dense>
#include <fmt/format.h>

#include "wavecurve/elementary/arctangent.hpp"
#include "wavecurve/elementary/sine_cosine.hpp"
#include "wavecurve/motion/gait/record/canine_gaits.hpp"
#include "wavecurve/motion/gait/record/detail/check_tracks.hpp"
#include "wavecurve/motion/gait/record/detail/turning_points.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The point whose position varies most, with its neighbours.
Index foot_of(const LimbTrack& track) {
  const Index points = track.outlines.front().rows();
  Contour mean = Contour::Zero(points, 2);
  for (const Contour& outline : track.outlines) mean += outline;
  mean /= static_cast<double>(track.outlines.size());
  VectorXd spread = VectorXd::Zero(points);
  for (const Contour& outline : track.outlines) spread += (outline - mean).rowwise().squaredNorm();
  const Index reach = points / 32;
  Index foot = 0;
  double most = -1;
  for (Index k = 0; k < points; ++k) {
    double sum = 0;
    for (Index i = -reach; i <= reach; ++i) sum += spread[(k + i + points) % points];
    if (sum > most) {
      most = sum;
      foot = k;
    }
  }
  return foot;
}

VectorXd coordinate(const LimbTrack& track, Index point, int axis) {
  VectorXd values(static_cast<Index>(track.outlines.size()));
  for (Index i = 0; i < values.size(); ++i) {
    values[i] = track.outlines[static_cast<std::size_t>(i)](point, axis);
  }
  return values;
}

/// A limb under way: its foot's path, and where it turns.
struct FootPath {
  const LimbTrack* track = nullptr;
  Index foot = 0;
  VectorXd x, y;
  std::vector<TurningPoint> turns;
};

std::vector<FootPath> foot_paths(const LimbTracks& tracks) {
  std::vector<FootPath> paths;
  for (std::string_view name : limb_names) {
    const LimbTrack* const track = find_track(tracks, name);
    if (!track) continue;
    FootPath path{track, foot_of(*track), {}, {}, {}};
    path.x = coordinate(*track, path.foot, 0);
    path.y = coordinate(*track, path.foot, 1);
    // A limb that only shakes has no gait: 1e-9 of its size is rounding.
    const double size = (track->outlines.front().colwise().maxCoeff() -
                         track->outlines.front().colwise().minCoeff())
                            .norm();
    if (path.x.maxCoeff() - path.x.minCoeff() <= 1e-9 * size) {
      throw std::invalid_argument(fmt::format("the foot of limb '{}' does not move", name));
    }
    path.turns = turning_points(tracks.times, path.x);
    paths.push_back(std::move(path));
  }
  return paths;
}

void check_pairs(const std::vector<FootPath>& paths) {
  for (char pair : {'F', 'H'}) {
    const bool is_there = std::any_of(paths.begin(), paths.end(), [&](const FootPath& path) {
      return path.track->limb[1] == pair;
    });
    if (!is_there) {
      throw std::invalid_argument(fmt::format(
          "there is no track of limb L{0} or R{0}, but a gait takes one of them", pair));
    }
  }
}

/// At least one kind of reversal twice, that is, a cycle.
bool is_complete(const FootPath& path) { return path.turns.size() >= 3; }

double distance(const LimbTracks& tracks, Index i, Index j) {
  double sum = 0;
  for (const LimbTrack& track : tracks.limbs) {
    sum +=
        (track.outlines[static_cast<std::size_t>(i)] - track.outlines[static_cast<std::size_t>(j)])
            .squaredNorm();
  }
  return std::sqrt(sum);
}

bool closes(const LimbTracks& tracks) {
  const Index frames = tracks.times.size();
  std::vector<double> steps;
  for (Index i = 0; i + 1 < frames; ++i) steps.push_back(distance(tracks, i, i + 1));
  const auto largest = *std::max_element(steps.begin(), steps.end());
  return distance(tracks, frames - 1, 0) <= 1.5 * largest;
}

/// 1 if feet are lower (larger y) while they move to smaller x.
double facing_of(const std::vector<FootPath>& paths) {
  double lower = 0;
  for (const FootPath& path : paths) {
    for (Index i = 0; i + 1 < path.x.size(); ++i) {
      const double height = (path.y[i] + path.y[i + 1]) / 2 - path.y.mean();
      lower -= (path.x[i + 1] - path.x[i]) * height;
    }
  }
  if (lower == 0) {
    throw std::invalid_argument(
        "no foot is higher in its swing than in its stance, so that nothing tells which is which");
  }
  return lower > 0 ? 1 : -1;
}

LimbCycle limb_cycle(const FootPath& path, double facing) {
  LimbCycle limb{path.track->limb, path.foot, {}, 0, 0, 0};
  for (const TurningPoint& turn : path.turns) {
    limb.reversals.push_back({turn.time, turn.is_maximum == (facing > 0)});
  }
  double stance = 0, swing = 0, excursion = 0;
  int stances = 0, swings = 0;
  for (std::size_t i = 0; i + 1 < path.turns.size(); ++i) {
    const double duration = path.turns[i + 1].time - path.turns[i].time;
    (limb.reversals[i].touch_down ? stance : swing) += duration;
    ++(limb.reversals[i].touch_down ? stances : swings);
    excursion += std::abs(path.turns[i + 1].value - path.turns[i].value);
  }
  stance /= stances;
  swing /= swings;
  limb.duty_factor = stance / (stance + swing);
  limb.excursion = excursion / (stances + swings);
  return limb;
}

double mean_period(const std::vector<LimbCycle>& limbs) {
  double sum = 0;
  int count = 0;
  for (const LimbCycle& limb : limbs) {
    for (std::size_t i = 0; i + 2 < limb.reversals.size(); ++i) {
      sum += limb.reversals[i + 2].time - limb.reversals[i].time;
      ++count;
    }
  }
  return sum / count;
}

/// The mean delay of the touch-downs after the nearest of the reference, as a share of the period, 0 <= s < 1.
double touch_down_share(const LimbCycle& limb, const LimbCycle& reference, double period) {
  std::complex<double> mean = 0;
  for (const Reversal& reversal : limb.reversals) {
    if (!reversal.touch_down) continue;
    std::optional<double> nearest;
    for (const Reversal& other : reference.reversals) {
      const double lag = reversal.time - other.time;
      if (other.touch_down && (!nearest || std::abs(lag) < std::abs(*nearest))) nearest = lag;
    }
    if (!nearest) continue;
    const auto [sine, cosine] = sine_cosine(2 * std::numbers::pi * *nearest / period);
    mean += std::complex<double>(cosine, sine);
  }
  const double share = arctangent(mean.imag(), mean.real()) / (2 * std::numbers::pi);
  return share < 0 ? std::fmod(share + 1, 1.0) : share;
}

/// The median speed of feet backwards in the middle halves of their stances.
double speed_of_ground(const LimbTracks& tracks, const std::vector<FootPath>& paths,
                       const GaitCycle& cycle) {
  std::vector<double> speeds;
  for (std::size_t l = 0; l < paths.size(); ++l) {
    const auto& reversals = cycle.limbs[l].reversals;
    for (std::size_t r = 0; r + 1 < reversals.size(); ++r) {
      if (!reversals[r].touch_down) continue;
      const double begin = reversals[r].time, quarter = (reversals[r + 1].time - begin) / 4;
      for (Index i = 0; i + 1 < tracks.times.size(); ++i) {
        const double middle = (tracks.times[i] + tracks.times[i + 1]) / 2;
        if (middle < begin + quarter || middle > begin + 3 * quarter) continue;
        speeds.push_back(-cycle.facing * (paths[l].x[i + 1] - paths[l].x[i]) /
                         (tracks.times[i + 1] - tracks.times[i]));
      }
    }
  }
  if (speeds.empty()) throw std::invalid_argument("too few frames: none in the middle of a stance");
  const auto middle = speeds.begin() + static_cast<std::ptrdiff_t>(speeds.size() / 2);
  std::nth_element(speeds.begin(), middle, speeds.end());
  return *middle;
}

/// The cycle of the tracks as they are; nothing if a limb completes no cycle.
std::optional<GaitCycle> analyse(const LimbTracks& tracks) {
  const std::vector<FootPath> paths = foot_paths(tracks);
  check_pairs(paths);
  if (!std::all_of(paths.begin(), paths.end(), is_complete)) return std::nullopt;
  GaitCycle cycle;
  cycle.facing = facing_of(paths);
  for (const FootPath& path : paths) cycle.limbs.push_back(limb_cycle(path, cycle.facing));
  cycle.period = mean_period(cycle.limbs);
  for (LimbCycle& limb : cycle.limbs) {
    limb.touch_down = touch_down_share(limb, cycle.limbs.front(), cycle.period);
  }
  cycle.ground_speed = speed_of_ground(tracks, paths, cycle);
  cycle.stride = cycle.ground_speed * cycle.period;
  return cycle;
}

/// The duration of a loop.
double loop_period(const LimbTracks& tracks) {
  const Index frames = tracks.times.size();
  const double span = tracks.times[frames - 1] - tracks.times[0];
  return span * static_cast<double>(frames) / static_cast<double>(frames - 1);
}

}  // namespace

LimbTracks unrolled(const LimbTracks& tracks) {
  const Index frames = tracks.times.size();
  const double period = loop_period(tracks);
  LimbTracks result{VectorXd(3 * frames), {}};
  for (int turn = 0; turn < 3; ++turn) {
    result.times.segment(turn * frames, frames) = tracks.times.array() + (turn - 1) * period;
  }
  for (const LimbTrack& track : tracks.limbs) {
    LimbTrack copy{track.limb, {}};
    for (int turn = 0; turn < 3; ++turn) {
      copy.outlines.insert(copy.outlines.end(), track.outlines.begin(), track.outlines.end());
    }
    result.limbs.push_back(std::move(copy));
  }
  return result;
}

Contour outline_at(const VectorXd& times, const LimbTrack& track, double time) {
  const Index frames = times.size(), size = std::min<Index>(4, frames);
  const Index after = std::upper_bound(times.begin(), times.end(), time) - times.begin();
  const Index first = std::clamp<Index>(after - size / 2, 0, frames - size);
  Contour result = Contour::Zero(track.outlines.front().rows(), 2);
  for (Index i = first; i < first + size; ++i) {
    double weight = 1;  // Lagrange's
    for (Index j = first; j < first + size; ++j) {
      if (j != i) weight *= (time - times[j]) / (times[i] - times[j]);
    }
    result += weight * track.outlines[static_cast<std::size_t>(i)];
  }
  return result;
}

GaitCycle analyse_cycle(const LimbTracks& tracks) {
  check_tracks(tracks);
  if (auto cycle = analyse(tracks)) return *cycle;
  if (closes(tracks)) {
    if (auto cycle = analyse(unrolled(tracks))) {
      cycle->is_loop = true;
      return *cycle;
    }
  }
  for (const FootPath& path : foot_paths(tracks)) {
    if (is_complete(path)) continue;
    throw std::invalid_argument(
        fmt::format("the foot of limb '{}' reverses {} times, but a cycle takes 3 reversals, or a "
                    "record that ends where it begins",
                    path.track->limb, path.turns.size()));
  }
  throw std::invalid_argument("the record holds no cycle");
}

}  // namespace wavecurve::gait
