#include "wavecurve/certified/user_filter.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "wavecurve/certified/detail/distance_to_exact_filter.hpp"
#include "wavecurve/certified/detail/printed_side.hpp"
#include "wavecurve/certified/detail/relations.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/autocorrelation.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

/// What a user says of a bank; on the analysis side only where it is not the synthesis side.
struct PrintedBank {
  std::string name;
  PrintedSide synthesis;
  std::optional<PrintedSide> analysis;
  std::optional<int> vanishing_moments, dual_vanishing_moments;

  template <class Taps>
  auto with_claims(Taps taps) const {
    const auto low = taps(synthesis);
    auto bank = make_filter_bank(name, analysis ? taps(*analysis) : low, low);
    // No more zeros are possible: the product of both sides is a half-band filter. An orthonormal
    // filter has one at least.
    const int most = (bank.analysis_low.size() + bank.synthesis_low.size()) / (analysis ? 2 : 4);
    const int least = analysis ? 0 : std::min(1, most);
    const auto admitted = [&](const auto& side) {
      return std::clamp(zeros_at_pi(side), least, most);
    };
    bank.vanishing_moments = vanishing_moments.value_or(admitted(bank.synthesis_low));
    bank.dual_vanishing_moments = dual_vanishing_moments.value_or(
        analysis ? admitted(bank.analysis_low) : bank.vanishing_moments);
    return bank;
  }

  FilterBank<Ball> enclosures() const {
    return with_claims([](const PrintedSide& side) { return side.enclosures(); });
  }

  /// The numbers as they stand, with the sum 2.
  FilterBank<Rational> exact() const {
    return with_claims([](const PrintedSide& side) { return side.scaled_to_two(); });
  }

  bool is_exact() const {
    return synthesis.may_be_exact() && (!analysis || analysis->may_be_exact()) &&
           satisfies_relations(exact(), Rational(2));
  }

  bool has_stated_accuracy() const {
    return synthesis.has_stated_accuracy() || (analysis && analysis->has_stated_accuracy());
  }

  PrintedBank with_accuracy(const Rational& accuracy) const {
    PrintedBank other = *this;
    other.synthesis = synthesis.with_accuracy(accuracy);
    if (analysis) other.analysis = analysis->with_accuracy(accuracy);
    return other;
  }
};

PrintedBank read(const UserFilter& user) {
  // It stands in every message.
  constexpr long longest_name = 200;
  check_between("the number of characters of the filter's name",
                static_cast<long>(user.name.size()), 0, longest_name);
  PrintedBank bank{user.name,
                   PrintedSide(user.name, user.taps, user.sum, user.accuracy),
                   {},
                   user.vanishing_moments,
                   user.dual_vanishing_moments};
  if (user.dual) {
    bank.analysis.emplace(user.name, *user.dual, user.dual_sum.value_or(user.sum),
                          user.dual_accuracy ? user.dual_accuracy : user.accuracy);
  }
  for (const auto& claim : {user.vanishing_moments, user.dual_vanishing_moments}) {
    if (!claim) continue;
    check_between("the claimed number of vanishing moments of filter " + user.name, *claim, 0,
                  bank.enclosures().synthesis_low.size());
  }
  return bank;
}

/// A filter that satisfies all relations, near the printed taps.
struct NearFilter {
  int vanishing_moments = 0, dual_vanishing_moments = 0;
  Ball distance;  ///< in the units of the print
};

/// The zeros at pi that are meant are those that the taps have to the accuracy of the table, and
/// this is the distance of the filter that has them. Looked for at levels of accuracy, from that of
/// double arithmetic on: the first that holds such a filter.
std::optional<NearFilter> near_filter(const PrintedBank& printed, int coarsest_level) {
  const Ball unit = printed.synthesis.normalising_factor();
  const Ball dual_unit = printed.analysis.value_or(printed.synthesis).normalising_factor();
  for (int level = 15; level >= coarsest_level; level -= 2) {
    const Rational accuracy = Rational::from_decimal("1e-" + std::to_string(level));
    const FilterBank<Ball> bank = printed.with_accuracy(accuracy).enclosures();
    const auto [synthesis, analysis] = distance_to_exact_filter(bank);
    const double distance =
        std::max(synthesis / unit.to_double(), analysis / dual_unit.to_double());
    if (distance <= Ball(accuracy).to_double()) {
      return NearFilter{bank.vanishing_moments, bank.dual_vanishing_moments,
                        Ball::from_double(distance)};
    }
  }
  return std::nullopt;
}

bool would_be_accepted(const PrintedBank& printed, const std::string& accuracy,
                       const NearFilter& near) {
  FilterBank<Ball> bank = printed.with_accuracy(Rational::from_decimal(accuracy)).enclosures();
  bank.vanishing_moments = std::max(bank.vanishing_moments, near.vanishing_moments);
  bank.dual_vanishing_moments = std::max(bank.dual_vanishing_moments, near.dual_vanishing_moments);
  return !violated_relation(bank);
}

/// The least accuracy of one digit at which the bank is accepted and, to first order, holds the
/// near filter. For long filters doubles may not find that one; then it is the least power of ten
/// at which the bank is accepted.
std::optional<std::string> acceptable_accuracy(const PrintedBank& printed) {
  constexpr int coarsest_level = 9, finest_level = 17, most_doublings = 10;
  const auto near = near_filter(printed, coarsest_level);
  std::vector<std::string> candidates;
  for (int level = finest_level; !near && level >= coarsest_level; --level) {
    candidates.push_back("1e-" + std::to_string(level));
  }
  for (int doubling = 0; near && doubling < most_doublings; ++doubling) {
    candidates.push_back(magnitude_bound(near->distance * Ball(Rational::power_of_two(doubling))));
  }
  for (const std::string& accuracy : candidates) {
    if (would_be_accepted(printed, accuracy, near.value_or(NearFilter{}))) return accuracy;
  }
  return std::nullopt;
}

/// Tables of double arithmetic may have digits that are right enough for the sums and not for the
/// zeros at pi that are meant: these are claimed, so that the table is not taken for another filter.
void claim_zeros_that_are_meant(PrintedBank& printed) {
  constexpr int level_of_doubles = 15;
  if (printed.has_stated_accuracy()) return;
  const auto near = near_filter(printed, level_of_doubles);
  const FilterBank<Ball> bank = printed.enclosures();
  if (!near) return;
  printed.vanishing_moments = std::max(bank.vanishing_moments, near->vanishing_moments);
  printed.dual_vanishing_moments =
      std::max(bank.dual_vanishing_moments, near->dual_vanishing_moments);
}

void require_relations(const PrintedBank& printed) {
  const auto violated = violated_relation(printed.enclosures());
  if (!violated) return;
  const bool is_stated = printed.has_stated_accuracy();
  const auto accuracy = acceptable_accuracy(printed);
  throw std::invalid_argument(
      "filter " + printed.name + " violates " + violated->equation + " by " +
      magnitude_bound(violated->residual) + ", more than its " +
      (is_stated ? "accuracy" : "digits") + " explain" + (is_stated ? "s" : "") +
      (accuracy ? "; with \"accuracy\": \"" + *accuracy + "\" it would be accepted" : ""));
}

/// alpha in the orthonormal normalisation, of taps with the sum 2.
Filter<Rational> exact_autocorrelation(const Filter<Rational>& taps) {
  Filter<Rational> alpha = autocorrelation(taps);
  for (Rational& value : alpha.taps) value /= Rational(2);
  return alpha;
}

}  // namespace

FilterDefinition define_user_filter(const UserFilter& user) {
  const WorkingPrecision precision(256);
  PrintedBank printed = read(user);
  FilterDefinition definition;
  definition.name = user.name;
  if (printed.is_exact()) {
    printed.synthesis.make_exact();
    if (printed.analysis) printed.analysis->make_exact();
    const FilterBank<Rational> bank = printed.exact();
    definition.exact = ExactAutocorrelations{exact_autocorrelation(bank.synthesis_low),
                                             exact_autocorrelation(bank.analysis_low)};
    definition.two_scale = bank;
  } else {
    claim_zeros_that_are_meant(printed);
    require_relations(printed);
  }
  definition.known_bits = printed.synthesis.known_bits();
  definition.dual_known_bits =
      printed.analysis ? printed.analysis->known_bits() : definition.known_bits;
  definition.bank = [printed = std::move(printed)](long bits) {
    const WorkingPrecision working(bits + 32);
    return printed.enclosures();
  };
  return definition;
}

}  // namespace wavecurve::certified
