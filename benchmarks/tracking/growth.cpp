#include "benchmarks/tracking/growth.hpp"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

namespace wavecurve::tracking {

namespace {

double stated_cost(double size, const std::string& stated) {
  if (stated == "N") return size;
  if (stated == "N log N") return size * std::log2(size);
  throw std::invalid_argument("growth '" + stated + "': N and N log N are known");
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void check(const std::vector<double>& sizes, const std::vector<double>& costs) {
  if (sizes.size() < 3 || sizes.size() != costs.size()) {
    throw std::invalid_argument(fmt::format("a growth of {} sizes and {} costs: at least 3 of each",
                                            sizes.size(), costs.size()));
  }
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (!(sizes[i] >= 2) || !(costs[i] > 0)) {
      throw std::invalid_argument(
          fmt::format("size {} with cost {}: at least 2, and above 0", sizes[i], costs[i]));
    }
  }
}

}  // namespace

GrowthFit fit_growth(const std::vector<double>& sizes, const std::vector<double>& costs,
                     const std::string& stated) {
  check(sizes, costs);
  std::vector<double> x, y;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    x.push_back(std::log(stated_cost(sizes[i], stated)));
    y.push_back(std::log(costs[i]));
  }
  const double x_mean = mean(x), y_mean = mean(y);
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - x_mean) * (x[i] - x_mean);
    xy += (x[i] - x_mean) * (y[i] - y_mean);
  }
  const double slope = xy / xx;
  double residual = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double off = y[i] - y_mean - slope * (x[i] - x_mean);
    residual += off * off;
  }
  const double freedom = static_cast<double>(x.size()) - 2;
  const double t = boost::math::quantile(boost::math::students_t(freedom), 0.975);
  const double half = t * std::sqrt(residual / freedom / xx);
  return {slope, slope - half, slope + half};
}

}  // namespace wavecurve::tracking
