#include <memory>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/operators/connection_coefficients.hpp"
#include "wavecurve/operators/multiscale_matrix.hpp"
#include "wavecurve/operators/multiscale_operator.hpp"

#include "benchmarks/kernels/kernel.hpp"

namespace wavecurve::tracking {

namespace {

std::function<void()> product(Eigen::Index samples) {
  auto k = std::make_shared<MultiscaleOperator>(find_filter_bank<double>("db4"), samples,
                                                all_levels(samples));
  const Eigen::VectorXd x = Eigen::VectorXd::Random(samples);
  return [k, x, y = x]() mutable { k->apply(x, y); };
}

std::function<void()> assembly(Eigen::Index samples) {
  return [bank = find_filter_bank<double>("db4"), samples] {
    stiffness(bank, samples, all_levels(samples));
  };
}

/// The argument is the order of the filter.
std::function<void()> coefficients(Eigen::Index order) {
  return [bank = find_filter_bank<double>("db" + std::to_string(order))] {
    connection_coefficients(bank);
  };
}

}  // namespace

std::vector<Kernel> operator_kernels() {
  Kernel apply{"operator_product", 4096, product};
  apply.growth = Kernel::Growth::linear;
  apply.sizes = {1024, 4096, 16384, 65536};
  apply.bytes = 2 * 8 * 4096;
  // A sample: two transforms of 18, and the circulant of 7 multiplications and 12 additions.
  apply.operations = (2 * 18 + 7 + 12) * 4096;
  Kernel assemble{"assembly", 1024, assembly};
  assemble.growth = Kernel::Growth::linearithmic;
  assemble.sizes = {256, 1024, 4096, 8192};
  // What it writes: a double and an index each non-zero.
  const auto non_zeros = stiffness(find_filter_bank<double>("db4"), 1024, 10).nonZeros();
  assemble.bytes = 12 * static_cast<double>(non_zeros);
  return {apply, assemble, {"connection_coefficients", 10, coefficients}};
}

}  // namespace wavecurve::tracking
