#include "benchmarks/kernels/environment.hpp"

#include <gnu/libc-version.h>

#include <Eigen/Core>
#include <boost/version.hpp>
#include <flint/flint.h>
#include <fmt/core.h>
#include <hwy/base.h>
#include <hwy/targets.h>

namespace wavecurve::tracking {

nlohmann::ordered_json environment() {
  nlohmann::ordered_json json = {
      {"compiler", WAVECURVE_COMPILER},
      {"flags", WAVECURVE_FLAGS},
      {"vectors", hwy::TargetName(hwy::SupportedTargets() & -hwy::SupportedTargets())}};
  json["libraries"] = {
      {"eigen",
       fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
      {"boost", BOOST_LIB_VERSION},
      {"flint", FLINT_VERSION},
      {"highway", WAVECURVE_HIGHWAY_VERSION},
      {"fmt", std::to_string(FMT_VERSION)},
      {"libstdc++", std::to_string(__GLIBCXX__)},
      {"libc", gnu_get_libc_version()},
      {"benchmark", WAVECURVE_BENCHMARK_VERSION},
  };
  return json;
}

}  // namespace wavecurve::tracking
