#include "wavecurve/elementary/sine_cosine.hpp"

#include <cmath>
#include <limits>

#include "wavecurve/elementary/detail/elementary_kernels.hpp"
#include "wavecurve/elementary/detail/elementary_tables.hpp"
#include "wavecurve/elementary/detail/quarter_turns.hpp"
#include "wavecurve/elementary/detail/reduced.hpp"

namespace wavecurve {

SineCosine sine_cosine(double x) {
  if (!std::isfinite(x)) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    return {none, none};
  }
  const elementary::QuarterTurns turns = elementary::quarter_turns(x);
  const auto s = elementary::reduced_sine(elementary::sine_polynomial, turns.angle, turns.low);
  const auto c = elementary::reduced_cosine(elementary::cosine_polynomial, turns.angle, turns.low);
  // Not s.head + s.tail where the angle is -0, which a tail of +0 would make +0.
  const double sine = turns.angle == 0 ? turns.angle : s.head + s.tail, cosine = c.head + c.tail;
  switch (turns.quarters % 4) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case 2:
      return {-sine, -cosine};
    default:
      return {-cosine, sine};
  }
}

double sine(double x) { return sine_cosine(x).sine; }
double cosine(double x) { return sine_cosine(x).cosine; }

void sine_cosine(const Eigen::Ref<const Eigen::ArrayXd>& x, Eigen::Ref<Eigen::ArrayXd> sine,
                 Eigen::Ref<Eigen::ArrayXd> cosine) {
  elementary::check_sizes("sine_cosine", x.size(), sine.size());
  elementary::check_sizes("sine_cosine", x.size(), cosine.size());
  elementary::sine_cosine_of_array(x.data(), x.size(), sine.data(), cosine.data());
}

}  // namespace wavecurve
