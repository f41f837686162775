#include "tools/commands/version.hpp"

#include <Eigen/Core>
#include <flint/flint.h>
#include <fmt/format.h>
#include <hwy/highway.h>

#include "tools/commands/revision.hpp"

namespace wavecurve::tools {

namespace {

/// The best of the instruction sets that were compiled and that the processor has is the lowest bit.
std::string instruction_set_in_use() {
  const auto usable = hwy::SupportedTargets() & HWY_TARGETS;
  return hwy::TargetName(usable & -usable);
}

}  // namespace

std::string version_text() {
  return fmt::format(
      "wavecurve {}\n"
      "revision  {}\n"
      "compiler  {}\n"
      "FLINT     {}\n"
      "Eigen     {}.{}.{}\n"
      "Highway   {}.{}.{}, using {}",
      WAVECURVE_VERSION, revision, WAVECURVE_COMPILER, FLINT_VERSION, EIGEN_WORLD_VERSION,
      EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, HWY_MAJOR, HWY_MINOR, HWY_PATCH,
      instruction_set_in_use());
}

}  // namespace wavecurve::tools
