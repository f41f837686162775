#include "verification/study/solver_study.hpp"

#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "verification/study/study_work.hpp"
#include "verification/suite/on_all_cores.hpp"

namespace wavecurve::verification {

namespace {

/// On all cores. What a hook throws leaves the other threads without work, and is thrown again; a
/// point that the machine could not do is told at the end.
void compute(StudyWork& study, const StudyHooks& hooks) {
  const std::vector<std::size_t> open = study.open();
  std::size_t done = study.points().size() - open.size();
  std::map<std::size_t, std::string> lacks;
  std::mutex access;
  const auto work = [&](std::size_t i) {
    const std::string lack = study.solve(open[i], hooks);
    if (lack.empty()) return;
    const std::scoped_lock lock(access);
    lacks[i] = lack;
  };
  const auto lacks_something = [&](std::size_t i) {
    const std::scoped_lock lock(access);
    return lacks.contains(i);
  };
  on_all_cores(open.size(), work, [&](std::size_t i) {
    if (hooks.finished && !lacks_something(i)) hooks.finished(study.points()[open[i]]);
    if (hooks.progress) hooks.progress(++done, study.points().size());
  });
  if (lacks.empty()) return;
  const auto& [first, what] = *lacks.begin();
  fail_for_lack(study.points()[open[first]], what, lacks.size());
}

}  // namespace

std::vector<StudyPoint> run_study(const StudyPlan& plan, const StudyHooks& hooks,
                                  const Shard& shard) {
  StudyWork study(plan, shard);
  if (hooks.known) study.take_up(hooks.known);
  compute(study, hooks);
  return std::move(study.points());
}

}  // namespace wavecurve::verification
