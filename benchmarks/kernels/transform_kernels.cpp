#include <memory>

#include "wavecurve/filters/find_filter_bank.hpp"
#include "wavecurve/transform/periodic_transform.hpp"

#include "benchmarks/kernels/kernel.hpp"

namespace wavecurve::tracking {

namespace {

enum class Direction { forward, inverse };

std::function<void()> transform(const char* filter, Direction direction, Eigen::Index samples,
                                Eigen::Index columns) {
  const PeriodicTransform<double> dpwt(find_filter_bank<double>(filter), samples,
                                       all_levels(samples));
  const Eigen::MatrixXd x = Eigen::MatrixXd::Random(samples, columns);
  return [dpwt, direction, x, y = x,
          workspace = Eigen::VectorXd(dpwt.workspace_size(columns))]() mutable {
    if (direction == Direction::forward) dpwt.forward(x, y, workspace);
    if (direction == Direction::inverse) dpwt.inverse(x, y, workspace);
  };
}

Kernel single(std::string name, const char* filter, Direction direction, double operations) {
  Kernel kernel{std::move(name), 4096,
                [=](Eigen::Index samples) { return transform(filter, direction, samples, 1); }};
  kernel.counted_runs = 100;
  kernel.growth = Kernel::Growth::linear;
  kernel.sizes = {1024, 4096, 16384, 65536};
  kernel.bytes = 2 * 8 * 4096;
  // All levels together see 2 N samples.
  kernel.operations = 2 * operations * 4096;
  return kernel;
}

}  // namespace

std::vector<Kernel> transform_kernels() {
  // A sample of a level: 5 multiplications and 4 additions by four rotations; 9 and 7 products of
  // sums of the 9/7 pair, half of them with their additions.
  constexpr double rotations = 9, sums = 15;
  Kernel batch{"transform_batch", 64, [](Eigen::Index columns) {
                 return transform("db4", Direction::forward, 256, columns);
               }};
  batch.bytes = 2 * 8 * 64 * 256;
  batch.operations = 2 * rotations * 64 * 256;
  return {single("transform_forward", "db4", Direction::forward, rotations),
          single("transform_inverse", "db4", Direction::inverse, rotations),
          single("transform_forward_cdf9.7", "cdf9.7", Direction::forward, sums), batch};
}

}  // namespace wavecurve::tracking
