#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <Eigen/Core>

#include "wavecurve/motion/gait/record/canine_gaits.hpp"
#include "wavecurve/motion/gait/record/limb_tracks.hpp"

namespace wavecurve::gait {

/// A made record, for tests: limbs that are sheared, so that the foot goes back evenly for the duty
/// factor and forth by the publication's f with a known gamma, lifted by a parabola.
struct PlantedGait {
  CanineGait gait = find_canine_gait("walk");
  double gamma = 0.4;  ///< of x in the swing; of f from 1 to 0
  double period = 1, facing = 1;
  double cycles = 3.4;
  int frames_a_cycle = 40;
  Eigen::Index points = 64;
  double noise = 0;
  unsigned seed = 1;
  double reach = 20, lift = 12, length = 60;  ///< of the foot's way, of the limb

  /// Where the foot is, relative to the middle of its way, at a time; y down.
  Eigen::RowVector2d foot_at(std::size_t limb, double time) const {
    const LimbTiming& timing = gait.limbs[limb];
    double u = time / period - timing.touch_down;
    u -= std::floor(u);
    if (u < timing.duty_factor) return {facing * reach * (1 - 2 * u / timing.duty_factor), 0};
    const double tau = (u - timing.duty_factor) / (1 - timing.duty_factor);
    const double f = 1 - (1 + gamma) * tau + gamma * tau * tau;
    return {facing * reach * (1 - 2 * f), -4 * lift * tau * (1 - tau)};
  }

  /// An upright ellipse from the hinge to the foot, its lowest point at height 0.
  Contour rest(std::size_t limb) const {
    const double x = facing * (limb < 2 ? 60 : 0);
    Contour outline(points, 2);
    for (Eigen::Index k = 0; k < points; ++k) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(points);
      outline.row(k) << x + length / 6 * std::sin(angle), -length / 2 * (1 + std::cos(angle));
    }
    return outline;
  }

  Contour pose(std::size_t limb, double time) const {
    Contour outline = rest(limb);
    const Eigen::VectorXd share = outline.col(1).array() / length + 1;
    return outline + share * foot_at(limb, time);
  }

  LimbTracks tracks() const {
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0, 1);
    const int frames = static_cast<int>(cycles * frames_a_cycle) + 1;
    LimbTracks result{Eigen::VectorXd(frames), {}};
    for (int i = 0; i < frames; ++i) result.times[i] = period * i / frames_a_cycle;
    for (std::size_t limb = 0; limb < limb_names.size(); ++limb) {
      LimbTrack track{std::string(limb_names[limb]), {}};
      for (double time : result.times) {
        track.outlines.push_back(pose(limb, time));
        if (noise == 0) continue;
        for (double& value : track.outlines.back().reshaped()) value += noise * normal(generator);
      }
      result.limbs.push_back(std::move(track));
    }
    return result;
  }
};

}  // namespace wavecurve::gait
