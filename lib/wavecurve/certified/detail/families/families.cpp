#include "wavecurve/certified/detail/families/families.hpp"

#include <algorithm>
#include <stdexcept>

#include "wavecurve/certified/detail/refine.hpp"
#include "wavecurve/certified/find_filter.hpp"

namespace wavecurve::certified {

const std::vector<Family>& families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> list{daubechies_family(), symlet_family(), coiflet_family(),
                             spline_family(), halfband_pair_family()};
    list.push_back(reversed_pair_family(list));
    return list;
  }();
  return all;
}

std::string canonical_filter_name(std::string_view name) { return find_filter(name).name; }

FilterDefinition find_filter(std::string_view name) {
  std::string canonical(name);
  for (const Family& family : families()) {
    for (const auto& [alias, target] : family.aliases) {
      if (alias == name) canonical = target;
    }
  }
  for (const Family& family : families()) {
    if (auto definition = family.define(canonical)) return *definition;
  }
  std::vector<std::string> known;
  for (const Family& family : families()) known.push_back(family.names);
  refuse_filter_name(name, known);
}

std::vector<std::string> filter_names() {
  std::vector<std::string> names;
  for (const Family& family : families()) {
    names.insert(names.end(), family.members.begin(), family.members.end());
  }
  return names;
}

FilterBank<Ball> with_accuracy(long bits, const std::function<FilterBank<Ball>()>& make) {
  constexpr long guard_bits = 40;
  const auto accurate = [bits](const Filter<Ball>& filter) {
    return std::all_of(filter.taps.begin(), filter.taps.end(), [bits](const Ball& tap) {
      return (tap.is_exact() && tap.contains_zero()) || tap.accuracy_bits() >= bits;
    });
  };
  FilterBank<Ball> bank;
  const bool reached = refine(bits + guard_bits, [&](long) {
    bank = make();
    return accurate(bank.analysis_low) && accurate(bank.synthesis_low);
  });
  if (reached) return bank;
  throw std::runtime_error("a filter did not reach " + std::to_string(bits) + " bits of accuracy");
}

FilterBank<Ball> orthonormal_bank(const std::string& name, Filter<Ball> mask,
                                  int vanishing_moments) {
  const Ball root_two = sqrt(Ball(2));
  for (Ball& tap : mask.taps) tap *= root_two;
  auto bank = make_filter_bank(name, mask, mask);
  bank.vanishing_moments = bank.dual_vanishing_moments = vanishing_moments;
  return bank;
}

std::optional<FilterDefinition> define_by_order(std::string_view prefix, std::string_view name,
                                                int lowest, int highest, const BankOfOrder& bank) {
  const auto order = number_after(prefix, name);
  if (!order) return std::nullopt;
  require_order(name, *order, lowest, highest);
  FilterDefinition definition;
  definition.name = name;
  definition.bank = [bank, name = definition.name, order = *order](long bits) {
    return with_accuracy(bits, [&] { return bank(name, order); });
  };
  return definition;
}

ExactAutocorrelations halfband_autocorrelations(int order) {
  // |H(w)|^2 = 2 cos^{2N}(w/2) P_N(sin^2(w/2)) and alpha_n is twice its n-th Fourier coefficient.
  const auto cosine = averaging_polynomial<Rational>(2 * order);
  const auto product = cosine * in_sine_squared(halfband_polynomial(order));
  Filter<Rational> alpha{0, {}};
  for (std::size_t n = product.size() / 2; n < product.size(); ++n) {
    alpha.taps.push_back(product[n] * Rational(4));
  }
  return {alpha, alpha};
}

}  // namespace wavecurve::certified
