#include <algorithm>
#include <array>
#include <stdexcept>

#include <fmt/format.h>

#include "wavecurve/certified/detail/families/family.hpp"
#include "wavecurve/certified/detail/families/halfband_roots.hpp"

// Symlets: the least asymmetric choice among the 2^G subsets of the G root groups of P_N.
//
// Criterion. On 0 < w < pi the phase of sum h_n e^{-iwn} is linear in w up to
//   Phi(w) = sum_g e_g sum_{z in g} arg(1 - z e^{-iw}) = sum_m c_m sin(m w) / m,  c_m = sum_g e_g
//   p_m(g),
// with z the roots inside the unit circle, p_m(g) = sum_{z in g} z^m, and e_g = +1 or -1 for a
// group whose roots are taken inside or outside. Phi vanishes at 0 and pi, so no line has to be
// fitted. The symlet minimises the mean square of this nonlinear phase,
//   E = (2/pi) int_0^pi Phi(w)^2 dw = sum_m (c_m / m)^2
// (in the spirit of Ten Lectures, section 8.1.1). The minimum is proved: the enclosure of its E
// lies below that of every other choice.
//
// Ties. E does not change when all e_g do: a filter and its mirror image are equally asymmetric.
// This is the only tie. The established tables (those of PyWavelets and MATLAB) follow no rule; for
// most orders the group with the largest |z| has its roots outside the unit circle, for the orders
// listed in `mirrored` inside. For N = 2, 3 the result is db2, db3.

namespace wavecurve::certified {

namespace {

constexpr int lowest_order = 2, highest_symlet_order = 20;
/// The least asymmetric filters of R are these symlets or their mirror images
/// (docs/conventions.md).
constexpr int lowest_la_order = 4, highest_la_order = 10;
constexpr std::array mirrored{4, 6, 8, 10, 17, 18};
constexpr long decision_bits = 128;

/// The product and the sum of the roots z inside the unit circle of one factor, and their number.
struct RootGroup {
  Ball sum, product;
  bool is_pair = false;

  explicit RootGroup(const Polynomial<Ball>& factor)
      : sum(-(factor[1] / factor[0])),
        product(factor.size() == 3 ? factor[2] / factor[0] : Ball(0)),
        is_pair(factor.size() == 3) {}

  Ball modulus() const { return is_pair ? sqrt(product) : abs(sum); }

  /// p_1 .. p_count by Newton's recurrence p_m = sum p_{m-1} - product p_{m-2}.
  std::vector<Ball> power_sums(int count) const {
    std::vector<Ball> p{Ball(is_pair ? 2 : 1), sum};
    while (static_cast<int>(p.size()) <= count) {
      p.push_back(sum * p.back() - product * p[p.size() - 2]);
    }
    return p;
  }
};

/// E for every choice; bit g of the index says that group g lies outside.
std::vector<Ball> nonlinear_phases(const std::vector<RootGroup>& groups,
                                   const Ball& largest_modulus, int number_of_roots) {
  constexpr int terms = 100;
  std::vector<std::vector<Ball>> p;
  for (const RootGroup& group : groups) p.push_back(group.power_sums(terms));
  // |c_m| <= (N-1) r^m bounds the tail by ((N-1) / (terms+1))^2 r^{2(terms+1)} / (1 - r^2).
  const Ball square = largest_modulus * largest_modulus;
  const Ball ratio = Ball(number_of_roots) / Ball(terms + 1);
  const Ball tail = ratio * ratio * pow(square, terms + 1) / (Ball(1) - square);
  std::vector<Ball> energies;
  for (std::size_t choice = 0; choice < std::size_t{1} << groups.size(); ++choice) {
    Ball energy(0);
    for (int m = 1; m <= terms; ++m) {
      Ball c(0);
      for (std::size_t g = 0; g < groups.size(); ++g) {
        const Ball& term = p[g][static_cast<std::size_t>(m)];
        (choice >> g & 1) != 0 ? c -= term : c += term;
      }
      c /= Ball(m);
      energy += c * c;
    }
    energies.push_back(hull(energy, energy + tail));
  }
  return energies;
}

/// The choice, as bits, whose E is proved smallest among those with the reference group outside.
std::size_t least_asymmetric(const std::vector<Ball>& energies, std::size_t reference_group) {
  const auto admissible = [&](std::size_t choice) { return (choice >> reference_group & 1) != 0; };
  std::size_t best = std::size_t{1} << reference_group;
  for (std::size_t choice = 0; choice < energies.size(); ++choice) {
    if (admissible(choice) && certainly_less(energies[choice], energies[best])) best = choice;
  }
  for (std::size_t choice = 0; choice < energies.size(); ++choice) {
    if (admissible(choice) && choice != best && !certainly_less(energies[best], energies[choice])) {
      throw std::runtime_error("the least asymmetric choice of roots could not be decided");
    }
  }
  return best;
}

std::size_t chosen_roots(int order) {
  const WorkingPrecision precision(decision_bits);
  std::vector<RootGroup> groups;
  for (const auto& factor : halfband_factors(order)) groups.emplace_back(factor);
  std::size_t reference = 0;
  for (std::size_t g = 1; g < groups.size(); ++g) {
    if (certainly_less(groups[reference].modulus(), groups[g].modulus())) reference = g;
  }
  const auto energies = nonlinear_phases(groups, groups[reference].modulus(), order - 1);
  const std::size_t outside = least_asymmetric(energies, reference);
  const std::size_t all = (std::size_t{1} << groups.size()) - 1;
  const bool mirror = std::find(mirrored.begin(), mirrored.end(), order) != mirrored.end();
  return mirror ? all ^ outside : outside;
}

FilterBank<Ball> symlet_bank(const std::string& name, int order) {
  const std::size_t outside = chosen_roots(order);
  Polynomial<Ball> low = averaging_polynomial<Ball>(order);
  const auto factors = halfband_factors(order);
  for (std::size_t g = 0; g < factors.size(); ++g) {
    Polynomial<Ball> factor = factors[g];  // roots of H outside, as in Daubechies' filters
    if ((outside >> g & 1) == 0) std::reverse(factor.begin(), factor.end());
    low = low * factor;
  }
  return orthonormal_bank(name, {0, low}, order);
}

std::optional<FilterDefinition> define_symlet(std::string_view name) {
  auto definition = define_by_order("sym", name, lowest_order, highest_symlet_order, symlet_bank);
  if (definition) definition->exact = halfband_autocorrelations(*number_after("sym", name));
  return definition;
}

}  // namespace

Family symlet_family() {
  Family family{"sym2-sym20 (aliases la8-la20)", {}, {}, define_symlet};
  for (int order = lowest_order; order <= highest_symlet_order; ++order) {
    const std::string name = fmt::format("sym{}", order);
    family.members.push_back(name);
    if (lowest_la_order <= order && order <= highest_la_order) {
      family.aliases.emplace_back(fmt::format("la{}", 2 * order), name);
    }
  }
  return family;
}

}  // namespace wavecurve::certified
