#include "verification/study/power_fit.hpp"

#include <cmath>
#include <stdexcept>

#include <Eigen/Core>
#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include "wavecurve/elementary/logarithm.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::verification {

namespace {

Eigen::ArrayXd logarithms(const char* name, const std::vector<double>& values) {
  Eigen::ArrayXd logs(static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(values[i] > 0)) {
      throw std::invalid_argument(
          must_be(fmt::format("{} of pair {}", name, i), values[i], "above 0"));
    }
    logs[static_cast<Eigen::Index>(i)] = logarithm(values[i]);
  }
  return logs;
}

}  // namespace

PowerFit fit_power(const std::vector<double>& x, const std::vector<double>& y) {
  if (x.size() != y.size() || x.size() < 3) {
    throw std::invalid_argument(
        fmt::format("a power is to be fitted to {} x and {} y, but needs at least 3 pairs",
                    x.size(), y.size()));
  }
  Eigen::ArrayXd a = logarithms("x", x), b = logarithms("y", y);
  a -= a.mean();
  b -= b.mean();
  const double spread = a.square().sum();
  if (!(spread > 0)) throw std::invalid_argument("all x are equal, but two must differ");
  const double slope = (a * b).sum() / spread;
  const auto freedom = static_cast<double>(x.size() - 2);
  const double deviation = std::sqrt((b - slope * a).square().sum() / freedom / spread);
  const double half = boost::math::quantile(boost::math::students_t(freedom), 0.975) * deviation;
  return {slope, slope - half, slope + half, x.size()};
}

}  // namespace wavecurve::verification
