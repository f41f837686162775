#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"

#include "benchmarks/kernels/kernel.hpp"

namespace wavecurve::tracking {

namespace {

constexpr long bits_of_50_digits = 170;

std::function<void()> coefficients(Eigen::Index order) {
  return [name = "db" + std::to_string(order)] {
    certified::connection_coefficients(certified::find_filter(name), 1, 1, bits_of_50_digits);
  };
}

std::function<void()> filter_bank(Eigen::Index order) {
  return [name = "db" + std::to_string(order)] {
    certified::find_filter(name).bank(bits_of_50_digits);
  };
}

}  // namespace

std::vector<Kernel> certified_kernels() {
  return {{"certified_coefficients", 4, coefficients}, {"certified_filter_bank", 10, filter_bank}};
}

}  // namespace wavecurve::tracking
