#include <algorithm>

#include "wavecurve/certified/detail/families/family.hpp"
#include "wavecurve/certified/detail/families/halfband_roots.hpp"
#include "wavecurve/certified/detail/polynomial.hpp"

// Symmetric biorthogonal pairs of less dissimilar lengths (Cohen, Daubechies, Feauveau 1992,
// section 6.C; Ten Lectures, section 8.3.4). With y = sin^2(w/2), D and E zeros at pi, both even,
// and N = (D + E) / 2, the two sides
//   low(w) = cos^D(w/2) S(y),   dual(w) = cos^E(w/2) A(y),   S A = P_N,   S(0) = A(0) = 1
// form a pair for every factorization of P_N. The splines leave all of P_N to the dual (spline.cpp);
// here either side takes some of the real factors.

namespace wavecurve::certified {

namespace {

/// One factorization: the numbers of the factors that S takes, in the order of
/// halfband_factors_in_y; A takes the others.
struct HalfbandPair {
  std::string_view name;
  int order, dual_order;  ///< D and E
  std::vector<std::size_t> factors;
};

/// The pairs of these names. bior5.5 is named after N alone, its sides have 6 and 4 zeros at pi.
const std::vector<HalfbandPair>& pairs() {
  static const std::vector<HalfbandPair> all{
      {"cdf9.7", 4, 4, {0}},   // the real root; 7 taps, and 9 of the pair of complex roots
      {"bior5.5", 6, 4, {0}},  // the complex roots to the left; 11 taps and 9
      {"bior6.8", 6, 8, {1}},  // those in the middle; 11 taps and 17
  };
  return all;
}

Filter<Ball> symmetric_low_pass(int zeros_at_pi, const Polynomial<Ball>& in_y) {
  const auto low = averaging_polynomial<Ball>(zeros_at_pi) * in_sine_squared(in_y);
  const Ball root_two = sqrt(Ball(2));
  Filter<Ball> filter{-static_cast<int>(low.size() / 2), low};
  for (Ball& tap : filter.taps) tap *= root_two;
  return filter;
}

FilterBank<Ball> bank_of(const HalfbandPair& pair) {
  const auto factors = halfband_factors_in_y((pair.order + pair.dual_order) / 2);
  Polynomial<Ball> synthesis{Ball(1)}, analysis{Ball(1)};
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const bool taken = std::find(pair.factors.begin(), pair.factors.end(), k) != pair.factors.end();
    Polynomial<Ball>& side = taken ? synthesis : analysis;
    side = side * factors[k];
  }
  auto bank =
      make_filter_bank(std::string(pair.name), symmetric_low_pass(pair.dual_order, analysis),
                       symmetric_low_pass(pair.order, synthesis));
  bank.vanishing_moments = pair.order;
  bank.dual_vanishing_moments = pair.dual_order;
  return bank;
}

std::optional<FilterDefinition> define_halfband_pair(std::string_view name) {
  for (const HalfbandPair& pair : pairs()) {
    if (pair.name != name) continue;
    FilterDefinition definition;
    definition.name = name;
    definition.bank = [&pair](long bits) {
      return with_accuracy(bits, [&] { return bank_of(pair); });
    };
    return definition;
  }
  return std::nullopt;
}

}  // namespace

Family halfband_pair_family() {
  Family family{"cdf9.7 (aliases bior4.4, cdf97, antonini), bior5.5, bior6.8",
                {},
                {{"bior4.4", "cdf9.7"}, {"cdf97", "cdf9.7"}, {"antonini", "cdf9.7"}},
                define_halfband_pair};
  for (const HalfbandPair& pair : pairs()) family.members.emplace_back(pair.name);
  return family;
}

}  // namespace wavecurve::certified
