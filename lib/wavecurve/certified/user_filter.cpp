#include "wavecurve/certified/user_filter.hpp"

#include <cstdlib>
#include <stdexcept>

#include "wavecurve/certified/detail/relations.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/autocorrelation.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

constexpr int most_taps = 1000, furthest_index = 10000;

/// Half a unit of the last printed digit: "0.125" -> 0.0005, "3e-4" -> 0.00005. A bare 0 is exact:
/// it says that the tap is absent.
Rational half_unit(const std::string& decimal) {
  if (decimal == "0") return Rational(0);
  std::string unit;
  std::size_t i = 0;
  for (; i < decimal.size() && decimal[i] != 'e' && decimal[i] != 'E'; ++i) {
    if (decimal[i] == '.') unit += '.';
    if (decimal[i] >= '0' && decimal[i] <= '9') unit += '0';
  }
  const auto last_digit = unit.find_last_of('0');
  unit[last_digit] = '1';
  return Rational::from_decimal(unit + decimal.substr(i)) / Rational(2);
}

/// The factor from the user's normalisation to the orthonormal one.
Ball normalising_factor(const std::string& sum) {
  if (sum == "sqrt2") return Ball(1);
  if (sum == "1") return sqrt(Ball(2));
  if (sum == "2") return sqrt(Ball(2)) / Ball(2);
  throw std::invalid_argument(must_be("the sum of a filter", sum, "'sqrt2', '1' or '2'"));
}

template <class Scalar>
FilterBank<Scalar> with_claims(const UserFilter& user, const Filter<Scalar>& analysis,
                               const Filter<Scalar>& synthesis) {
  auto bank = make_filter_bank(user.name, analysis, synthesis);
  bank.vanishing_moments = user.vanishing_moments.value_or(zeros_at_pi(synthesis));
  bank.dual_vanishing_moments = user.dual_vanishing_moments.value_or(
      user.dual ? zeros_at_pi(analysis) : bank.vanishing_moments);
  return bank;
}

Filter<Rational> exact_taps(const Filter<std::string>& printed) {
  Filter<Rational> filter{printed.first_index, {}};
  for (const std::string& text : printed.taps) filter.taps.push_back(Rational::from_decimal(text));
  return filter;
}

/// The bank of the decimals as they stand, in the user's normalisation.
FilterBank<Rational> exact_bank(const UserFilter& user) {
  const Filter<Rational> synthesis = exact_taps(user.taps);
  return with_claims(user, user.dual ? exact_taps(*user.dual) : synthesis, synthesis);
}

Filter<Ball> enclose(const Filter<std::string>& printed, const std::string& sum, bool exact) {
  Filter<Ball> filter{printed.first_index, {}};
  const Ball factor = normalising_factor(sum);
  for (const std::string& text : printed.taps) {
    const Rational value = Rational::from_decimal(text);
    const Ball tap = exact ? Ball(value) : Ball::around(value, half_unit(text));
    filter.taps.push_back(tap * factor);
  }
  return filter;
}

FilterBank<Ball> enclosing_bank(const UserFilter& user, bool exact) {
  const Filter<Ball> synthesis = enclose(user.taps, user.sum, exact);
  return with_claims(user, user.dual ? enclose(*user.dual, user.sum, exact) : synthesis, synthesis);
}

/// With the sum sqrt 2 no decimals are exact.
bool is_exact(const UserFilter& user) {
  return user.sum != "sqrt2" &&
         satisfies_relations(exact_bank(user), Rational::from_decimal(user.sum));
}

/// alpha in the orthonormal normalisation.
Filter<Rational> exact_autocorrelation(const Filter<Rational>& taps, const Rational& sum) {
  Filter<Rational> alpha = autocorrelation(taps);
  for (Rational& value : alpha.taps) value *= Rational(2) / (sum * sum);
  return alpha;
}

void require_sane(const UserFilter& user, const Filter<std::string>& filter) {
  const std::string whose = " of filter " + user.name;
  check_between("the number of taps" + whose, static_cast<long>(filter.taps.size()), 1, most_taps);
  check_between("the first index" + whose, filter.first_index, -furthest_index, furthest_index);
}

}  // namespace

FilterDefinition define_user_filter(const UserFilter& user) {
  require_sane(user, user.taps);
  if (user.dual) require_sane(user, *user.dual);
  for (const auto& claim : {user.vanishing_moments, user.dual_vanishing_moments}) {
    if (!claim) continue;
    check_between("the claimed number of vanishing moments of filter " + user.name, *claim, 0,
                  most_taps);
  }
  const WorkingPrecision precision(256);
  normalising_factor(user.sum);  // refuses an unknown sum
  const bool exact = is_exact(user);
  if (const auto violated = violated_relation(enclosing_bank(user, exact))) {
    throw std::invalid_argument("filter " + user.name + " violates " + violated->equation + " by " +
                                magnitude_bound(violated->residual) +
                                ", more than its digits explain");
  }
  FilterDefinition definition;
  definition.name = user.name;
  definition.bank = [user, exact](long bits) {
    const WorkingPrecision working(bits + 32);
    return enclosing_bank(user, exact);
  };
  if (exact) {
    const FilterBank<Rational> bank = exact_bank(user);
    const Rational sum = Rational::from_decimal(user.sum);
    definition.exact = ExactAutocorrelations{exact_autocorrelation(bank.synthesis_low, sum),
                                             exact_autocorrelation(bank.analysis_low, sum)};
  }
  return definition;
}

}  // namespace wavecurve::certified
