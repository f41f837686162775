// The equation of motion by SUNDIALS' CVODE and ARKODE with the library's own operator, versions 6 and 7:
// a part of dynamics_benchmark where SUNDIALS is installed.
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_config.h>
#if SUNDIALS_VERSION_MAJOR >= 7
#include <sundials/sundials_context.hpp>
#else
#include <sundials/sundials_context.h>
#endif
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <benchmark/benchmark.h>

#include "wavecurve/dynamics/modal/spectral.hpp"
#include "wavecurve/dynamics/stepping/detail/equation_of_motion.hpp"

#include "benchmarks/kernels/test_problem.hpp"

namespace wavecurve {
namespace {

using tracking::ellipse;

/// The operator of the matrix-free coupled solver, as SUNDIALS calls it.
struct Peer {
  dynamics::EquationOfMotion motion;
  Eigen::Index rows;

  static int evaluate(sunrealtype t, N_Vector y, N_Vector derivative, void* data) {
    auto& peer = *static_cast<Peer*>(data);
    const Eigen::Index size = 2 * peer.rows;  // of two coordinates
    const double* in = N_VGetArrayPointer(y);
    double* out = N_VGetArrayPointer(derivative);
    const Eigen::Map<const Eigen::MatrixXd> q(in, peer.rows, 2), v(in + size, peer.rows, 2);
    Eigen::Map<Eigen::MatrixXd>(out, peer.rows, 2) = v;
    peer.motion(t, q, v, Eigen::Map<Eigen::MatrixXd>(out + size, peer.rows, 2));
    return 0;
  }
};

enum class Sundials { bdf, adams, explicit_runge_kutta };

Eigen::MatrixXd solve_sundials(const dynamics::InitialValueProblem& problem, Sundials method,
                               double tolerance, long long& evaluations) {
  const Eigen::Index rows = problem.system.samples();
  Peer peer = {dynamics::EquationOfMotion(problem, false), rows};
  sundials::Context context;
  N_Vector y = N_VNew_Serial(4 * rows, context);
  Eigen::Map<Eigen::MatrixXd> state(N_VGetArrayPointer(y), rows, 4);
  state << problem.initial_displacement, Eigen::MatrixXd::Zero(rows, 2);
  const double end = problem.times[problem.times.size() - 1];
  sunrealtype reached = 0;
  if (method == Sundials::explicit_runge_kutta) {
    void* memory = ERKStepCreate(Peer::evaluate, 0, y, context);
// The interface that all of ARKODE's methods share came with 7.1.
#if SUNDIALS_VERSION_MAJOR > 7 || (SUNDIALS_VERSION_MAJOR == 7 && SUNDIALS_VERSION_MINOR > 0)
    ARKodeSStolerances(memory, tolerance, tolerance);
    ARKodeSetUserData(memory, &peer);
    ARKodeSetMaxNumSteps(memory, 1 << 30);
    ARKodeEvolve(memory, end, y, &reached, ARK_NORMAL);
    ARKodeFree(&memory);
#else
    ERKStepSStolerances(memory, tolerance, tolerance);
    ERKStepSetUserData(memory, &peer);
    ERKStepSetMaxNumSteps(memory, 1 << 30);
    ERKStepEvolve(memory, end, y, &reached, ARK_NORMAL);
    ERKStepFree(&memory);
#endif
  } else {
    void* memory = CVodeCreate(method == Sundials::bdf ? CV_BDF : CV_ADAMS, context);
    CVodeInit(memory, Peer::evaluate, 0, y);
    CVodeSStolerances(memory, tolerance, tolerance);
    CVodeSetUserData(memory, &peer);
    CVodeSetMaxNumSteps(memory, 1 << 30);
    SUNLinearSolver linear = nullptr;
    SUNNonlinearSolver fixed_point = nullptr;
    if (method == Sundials::bdf) {
      linear = SUNLinSol_SPGMR(y, SUN_PREC_NONE, 0, context);
      CVodeSetLinearSolver(memory, linear, nullptr);
    } else {
      fixed_point = SUNNonlinSol_FixedPoint(y, 0, context);
      CVodeSetNonlinearSolver(memory, fixed_point);
    }
    CVode(memory, end, y, &reached, CV_NORMAL);
    CVodeFree(&memory);
    if (linear) SUNLinSolFree(linear);
    if (fixed_point) SUNNonlinSolFree(fixed_point);
  }
  evaluations = peer.motion.cost().evaluations;
  const Eigen::MatrixXd result = state.leftCols(2);
  N_VDestroy(y);
  return result;
}

void sundials_peer(benchmark::State& state, Sundials method, double tolerance) {
  dynamics::InitialValueProblem problem = ellipse(state.range(0), 1);
  Eigen::MatrixXd end;
  long long evaluations = 0;
  for (auto _ : state) end = solve_sundials(problem, method, tolerance, evaluations);
  const Eigen::MatrixXd exact = dynamics::solve_spectral(problem).displacement[0];
  state.counters["error"] = (end - exact).norm() / problem.initial_displacement.norm();
  state.counters["evaluations"] = static_cast<double>(evaluations);
}

BENCHMARK_CAPTURE(sundials_peer, cvode_adams_1e6, Sundials::adams, 1e-6)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sundials_peer, cvode_adams_1e8, Sundials::adams, 1e-8)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sundials_peer, cvode_bdf_1e6, Sundials::bdf, 1e-6)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sundials_peer, cvode_bdf_1e8, Sundials::bdf, 1e-8)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sundials_peer, arkode_1e6, Sundials::explicit_runge_kutta, 1e-6)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sundials_peer, arkode_1e8, Sundials::explicit_runge_kutta, 1e-8)
    ->Arg(256)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace wavecurve
