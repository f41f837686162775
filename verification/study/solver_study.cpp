#include "verification/study/solver_study.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "wavecurve/certified/detail/thread_cache.hpp"
#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/io/load_filter.hpp"

#include "verification/study/motion_error.hpp"
#include "verification/study/named_shapes.hpp"
#include "verification/suite/on_all_cores.hpp"

namespace wavecurve::verification {

namespace {

using Eigen::VectorXd;

/// A solve is repeated within these bounds: the least time is the least disturbed.
constexpr int most_runs = 5;
constexpr double most_seconds = 0.1;

/// A setting made ready, shared by the threads.
struct Ground {
  dynamics::InitialValueProblem problem;
  dynamics::Trajectory exact;
  std::string fingerprint;
};

/// FNV-1a, over the bits of the numbers.
class Fingerprint {
 public:
  void add(const Eigen::Ref<const Eigen::MatrixXd>& values) {
    for (const double value : values.reshaped()) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      for (int byte = 0; byte < 8; ++byte) {
        hash_ = (hash_ ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
      }
    }
  }
  std::string text() const { return fmt::format("{:016x}", hash_); }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

std::string fingerprint_of(const dynamics::InitialValueProblem& problem) {
  Fingerprint fingerprint;
  fingerprint.add(problem.initial_displacement);
  fingerprint.add(problem.times);
  const dynamics::CirculantEigenvalues symbols = problem.system.eigenvalues();
  for (const VectorXd* part : {&symbols.mass, &symbols.damping, &symbols.stiffness}) {
    fingerprint.add(*part);
  }
  return fingerprint.text();
}

Ground ground_of(const StudySetting& setting) {
  wavecurve::dynamics::Material material;
  material.mass_damping = setting.mass_damping;
  material.stiffness_damping = setting.stiffness_damping;
  const dynamics::LagrangeSystem system(io::load_filter_bank(setting.filter), setting.samples,
                                        setting.levels, material);
  dynamics::InitialValueProblem problem =
      released(system, shape_of(setting.shape, setting.samples), study_times());
  // What the transform's rounding leaves of a circle is no deformation.
  if (problem.initial_displacement.norm() <= 1e-12 * problem.rest.norm()) {
    throw std::invalid_argument("shape is the unit circle, but must differ from the rest shape");
  }
  dynamics::Trajectory exact = dynamics::solve_spectral(problem);
  const std::string fingerprint = fingerprint_of(problem);
  return {std::move(problem), std::move(exact), fingerprint};
}

/// Processor time of this thread: solves on other cores do not count.
double processor_seconds() {
  timespec now{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Timed {
  dynamics::Trajectory trajectory;
  double seconds;
};

Timed timed(const dynamics::Solver& solver, const dynamics::InitialValueProblem& problem) {
  Timed result{{}, std::numeric_limits<double>::infinity()};
  double all = 0;
  for (int run = 0; run < most_runs && (run == 0 || all < most_seconds); ++run) {
    const double start = processor_seconds();
    result.trajectory = solver(problem);
    const double seconds = processor_seconds() - start;
    result.seconds = std::min(result.seconds, seconds);
    all += seconds;
  }
  return result;
}

double last(const VectorXd& errors) { return errors[errors.size() - 1]; }

void measure(StudyPoint& point, const Ground& ground, const dynamics::Trajectory& solution) {
  const VectorXd displacement = displacement_errors(ground.problem, solution, ground.exact);
  const VectorXd maximum = maximum_errors(ground.problem, solution, ground.exact);
  const VectorXd velocity = velocity_errors(ground.problem, solution, ground.exact);
  const VectorXd energy = energy_errors(ground.problem, solution, ground.exact);
  for (const VectorXd* errors : {&displacement, &maximum, &velocity, &energy}) {
    if (!errors->allFinite()) throw std::domain_error("the solution grows beyond all numbers");
  }
  point.errors = {
      displacement.maxCoeff(), last(displacement),  maximum.maxCoeff(),
      last(maximum),           velocity.maxCoeff(), last(velocity),
      energy.maxCoeff(),       last(energy),        energy_drift(ground.problem, solution)};
  if (!point.tolerance) point.model_errors.assign(displacement.begin(), displacement.end());
}

/// Fills in what the solver, the tolerance and the ground determine.
void solve(StudyPoint& point, const Ground& ground) {
  try {
    // What the point calls its tolerance is the step size of a solver that takes one.
    const dynamics::Solver solver =
        dynamics::find_solver(point.solver)
            .make({.tolerance = point.tolerance, .step = point.tolerance});
    const Timed run = timed(solver, ground.problem);
    measure(point, ground, run.trajectory);
    point.cost = run.trajectory.cost;
    point.seconds = run.seconds;
  } catch (const std::bad_alloc&) {  // what the machine lacks says nothing about the solution
    throw;
  } catch (const std::exception& error) {
    point.failure = error.what();
  }
}

/// The points of a plan, to be computed or known, each with its ground.
struct Work {
  std::vector<Ground> grounds;
  std::vector<StudyPoint> points;
  std::vector<std::size_t> ground_of_point;
  std::vector<std::size_t> open;  ///< points to be computed
};

bool is_same(const StudyPoint& a, const StudyPoint& b) {
  return a.solver == b.solver && a.tolerance == b.tolerance && a.setting == b.setting &&
         a.fingerprint == b.fingerprint;
}

Work prepared(const StudyPlan& plan, const std::vector<StudyPoint>& known) {
  for (const std::string& name : plan.solvers) dynamics::find_solver(name);
  Work work;
  for (const StudySetting& setting : plan.settings) {
    work.grounds.push_back(ground_of(setting));
    for (const std::string& name : plan.solvers) {
      for (const auto& tolerance : sweep(dynamics::find_solver(name))) {
        StudyPoint point{setting, name, tolerance, {}, {}, {}, 0, {}, {}};
        point.fingerprint = work.grounds.back().fingerprint;
        const auto found = std::ranges::find_if(
            known, [&](const StudyPoint& other) { return is_same(point, other); });
        if (found == known.end()) work.open.push_back(work.points.size());
        work.points.push_back(found == known.end() ? point : *found);
        work.ground_of_point.push_back(work.grounds.size() - 1);
      }
    }
  }
  return work;
}

/// On all cores. What a hook throws leaves the other threads without work, and is thrown again.
void compute(Work& work, const StudyHooks& hooks) {
  std::size_t done = work.points.size() - work.open.size();
  const auto solve_one = [&](std::size_t i) {
    const std::size_t point = work.open[i];
    solve(work.points[point], work.grounds[work.ground_of_point[point]]);
  };
  on_all_cores(work.open.size(), solve_one, [&](std::size_t i) {
    if (hooks.finished) hooks.finished(work.points[work.open[i]]);
    if (hooks.progress) hooks.progress(++done, work.points.size());
  });
}

}  // namespace

VectorXd study_times() { return VectorXd::LinSpaced(41, 0, 1); }

std::vector<std::optional<double>> sweep(const dynamics::NamedSolver& solver) {
  switch (solver.accuracy) {
    case dynamics::AccuracyKind::tolerance:
      return {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11};
    case dynamics::AccuracyKind::step:
      return {1.0 / 64, 1.0 / 128, 1.0 / 256, 1.0 / 512, 1.0 / 1024, 1.0 / 2048};
    case dynamics::AccuracyKind::closed_form:
      break;
  }
  return {std::nullopt};
}

std::vector<StudyPoint> run_study(const StudyPlan& plan, const StudyHooks& hooks) {
  Work work = prepared(plan, hooks.known);
  compute(work, hooks);
  return std::move(work.points);
}

}  // namespace wavecurve::verification
