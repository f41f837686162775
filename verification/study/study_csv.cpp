#include <string>

#include <fmt/format.h>

#include "wavecurve/io/files/detail/csv.hpp"

#include "verification/study/study_json.hpp"

namespace wavecurve::verification {

void write_csv(const std::vector<StudyPoint>& points, const io::TextSink& sink) {
  sink(
      "solver,filter,samples,levels,shape,s1,s2,tolerance,displacement_l2_max,"
      "displacement_l2_final,maximum_norm_max,maximum_norm_final,velocity_l2_max,"
      "velocity_l2_final,energy_norm_max,energy_norm_final,energy_drift,evaluations,operations,"
      "seconds,status\n");
  for (const StudyPoint& point : points) {
    const StudySetting& s = *point.setting;
    sink(fmt::format("{},{},{},{},{},{},{},{},", point.solver, io::csv_field(s.filter), s.samples,
                     s.levels, io::csv_field(s.shape), s.mass_damping, s.stiffness_damping,
                     point.tolerance ? fmt::format("{}", *point.tolerance) : ""));
    if (const auto& e = point.errors) {
      sink(fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},ok\n", e->displacement_l2_max,
                       e->displacement_l2_final, e->maximum_norm_max, e->maximum_norm_final,
                       e->velocity_l2_max, e->velocity_l2_final, e->energy_norm_max,
                       e->energy_norm_final, e->energy_drift, point.cost.evaluations,
                       point.cost.operations, point.seconds));
    } else {
      sink(",,,,,,,,,,,,failed\n");
    }
  }
}

}  // namespace wavecurve::verification
