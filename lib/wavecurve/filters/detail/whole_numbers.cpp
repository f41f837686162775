#include "wavecurve/filters/detail/whole_numbers.hpp"

#include <stdexcept>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

int checked_log2(Eigen::Index samples) {
  if (!is_power_of_two(samples) || samples > Eigen::Index{1} << 24) {
    throw std::invalid_argument(must_be("samples", samples, "a power of two from 1 to 2^24"));
  }
  return all_levels(samples);
}

}  // namespace wavecurve
