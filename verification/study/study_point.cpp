#include "verification/study/study_point.hpp"

#include <fmt/format.h>

namespace wavecurve::verification {

std::shared_ptr<const StudySetting> default_setting() {
  static const auto setting = std::make_shared<const StudySetting>();
  return setting;
}

std::string name_of(const StudyPoint& point) {
  const StudySetting& s = *point.setting;
  return fmt::format("{}{} (filter {}, {} samples, {} levels, shape {}, damping {}, {})",
                     point.solver,
                     point.tolerance ? fmt::format(" at {}", *point.tolerance) : std::string(),
                     s.filter, s.samples, s.levels, s.shape, s.mass_damping, s.stiffness_damping);
}

}  // namespace wavecurve::verification
