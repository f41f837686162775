#include "wavecurve/certified/detail/is_accurate.hpp"

namespace wavecurve::certified {

bool is_accurate(const Filter<Ball>& values, long bits) {
  Ball largest(0), radius(0);
  for (const Ball& value : values.taps) {
    const Ball magnitude = abs(value.midpoint());
    if (certainly_less(largest, magnitude)) largest = magnitude;
    if (certainly_less(radius, value.radius())) radius = value.radius();
  }
  return !certainly_less(largest * Ball(Rational::power_of_two(-bits)), radius);
}

}  // namespace wavecurve::certified
