#include <bit>
#include <stdexcept>

#include "benchmarks/kernels/kernel.hpp"

namespace wavecurve::tracking {

std::vector<Kernel> kernels() {
  std::vector<Kernel> all;
  for (const auto& room : {transform_kernels(), operator_kernels(), dynamics_kernels(),
                           curve_kernels(), certified_kernels()}) {
    all.insert(all.end(), room.begin(), room.end());
  }
  return all;
}

Kernel find_kernel(const std::string& name) {
  std::string known;
  for (const auto& list : {kernels(), plain_kernels()}) {
    for (const Kernel& kernel : list) {
      if (kernel.name == name) return kernel;
      known += (known.empty() ? "" : ", ") + kernel.name;
    }
  }
  throw std::invalid_argument("kernel '" + name + "': there are " + known);
}

int all_levels(Eigen::Index samples) {
  return std::bit_width(static_cast<std::size_t>(samples)) - 1;
}

}  // namespace wavecurve::tracking
