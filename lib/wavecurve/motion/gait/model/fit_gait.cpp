#include "wavecurve/motion/gait/model/fit_gait.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/motion/gait/model/detail/control_points.hpp"
#include "wavecurve/motion/gait/model/fit_subcycles.hpp"

namespace wavecurve::gait {

namespace {

using Eigen::Index;

constexpr double least_movement = 0.01;  // of the foot's excursion
constexpr int most_harmonics = 4;

Index points_of(const LimbTracks& tracks, const LimbCycle& limb) {
  return find_track(tracks, limb.limb)->outlines.front().rows();
}

/// The four limbs' control points, over the record or, of a loop, three turns of it.
LimbTracks control_point_tracks(const LimbTracks& tracks, const GaitCycle& cycle,
                                const GaitFitOptions& options) {
  LimbTracks result{tracks.times, {}};
  for (const LimbCycle& limb : cycle.limbs) {
    const LimbTrack& track = *find_track(tracks, limb.limb);
    const Index samples = track.outlines.front().rows();
    try {
      const ControlPoints points(options.bank, samples, options.scale.value_or(samples));
      LimbTrack coarse{track.limb, {}};
      for (const Contour& outline : track.outlines) {
        coarse.outlines.push_back(points.analyse(outline));
      }
      result.limbs.push_back(std::move(coarse));
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("limb '{}': {}", limb.limb, error.what()));
    }
  }
  return cycle.is_loop ? unrolled(result) : result;
}

void check_points(const LimbTracks& tracks) {
  for (const LimbTrack& track : tracks.limbs) {
    if (track.outlines.front().rows() == tracks.limbs.front().outlines.front().rows()) continue;
    throw std::invalid_argument(fmt::format(
        "limb '{}' has {} control points and limb '{}' {}, but all must have the same number",
        track.limb, track.outlines.front().rows(), tracks.limbs.front().limb,
        tracks.limbs.front().outlines.front().rows()));
  }
}

/// Stance and swing, each from one reversal to the next; of a loop, one of each.
std::vector<PhaseData> phases_of(const LimbCycle& limb, const GaitCycle& cycle,
                                 const Eigen::VectorXd& times, const LimbTrack& track) {
  std::vector<PhaseData> phases{{"stance", {}, 0, limb.duty_factor},
                                {"swing", {}, limb.duty_factor, 1}};
  const double first = cycle.is_loop ? times[times.size() / 3] : times[0];
  const double last = cycle.is_loop ? first + cycle.period : times[times.size() - 1];
  for (std::size_t i = 0; i + 1 < limb.reversals.size(); ++i) {
    const double begin = limb.reversals[i].time;
    if (begin < first || begin >= last) continue;
    PhaseRun run = phase_run(times, track, begin, limb.reversals[i + 1].time);
    if (run.tau.size() == 0) continue;
    phases[limb.reversals[i].touch_down ? 0 : 1].runs.push_back(std::move(run));
  }
  for (const PhaseData& data : phases) {
    if (data.runs.empty()) {
      throw std::invalid_argument(fmt::format(
          "the record shows no whole {} of limb '{}' with a frame inside", data.phase, limb.limb));
    }
  }
  return phases;
}

/// The mean control points at touch-down or at lift-off.
Contour mean_key(const std::vector<PhaseData>& phases, bool touch_down) {
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(phases[0].runs.front().from.size());
  double count = 0;
  for (std::size_t phase : {0U, 1U}) {
    for (const PhaseRun& run : phases[phase].runs) {
      sum += (phase == 0) == touch_down ? run.from : run.to;
      ++count;
    }
  }
  return (sum / count).reshaped(sum.size() / 2, 2);
}

int fourier_terms(const std::vector<PhaseData>& phases) {
  Index frames = 0;
  for (const PhaseData& data : phases) frames += data.runs.front().tau.size();
  // At least two frames a term, so that a series through every fifth frame less has enough.
  return 1 + 2 * std::clamp(static_cast<int>(frames / 4), 1, most_harmonics);
}

std::size_t best(const std::vector<ModelFit>& models) {
  return static_cast<std::size_t>(std::min_element(models.begin(), models.end(),
                                                   [](const ModelFit& a, const ModelFit& b) {
                                                     return a.cross_validated < b.cross_validated;
                                                   }) -
                                  models.begin());
}

/// All models of one phase, and their quality.
std::vector<ModelFit> fit_models(const LimbFit& limb, std::size_t phase,
                                 const ModelSetting& setting, double stride, double excursion,
                                 const GaitFitOptions& options, GaitParameters& parameters) {
  const PhaseData& data = limb.phases[phase];
  std::vector<ModelFit> models;
  for (GaitModel model : options.models) {
    const ModelFit fit = fit_model(model, limb.phases, phase, setting);
    parameters.quality.push_back({limb.limb, data.phase, model, fit.residual / stride,
                                  fit.cross_validated / stride, fit.foot_residual / excursion,
                                  static_cast<int>(data.runs.size())});
    models.push_back(fit);
  }
  return models;
}

/// Appends the fit of one limb to the parameters.
LimbFit fit_limb(const LimbCycle& limb, const GaitCycle& cycle, const Eigen::VectorXd& times,
                 const LimbTrack& track, const GaitFitOptions& options,
                 GaitParameters& parameters) {
  LimbFit fit{limb.limb, phases_of(limb, cycle, times, track), {}};
  const ModelSetting setting{options.bank, least_movement * limb.excursion,
                             fourier_terms(fit.phases), limb.foot};
  LimbPath path{limb.limb, limb.foot, limb.touch_down, {}};
  for (std::size_t phase : {0U, 1U}) {
    fit.models.push_back(
        fit_models(fit, phase, setting, cycle.stride, limb.excursion, options, parameters));
    const std::vector<ModelFit>& models = fit.models.back();
    const std::size_t chosen = best(models);
    path.spans.push_back({fit.phases[phase].phase,
                          phase == 0 ? limb.duty_factor : 1 - limb.duty_factor,
                          mean_key(fit.phases, phase == 0), models[chosen].motion});
    parameters.gammas.push_back(phase_gammas(fit.phases[phase], setting));
    parameters.gammas.back().limb = limb.limb;
  }
  parameters.limbs.push_back(std::move(path));
  return fit;
}

}  // namespace

GaitFit fit_gait(const LimbTracks& tracks, const GaitFitOptions& options) {
  if (options.models.empty()) throw std::invalid_argument("there is no model to fit");
  GaitFit fit;
  fit.cycle = analyse_cycle(tracks);
  const LimbTracks points = control_point_tracks(tracks, fit.cycle, options);
  check_points(points);
  GaitParameters& parameters = fit.parameters;
  parameters.period = fit.cycle.period;
  parameters.facing = fit.cycle.facing;
  parameters.stride = fit.cycle.stride;
  parameters.filter = options.filter;
  parameters.samples = points_of(tracks, fit.cycle.limbs.front());
  parameters.scale = points.limbs.front().outlines.front().rows();
  GaitCycle cycle = fit.cycle;  // with feet among the control points
  for (LimbCycle& limb : cycle.limbs) {
    limb.foot = limb.foot * parameters.scale / points_of(tracks, limb);
  }
  double excursion = 0;
  for (std::size_t l = 0; l < cycle.limbs.size(); ++l) {
    fit.limbs.push_back(
        fit_limb(cycle.limbs[l], cycle, points.times, points.limbs[l], options, parameters));
    excursion = std::max(excursion, cycle.limbs[l].excursion);
  }
  Subcycles subcycles =
      fit_subcycles(points, cycle, options.key_frames.value_or(automatic_key_frames(cycle)),
                    {options.bank, least_movement * excursion, 0, 0});
  parameters.subcycles = std::move(subcycles.paths);
  std::move(subcycles.gammas.begin(), subcycles.gammas.end(),
            std::back_inserter(parameters.gammas));
  fit.subcycles = std::move(subcycles.data);
  return fit;
}

}  // namespace wavecurve::gait
