// The study of solvers.
#include <atomic>
#include <memory>
#include <pybind11/stl.h>
#include <string>
#include <tuple>
#include <vector>

#include "python/interruptible.hpp"
#include "python/topics.hpp"
#include "verification/study/solver_study.hpp"
#include "verification/study/study_json.hpp"
#include "verification/study/study_summary.hpp"

namespace wavecurve::python {

namespace {

using namespace verification;

using Setting = std::tuple<std::string, Eigen::Index, int, std::string, double, double>;

struct Interrupted {};

/// The points as lines of JSON, study_json.hpp. An interrupted run gives up its cores after the points
/// that they are at.
std::vector<std::string> study(const std::vector<Setting>& settings,
                               const std::vector<std::string>& solvers) {
  StudyPlan plan{{}, solvers};
  for (const auto& [filter, samples, levels, shape, s1, s2] : settings) {
    plan.settings.push_back({filter, samples, levels, shape, s1, s2});
  }
  const auto interrupted = std::make_shared<std::atomic<bool>>(false);
  try {
    return interruptible([plan, interrupted] {
      StudyHooks hooks;
      hooks.progress = [interrupted](std::size_t, std::size_t) {
        if (*interrupted) throw Interrupted{};
      };
      std::vector<std::string> lines;
      for (const StudyPoint& point : run_study(plan, hooks)) lines.push_back(to_json_line(point));
      return lines;
    });
  } catch (const py::error_already_set&) {
    *interrupted = true;
    throw;
  }
}

}  // namespace

void add_study(py::module_& module) {
  module.def("study", &study, py::arg("settings"), py::arg("solvers"));
}

}  // namespace wavecurve::python
