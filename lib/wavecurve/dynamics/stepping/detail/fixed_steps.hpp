#pragma once

#include <cmath>

#include "wavecurve/dynamics/detail/work_bound.hpp"
#include "wavecurve/dynamics/initial_value_problem.hpp"

namespace wavecurve::dynamics {

/// The trajectory of a method with set_step(h), step(t), displacement(), velocity(t), cost(), in
/// equal steps of at most step between two of the times. make makes the method: what it throws has
/// no results to be kept.
template <class Make>
Trajectory in_fixed_steps(const InitialValueProblem& problem, double step, Make make) {
  Trajectory trajectory;
  keep_what_is_reached(trajectory, [&] {
    auto method = make();
    double time = 0, last = 0;
    for (const double next : problem.times) {
      const double count = std::ceil((next - time) / step * (1 - 1e-12));
      if (next > time) {
        const double h = (next - time) / count;
        // The distances of equally spaced times are the same but for rounding.
        if (!(std::abs(h / last - 1) < 1e-12)) method.set_step(last = h);
        for (double i = 0; i < count; ++i) {
          method.step(time + i * h);
          check_work(method.cost().operations, time + (i + 1) * h, problem.times.tail<1>()[0]);
        }
      }
      time = next;
      trajectory.displacement.push_back(method.displacement());
      if (problem.with_velocities) trajectory.velocity.push_back(method.velocity(time));
      trajectory.cost = method.cost();
    }
  });
  return trajectory;
}

}  // namespace wavecurve::dynamics
