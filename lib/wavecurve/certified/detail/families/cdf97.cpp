#include "wavecurve/certified/detail/families/family.hpp"
#include "wavecurve/certified/detail/families/halfband_roots.hpp"
#include "wavecurve/certified/detail/polynomial.hpp"

namespace wavecurve::certified {

namespace {

constexpr int zeros_at_pi = 4;  // of either side

Filter<Ball> symmetric_low_pass(const Polynomial<Ball>& in_y) {
  const auto low = averaging_polynomial<Ball>(zeros_at_pi) * in_sine_squared(in_y);
  const Ball root_two = sqrt(Ball(2));
  Filter<Ball> filter{-static_cast<int>(low.size() / 2), low};
  for (Ball& tap : filter.taps) tap *= root_two;
  return filter;
}

/// P_4(y) = 1 + 4y + 10y^2 + 20y^3 = (1 - y/r) (1 + b y + c y^2), r its only real root: the linear
/// factor goes to the 7 synthesis taps, the quadratic one to the 9 analysis taps (Cohen,
/// Daubechies, Feauveau 1992, section 6.C).
FilterBank<Ball> cdf97_bank(const std::string& name) {
  const Ball s = Ball(1) / halfband_real_root(zeros_at_pi);
  const Ball b = Ball(4) + s;       // coefficient of y:   4 = b - s
  const Ball c = Ball(10) + s * b;  // coefficient of y^2: 10 = c - s b
  auto bank = make_filter_bank(name, symmetric_low_pass({Ball(1), b, c}),
                               symmetric_low_pass({Ball(1), -s}));
  bank.vanishing_moments = bank.dual_vanishing_moments = zeros_at_pi;
  return bank;
}

std::optional<FilterDefinition> define_cdf97(std::string_view name) {
  if (name != "cdf9.7") return std::nullopt;
  FilterDefinition definition;
  definition.name = name;
  definition.bank = [name = definition.name](long bits) {
    return with_accuracy(bits, [&] { return cdf97_bank(name); });
  };
  return definition;
}

}  // namespace

Family cdf97_family() {
  return {"cdf9.7 (alias bior4.4)", {"cdf9.7"}, {{"bior4.4", "cdf9.7"}}, define_cdf97};
}

}  // namespace wavecurve::certified
