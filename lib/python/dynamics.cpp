// The Lagrange system and its solvers.
#include <memory>
#include <optional>
#include <pybind11/eigen.h>
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "wavecurve/dynamics/lagrange_system.hpp"
#include "wavecurve/dynamics/solver.hpp"

#include "python/filter_source.hpp"
#include "python/interruptible.hpp"
#include "python/topics.hpp"

namespace wavecurve::python {

namespace {

using dynamics::InitialValueProblem;
using dynamics::LagrangeSystem;
using dynamics::Trajectory;
using Eigen::MatrixXd;

/// A function of Python as a force; called, copied and destroyed on the solver's thread, which holds
/// the GIL meanwhile.
dynamics::ForceDensity force_density(const py::function& function) {
  const std::shared_ptr<py::function> held(new py::function(function), [](py::function* last) {
    const py::gil_scoped_acquire gil;
    delete last;
  });
  return [held](double time, const Eigen::Ref<const MatrixXd>& positions,
                const Eigen::Ref<const MatrixXd>& velocities) -> MatrixXd {
    const py::gil_scoped_acquire gil;
    try {
      return (*held)(time, MatrixXd(positions), MatrixXd(velocities)).cast<MatrixXd>();
    } catch (const py::error_already_set& error) {
      throw std::runtime_error(error.what());
    } catch (const py::cast_error&) {
      throw std::runtime_error("a force must return an array of the shape of the positions");
    }
  };
}

/// A constant density (one row: everywhere the same), an oscillating one (omega, cosine, sine), or a
/// function of time, positions and velocities.
using PythonForce = std::variant<py::function, std::tuple<double, MatrixXd, MatrixXd>, MatrixXd>;

void add_force(InitialValueProblem& problem, const PythonForce& force) {
  if (const auto* function = std::get_if<py::function>(&force)) {
    problem.force.general.push_back(force_density(*function));
  } else if (const auto* harmonic = std::get_if<1>(&force)) {
    const auto& [omega, cosine, sine] = *harmonic;
    problem.force.harmonic.push_back({omega, cosine, sine});
  } else {
    MatrixXd constant = std::get<MatrixXd>(force);
    if (constant.rows() == 1) constant = dynamics::uniform_density(problem.system, constant);
    if (problem.force.constant.size() == 0) {
      problem.force.constant = constant;
    } else if (constant.rows() == problem.force.constant.rows() &&
               constant.cols() == problem.force.constant.cols()) {
      problem.force.constant += constant;
    } else {
      throw std::invalid_argument("constant forces must have the same shape");
    }
  }
}

py::array_t<double> stacked(const std::vector<MatrixXd>& states) {
  const auto rows = states.empty() ? 0 : states.front().rows();
  const auto columns = states.empty() ? 0 : states.front().cols();
  py::array_t<double> result({static_cast<py::ssize_t>(states.size()),
                              static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(columns)});
  double* to = result.mutable_data();
  for (const MatrixXd& state : states) {
    for (Eigen::Index i = 0; i < rows; ++i) {
      for (Eigen::Index j = 0; j < columns; ++j) *to++ = state(i, j);
    }
  }
  return result;
}

struct Outcome {
  Trajectory trajectory;
  std::optional<std::string> reason;  ///< why it stopped early
};

py::tuple solve(const LagrangeSystem& system, const std::string& name,
                std::optional<double> tolerance, std::optional<double> step,
                const MatrixXd& displacement, const std::optional<MatrixXd>& velocity,
                const Eigen::VectorXd& times, const std::vector<PythonForce>& forces,
                const std::optional<MatrixXd>& rest) {
  InitialValueProblem problem{
      .system = system, .initial_displacement = displacement, .times = times};
  if (velocity) problem.initial_velocity = *velocity;
  if (rest) problem.rest = *rest;
  for (const PythonForce& force : forces) add_force(problem, force);
  const dynamics::Solver solver =
      dynamics::find_solver(name).make({.tolerance = tolerance, .step = step});
  const Outcome found = interruptible([problem = std::move(problem), solver]() -> Outcome {
    try {
      return {solver(problem), std::nullopt};
    } catch (const dynamics::SolutionStopped& stopped) {
      return {stopped.reached(), stopped.what()};
    }
  });
  const Trajectory& trajectory = found.trajectory;
  return py::make_tuple(stacked(trajectory.displacement), stacked(trajectory.velocity),
                        trajectory.cost.evaluations, trajectory.cost.operations, found.reason);
}

py::dict eigenvalues(const LagrangeSystem& system) {
  const dynamics::CirculantEigenvalues found = system.eigenvalues();
  py::dict result;
  result["gram"] = found.gram;
  result["mass"] = found.mass;
  result["damping"] = found.damping;
  result["stiffness"] = found.stiffness;
  return result;
}

py::list solver_table() {
  py::list result;
  for (const dynamics::NamedSolver& solver : dynamics::solvers()) {
    const char* takes = solver.accuracy == dynamics::AccuracyKind::step          ? "step"
                        : solver.accuracy == dynamics::AccuracyKind::closed_form ? "nothing"
                                                                                 : "tolerance";
    result.append(py::make_tuple(solver.name, solver.summary, takes, solver.is_massless));
  }
  return result;
}

}  // namespace

void add_dynamics(py::module_& module) {
  py::class_<LagrangeSystem>(module, "NativeLagrangeSystem", "M q'' + C q' + K q = Q.")
      .def(py::init([](const PythonFilter& filter, Eigen::Index samples, int levels, double density,
                       double stiffness, double bending, double mass_damping,
                       double stiffness_damping, double damping_density) {
             return LagrangeSystem(
                 filter.bank, samples, levels,
                 {density, stiffness, bending, mass_damping, stiffness_damping, damping_density});
           }),
           py::arg("filter"), py::arg("samples"), py::arg("levels"), py::arg("density"),
           py::arg("stiffness"), py::arg("bending"), py::arg("mass_damping"),
           py::arg("stiffness_damping"), py::arg("damping_density"))
      .def("mass", &LagrangeSystem::mass)
      .def("damping", &LagrangeSystem::damping)
      .def("stiffness", &LagrangeSystem::stiffness)
      .def("eigenvalues", &eigenvalues)
      .def("solve", &solve, py::arg("solver"), py::arg("tolerance"), py::arg("step"),
           py::arg("displacement"), py::arg("velocity"), py::arg("times"), py::arg("forces"),
           py::arg("rest"));
  module.def("solver_table", &solver_table,
             "(name, summary, what it takes, massless) of each solver.");
}

}  // namespace wavecurve::python
