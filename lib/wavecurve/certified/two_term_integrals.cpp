#include "wavecurve/certified/two_term_integrals.hpp"

#include <stdexcept>

#include "wavecurve/certified/detail/is_accurate.hpp"
#include "wavecurve/certified/refinable.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

/// sum_i a_i b_{i-k} for every k.
Filter<Ball> correlation(const Filter<Ball>& a, const Filter<Ball>& b) {
  const int first = a.first_index - b.last_index(), last = a.last_index() - b.first_index;
  Filter<Ball> c{first, {}};
  for (int k = first; k <= last; ++k) {
    Ball sum(0);
    for (int i = a.first_index; i <= a.last_index(); ++i) sum += a[i] * b[i - k];
    c.taps.push_back(sum);
  }
  return c;
}

Filter<Ball> scaled(Filter<Ball> values, const Rational& factor) {
  for (Ball& value : values.taps) value *= Ball(factor);
  return values;
}

BasisFunction scaling_function_of(BasisFunction f) {
  f.wavelet = false;
  return f;
}

/// J_l of the two scaling functions.
Filter<Ball> scaling_integrals(const FilterBank<Ball>& bank, const BasisFunction& f,
                               const BasisFunction& g) {
  const Filter<Ball> c = correlation(two_scale_coefficients(bank, scaling_function_of(f)),
                                     two_scale_coefficients(bank, scaling_function_of(g)));
  return scaled(derivative_at_integers(scaled(c, Rational(1, 2)), f.derivative + g.derivative),
                Rational(g.derivative % 2 == 0 ? 1 : -1));
}

/// One step of the two-scale relation, from J to I.
Filter<Ball> step_to_wavelets(const Filter<Ball>& j, const Filter<Ball>& c, int order) {
  Filter<Ball> result{(j.first_index + c.first_index + 1) >> 1, {}};
  const int last = (j.last_index() + c.last_index()) >> 1;
  for (int l = result.first_index; l <= last; ++l) {
    Ball sum(0);
    for (int k = c.first_index; k <= c.last_index(); ++k) sum += c[k] * j[2 * l - k];
    result.taps.push_back(sum);
  }
  return scaled(result, Rational::power_of_two(order - 1));
}

Filter<Ball> integrals(const FilterBank<Ball>& bank, const BasisFunction& f,
                       const BasisFunction& g) {
  const Filter<Ball> j = scaling_integrals(bank, f, g);
  if (!f.wavelet && !g.wavelet) return j;
  return step_to_wavelets(
      j, correlation(two_scale_coefficients(bank, f), two_scale_coefficients(bank, g)),
      f.derivative + g.derivative);
}

}  // namespace

void require_integrable_product(const FilterDefinition& definition, const BasisFunction& f,
                                const BasisFunction& g) {
  for (const BasisFunction& function : {f, g}) {
    check_between("derivative order", function.derivative, 0, highest_derivative);
  }
  if (f.dual == g.dual) {
    require_smoothness(f.dual ? dual(definition) : definition, f.derivative, g.derivative);
    return;
  }
  const Ball sum = sobolev_exponent(definition, f) + sobolev_exponent(definition, g);
  if (certainly_less(Ball(0), sum)) return;
  const int needed = f.derivative + g.derivative;
  constexpr int shown = 4;
  throw std::domain_error(
      "filter " + definition.name + " is not smooth enough for the integral of " + name_of(f) +
      " " + name_of(g) + ": the Sobolev exponents of its two scaling functions add up to " +
      round_to_digits(sum + Ball(needed), shown)
          .value_or("a number that is not known well enough") +
      ", but must exceed " + std::to_string(needed));
}

Filter<Ball> two_term_integrals(const FilterDefinition& definition, const BasisFunction& f,
                                const BasisFunction& g, long bits) {
  require_integrable_product(definition, f, g);
  return accurate_values(definition, bits,
                         [&](const FilterBank<Ball>& bank) { return integrals(bank, f, g); });
}

}  // namespace wavecurve::certified
