#include <stdexcept>

#include "wavecurve/filters/detail/bad_value.hpp"

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
  std::vector<std::string> known;
  for (const auto& list : {kernels(), plain_kernels()}) {
    for (const Kernel& kernel : list) {
      if (kernel.name == name) return kernel;
      known.push_back(kernel.name);
    }
  }
  throw std::invalid_argument(unknown_name("kernel", name, known));
}

}  // namespace wavecurve::tracking
