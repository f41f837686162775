#include "verification/quantities/quantity.hpp"

namespace wavecurve::verification {

const Quantity Quantity::taps = parse_quantity("h");
const Quantity Quantity::taps_sum_2 = parse_quantity("h*sqrt2");
const Quantity Quantity::taps_sum_1 = parse_quantity("h/sqrt2");
const Quantity Quantity::autocorrelation = parse_quantity("alpha");
const Quantity Quantity::mu = parse_quantity("mu");
const Quantity Quantity::nu = parse_quantity("nu");
const Quantity Quantity::mu_normalized = parse_quantity("mu/mu0");
const Quantity Quantity::nu_normalized = parse_quantity("nu/nu0");

}  // namespace wavecurve::verification
