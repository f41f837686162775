#include "verification/study/study_work.hpp"

#include <algorithm>
#include <ctime>
#include <exception>
#include <limits>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "verification/study/motion_error.hpp"

namespace wavecurve::verification {

namespace {

using Eigen::VectorXd;

/// A solve is repeated within these bounds: the least time is the least disturbed.
constexpr int most_runs = 5;
constexpr double most_seconds = 0.01;

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

void measure(StudyPoint& point, const StudyGround& ground, const dynamics::Trajectory& solution) {
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

/// Fills in what the solver, the tolerance and the ground determine, or why there is nothing.
void solve_point(StudyPoint& point, const StudyGround& ground) {
  try {
    // What the point calls its tolerance is the step size of a solver that takes one.
    const dynamics::Solver solver =
        dynamics::find_solver(point.solver)
            .make({.tolerance = point.tolerance, .step = point.tolerance});
    const Timed run = timed(solver, ground.problem);
    measure(point, ground, run.trajectory);
    point.cost = run.trajectory.cost;
    point.seconds = run.seconds;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::system_error&) {
    throw;
  } catch (const std::exception& error) {
    point.failure = error.what();
  }
}

}  // namespace

StudyWork::StudyWork(const StudyPlan& plan, const Shard& shard)
    : points_(points_of(plan, shard)), is_known_(points_.size()), grounds_(settings()) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    points_[i].fingerprint = grounds_.fingerprint(setting_of_point_[i]);
  }
}

/// Those of the points, which are setting by setting.
std::vector<std::shared_ptr<const StudySetting>> StudyWork::settings() {
  std::vector<std::shared_ptr<const StudySetting>> settings;
  setting_of_point_.reserve(points_.size());
  for (const StudyPoint& point : points_) {
    if (settings.empty() || settings.back() != point.setting) settings.push_back(point.setting);
    setting_of_point_.push_back(static_cast<std::uint32_t>(settings.size() - 1));
  }
  return settings;
}

void StudyWork::take_up(const PointSource& known) {
  const PlacesOfPoints places(points_);
  known([&](StudyPoint point) {
    const auto place = places.find(point);
    if (!place || points_[*place].fingerprint != point.fingerprint) return;
    point.setting = points_[*place].setting;
    points_[*place] = std::move(point);
    is_known_[*place] = true;
  });
}

std::vector<std::size_t> StudyWork::open() const {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (!is_known_[i]) open.push_back(i);
  }
  return open;
}

std::string StudyWork::solve(std::size_t place, const StudyHooks& hooks) {
  try {
    if (hooks.stand_in) {
      hooks.stand_in(points_[place]);
    } else {
      solve_point(points_[place], *grounds_.take(setting_of_point_[place]));
    }
    return {};
  } catch (const std::bad_alloc&) {
    return "out of memory";
  } catch (const std::system_error& error) {
    return error.what();
  }
}

void fail_for_lack(const StudyPoint& first, const std::string& what, std::size_t count) {
  const std::string others = count > 1 ? fmt::format(", and {} more points", count - 1) : "";
  throw std::runtime_error(
      fmt::format("not measured, for the machine failed: {}: {}{}", name_of(first), what, others));
}

}  // namespace wavecurve::verification
