#include "wavecurve/filters/two_scale_matrix.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve {

void check_two_scale_arguments(int d, int coefficients) {
  constexpr int highest_order = 16;
  check_between("derivative order", d, 0, highest_order);
  const int fewest = 2 + first_two_scale_unknown(d);
  if (coefficients < fewest) {
    throw std::invalid_argument(
        fmt::format("the two-scale system of derivative order {} needs at least {} autocorrelation "
                    "coefficients, not {}",
                    d, fewest, coefficients));
  }
}

}  // namespace wavecurve
