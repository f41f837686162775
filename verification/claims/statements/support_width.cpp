// The support widths of section 3.2, counted from the certified taps, and mu_l at the edge of the
// support: zero from P on by structure, and proved not to be zero just inside.
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/find_filter.hpp"
#include "wavecurve/certified/rounding.hpp"

#include "verification/suite/claim.hpp"

namespace wavecurve::verification::support_width_claim {

namespace {

constexpr long bits = 128;
constexpr int largest_k = 5;

struct Width {
  std::string filter;
  int moments = 0, width = 0;
  std::string edge;      ///< mu_{P-1}
  bool is_sharp = true;  ///< mu_{P-1} is proved not to be zero and none beyond is stored
};

Width width_of(const std::string& name) {
  const auto definition = certified::find_filter(name);
  const auto bank = definition.bank(bits);
  Width result{definition.name, bank.vanishing_moments, bank.synthesis_low.size() - 1, "", true};
  try {
    const certified::WorkingPrecision precision(bits);
    const auto mu = certified::connection_coefficients(definition, 1, 1, bits).mu;
    const certified::Ball edge = mu[result.width - 1];
    result.is_sharp = !edge.contains_zero() && mu[result.width] == certified::Ball(0);
    result.edge = certified::round_to_digits(edge, 3).value_or("undecided");
  } catch (const std::domain_error&) {  // not smooth enough
    result.edge = "infinite";
  }
  return result;
}

Outcome evaluate() {
  Table widths{"Vanishing moments, support width P of φ, and μ at the last index inside",
               {"K", "filter", "vanishing moments", "P", "expected", "μ at P - 1"},
               {}};
  int as_printed = 0;
  const auto add = [&](int k, const std::string& name, int expected) {
    const Width width = width_of(name);
    if (width.moments == 2 * k && width.width == expected && width.is_sharp) ++as_printed;
    widths.rows.push_back({std::to_string(k), width.filter, std::to_string(width.moments),
                           std::to_string(width.width), std::to_string(expected), width.edge});
  };
  for (int k = 1; k <= largest_k; ++k) {
    add(k, fmt::format("coif{}", k), 6 * k - 1);
    add(k, fmt::format("db{}", 2 * k), 4 * k - 1);
  }
  const auto filters = std::ssize(widths.rows);
  const bool holds = as_printed == filters;
  return {holds ? ClaimVerdict::holds : ClaimVerdict::does_not_hold,
          {"{} of {} filters as printed, K = 1 .. {}",
           {counted("filters as printed", as_printed), counted("filters", filters),
            counted("largest K", largest_k)}},
          "Counted from the certified taps. μ_l vanishes for |l| >= P, and for no smaller bound: "
          "the enclosure of μ at P - 1 excludes zero.",
          {widths}};
}

const RegisterClaim registered(
    {"support-width", "Support widths of coiflets and Daubechies wavelets",
     "Section 3.2, below (3.14)",
     "a Coiflet with 2K vanishing moments has a support of width 6K-1, as compared to 4K-1 for the "
     "Daubechies wavelet; μ_l = 0 for |l| >= P",
     evaluate});

}  // namespace

}  // namespace wavecurve::verification::support_width_claim
