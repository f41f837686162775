#include "wavecurve/motion/morph/physical_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/dynamics/modal/oscillator.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/solver.hpp"
#include "wavecurve/dynamics/translation.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/motion/morph/contour_morph.hpp"

namespace wavecurve::motion {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Coarse coefficients of many points are those of few points times this: each level of (2.8)
/// multiplies a constant by sqrt 2.
double coarse_factor(Index samples, Index scale) {
  return std::sqrt(static_cast<double>(samples) / static_cast<double>(scale));
}

void check_scale(const Morph& morph, const MorphLayer& layer, Index samples) {
  try {
    const ContourMorph check(morph.bank, samples, morph.levels, layer.scale);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("layer '{}': {}", layer.id, error.what()));
  }
}

/// The problem of the control points, released at rest, times not yet set.
dynamics::InitialValueProblem released(const Morph& morph, const MorphLayer& layer,
                                       const ContourPair& pair,
                                       const dynamics::Material& material) {
  const Index samples = pair.source.rows(), scale = layer.scale;
  check_scale(morph, layer, samples);
  int levels = morph.levels;
  for (Index size = scale; size < samples; size *= 2) --levels;
  return {.system = dynamics::LagrangeSystem(morph.bank, scale, levels, material),
          .initial_displacement =
              (pair.source - pair.destination).topRows(scale) / coarse_factor(samples, scale)};
}

/// The path of the mean, thrown so that it is back at the last of the times.
Eigen::RowVector2d arc(const PhysicalOptions& options, double time, double last) {
  const dynamics::Material& material = options.material;
  const dynamics::Oscillator mean{
      .rho = material.density,
      .c = material.damping_density + material.mass_damping * material.density};
  const dynamics::Propagator now = dynamics::propagator(mean, time),
                             end = dynamics::propagator(mean, last);
  return (now.qf - now.qv / end.qv * end.qf) * options.force;
}

/// Displacements of the control points.
std::vector<Eigen::MatrixXd> solve(dynamics::InitialValueProblem problem,
                                   const PhysicalOptions& options, double until) {
  problem.times = VectorXd::LinSpaced(options.frames, 0, until);
  problem.with_velocities = false;
  const dynamics::Solver solver =
      dynamics::find_solver(options.solver).make({.tolerance = 1e-6, .step = until / 2048});
  std::vector<Eigen::MatrixXd> displacement;
  try {
    displacement = dynamics::with_translation(solver, dynamics::Translation::interpolated)(problem)
                       .displacement;
  } catch (const dynamics::SolutionStopped& stopped) {  // what was reached is no animation
    throw std::domain_error(fmt::format("solver {}: {}", options.solver, stopped.what()));
  }
  if (options.force.isZero(0)) return displacement;
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const double time = problem.times[static_cast<Index>(i)];
    displacement[i] += dynamics::uniform_density(problem.system, arc(options, time, until));
  }
  return displacement;
}

void append_contour(std::vector<OutlineKey>& keys, const Morph& morph, const MorphLayer& layer,
                    const ContourPair& pair, const std::vector<Eigen::MatrixXd>& displacement) {
  const Index samples = pair.source.rows(), scale = layer.scale;
  ContourMorph contour(morph.bank, samples, morph.levels, scale);
  ContourPair moving = pair;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    moving.source.topRows(scale) =
        pair.destination.topRows(scale) + coarse_factor(samples, scale) * displacement[i];
    Contour points(samples, 2);
    // At tau = 0 the control points are the first one's; details keep their shares.
    contour.frame(moving, 0,
                  detail_shares(morph.detail, morph.stage_share, keys[i].time / morph.duration),
                  points);
    keys[i].contours.emplace_back(outline_rows(pair, points));
  }
}

/// Every frame keeps all points of all contours.
void check_keys(const Morph& morph, int frames) {
  constexpr double most_points = double{1 << 25};
  double points = 0;
  for (const MorphLayer& layer : morph.layers) {
    for (const ContourPair& pair : layer.contours)
      points += static_cast<double>(pair.source.rows());
  }
  if (points * frames <= most_points) return;
  throw std::domain_error(fmt::format("{} frames of {} points are more than {} points together",
                                      frames, points, most_points));
}

void check(const Morph& morph, const PhysicalOptions& options) {
  check_at_least("frames", options.frames, 2);
  check_keys(morph, options.frames);
  if (options.until) check_above_zero("until", *options.until);
  if (!options.force.allFinite()) {
    throw std::invalid_argument(
        fmt::format("force is {}, {}, but must be finite", options.force.x(), options.force.y()));
  }
  if (options.material.density == 0 && !options.force.isZero(0)) {
    throw std::domain_error(must_be("density", 0, "above 0 for a force to throw the contours"));
  }
  if (morph.detail == Detail::stage) check_stage_share(morph.stage_share);
  dynamics::find_solver(options.solver);
}

/// What bounds the displacement of one contour at any later time.
class Remainder {
 public:
  explicit Remainder(dynamics::InitialValueProblem problem)
      : problem_(std::move(problem)),
        mass_(problem_.system.mass()),
        stiffness_(problem_.system.stiffness()) {
    const VectorXd inverse = problem_.system.eigenvalues().stiffness.tail(half()).cwiseInverse();
    reach_ = (2 * inverse.sum() - inverse[half() - 1]) / static_cast<double>(2 * half());
  }

  /// The square of the largest displacement, mean left out, from the time on, at most.
  double bound(double time) {
    problem_.times = VectorXd::Constant(1, time);
    const dynamics::Trajectory state = dynamics::solve_spectral(problem_);
    return reach_ * (form(stiffness_, state.displacement[0]) + form(mass_, state.velocity[0]));
  }

  /// The period of the slowest mode, or without mass its relaxation time.
  double swing() const {
    const dynamics::CirculantEigenvalues symbols = problem_.system.eigenvalues();
    const double period = 2 * std::numbers::pi * std::sqrt(symbols.mass[1] / symbols.stiffness[1]);
    return std::max(period, symbols.damping[1] / symbols.stiffness[1]);
  }

 private:
  Index half() const { return problem_.system.samples() / 2; }

  /// The mean is in the null space of the stiffness, and at rest.
  static double form(const Eigen::SparseMatrix<double>& matrix, const Eigen::MatrixXd& state) {
    return state.cwiseProduct(matrix * state).sum();
  }

  dynamics::InitialValueProblem problem_;
  Eigen::SparseMatrix<double> mass_, stiffness_;
  double reach_ = 0;
};

void check_settles(const dynamics::Material& material) {
  if (material.stiffness_damping == 0 && material.mass_damping == 0 &&
      material.damping_density == 0) {
    throw std::domain_error(must_be("damping", 0, "above 0 for the motion to settle"));
  }
  if (material.stiffness == 0 && material.bending == 0) {
    throw std::domain_error(must_be("stiffness", 0, "above 0 for the motion to settle"));
  }
}

}  // namespace

double settling_time(const Morph& morph, const dynamics::Material& material) {
  check_settles(material);
  std::vector<Remainder> contours;
  double swing = 0;
  for (const MorphLayer& layer : morph.layers) {
    for (const ContourPair& pair : layer.contours) {
      contours.emplace_back(released(morph, layer, pair, material));
      swing = std::max(swing, contours.back().swing());
    }
  }
  const double distance = settled_share * std::max(morph.view_box.width, morph.view_box.height);
  const auto is_settled = [&](double time) {
    return std::all_of(contours.begin(), contours.end(), [&](Remainder& contour) {
      return contour.bound(time) <= distance * distance;
    });
  };
  double late = swing;
  while (!is_settled(late)) {
    late *= 2;
    if (!(late < 1e6 * swing)) {
      throw std::domain_error(fmt::format(
          "damping is too small: the motion does not settle within a million swings of {}", swing));
    }
  }
  if (late == swing) return swing;
  for (double early = late / 2; late - early > 1e-3 * late;) {
    const double time = (early + late) / 2;
    (is_settled(time) ? late : early) = time;
  }
  return late;
}

Animation physical_animation(const Morph& morph, const PhysicalOptions& options) {
  check(morph, options);
  const double until = options.until ? *options.until : settling_time(morph, options.material);
  Animation animation{morph.view_box, morph.duration, {}, morph.order};
  for (const MorphLayer& layer : morph.layers) {
    std::vector<OutlineKey> keys(static_cast<std::size_t>(options.frames));
    const VectorXd times = VectorXd::LinSpaced(options.frames, 0, morph.duration);
    for (Index i = 0; i < times.size(); ++i) keys[static_cast<std::size_t>(i)].time = times[i];
    for (const ContourPair& pair : layer.contours) {
      const dynamics::InitialValueProblem problem = released(morph, layer, pair, options.material);
      append_contour(keys, morph, layer, pair, solve(problem, options, until));
    }
    animation.layers.push_back({layer.id, std::move(keys), layer.paint, open_contours(layer)});
  }
  return animation;
}

}  // namespace wavecurve::motion
