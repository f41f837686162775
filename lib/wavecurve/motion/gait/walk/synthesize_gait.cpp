#include "wavecurve/motion/gait/walk/synthesize_gait.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/motion/gait/model/detail/control_points.hpp"
#include "wavecurve/motion/gait/walk/ground_contact.hpp"

namespace wavecurve::gait {

namespace {

const LimbPath* find_path(const std::vector<LimbPath>& paths, std::string_view limb) {
  const auto found = std::find_if(paths.begin(), paths.end(),
                                  [&](const LimbPath& path) { return path.limb == limb; });
  return found == paths.end() ? nullptr : &*found;
}

LimbPath half_a_cycle_later(const LimbPath& path, std::string_view limb) {
  LimbPath later = path;
  later.limb = limb;
  later.offset += later.offset < 0.5 ? 0.5 : -0.5;
  return later;
}

std::string other_side(std::string_view limb) { return {limb[0] == 'L' ? 'R' : 'L', limb[1]}; }

/// One a limb, in the order of limb_names.
std::vector<LimbPath> all_four(const std::vector<LimbPath>& paths) {
  std::vector<LimbPath> result;
  for (std::string_view limb : limb_names) {
    const std::string other = other_side(limb);
    if (const LimbPath* own = find_path(paths, limb)) {
      result.push_back(*own);
    } else if (const LimbPath* same = find_path(paths, other)) {
      result.push_back(half_a_cycle_later(*same, limb));
    } else {
      throw std::invalid_argument(
          fmt::format("the parameters have neither limb {} nor limb {}", limb, other));
    }
  }
  return result;
}

/// So that the foot stands when the gait has it. From reversal to reversal it is longer.
void set_timing(LimbPath& path, const LimbTiming& timing, double facing) {
  constexpr double longest_stance = 0.95;
  const CyclePart contact = ground_contact(path, facing);
  const double stance = path.spans[0].share;
  CyclePart span{path.offset, stance};
  const double before = span.since(contact.begin) / stance;  // as a share of the stance
  const double share = std::min(longest_stance, timing.duty_factor * stance / contact.length);
  path.offset = timing.touch_down - before * share;
  path.spans[0].share = share;
  path.spans[1].share = 1 - share;
}

}  // namespace

std::vector<LimbPath> gait_paths(const GaitParameters& parameters,
                                 const std::optional<CanineGait>& gait) {
  std::vector<LimbPath> paths = all_four(parameters.limbs);
  if (!gait) return paths;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    set_timing(paths[i], gait->limbs[i], parameters.facing);
  }
  return paths;
}

std::vector<LimbPath> subcycle_paths(const GaitParameters& parameters) {
  return all_four(parameters.subcycles);
}

}  // namespace wavecurve::gait
