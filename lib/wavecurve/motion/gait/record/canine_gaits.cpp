#include "wavecurve/motion/gait/record/canine_gaits.hpp"

#include <stdexcept>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::gait {

const std::vector<CanineGait>& canine_gaits() {
  static const std::vector<CanineGait> gaits{
      {"walk", {{{0, 0.62}, {0.5, 0.62}, {0.81, 0.62}, {0.31, 0.62}}}},
      {"trot", {{{0, 0.45}, {0.5, 0.45}, {0.5, 0.45}, {0, 0.45}}}},
      {"pace", {{{0, 0.45}, {0.5, 0.45}, {0, 0.45}, {0.5, 0.45}}}},
      {"gallop", {{{0, 0.25}, {0.82, 0.25}, {0.45, 0.25}, {0.57, 0.25}}}},
  };
  return gaits;
}

const CanineGait& find_canine_gait(std::string_view name) {
  for (const CanineGait& gait : canine_gaits()) {
    if (gait.name == name) return gait;
  }
  throw std::invalid_argument(unknown_name("gait", name, canine_gaits(), &CanineGait::name));
}

}  // namespace wavecurve::gait
