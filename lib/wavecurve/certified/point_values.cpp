#include "wavecurve/certified/point_values.hpp"

#include <stdexcept>

#include "wavecurve/certified/detail/is_accurate.hpp"
#include "wavecurve/certified/refinable.hpp"
#include "wavecurve/certified/rounding.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::certified {

namespace {

void require_continuity(const FilterDefinition& definition, const BasisFunction& f) {
  check_between("derivative order", f.derivative, 0, highest_derivative);
  const Ball found = sobolev_exponent(definition, f);
  if (certainly_less(Ball(Rational(1, 2)), found)) return;
  constexpr int shown = 4;
  throw std::domain_error(name_of(f) + " of filter " + definition.name +
                          " is not known to be continuous: its Sobolev " + "exponent is " +
                          round_to_digits(found, shown).value_or("not known well enough") +
                          ", but must exceed 0.5");
}

/// The values of 2^d sum_k a_k s(2x - k) at the points of step 2^-level, from those of s at the
/// points of step 2^-(level-1).
Filter<Ball> refined(const Filter<Ball>& s, const Filter<Ball>& a, int level, int d) {
  const int step = 1 << (level - 1);  // k in units of 2^-(level-1)
  Filter<Ball> result{s.first_index + step * a.first_index, {}};
  const int last = s.last_index() + step * a.last_index();
  for (int point = result.first_index; point <= last; ++point) {
    Ball sum(0);
    for (int k = a.first_index; k <= a.last_index(); ++k) sum += a[k] * s[point - step * k];
    result.taps.push_back(sum * Ball(Rational::power_of_two(d)));
  }
  return result;
}

Filter<Ball> values(const FilterBank<Ball>& bank, const BasisFunction& f, int level) {
  const BasisFunction scaling{false, f.dual, f.derivative};
  const Filter<Ball> mask = two_scale_coefficients(bank, scaling);
  Filter<Ball> s = derivative_at_integers(mask, f.derivative);
  for (int reached = 1; reached < level; ++reached) s = refined(s, mask, reached, f.derivative);
  if (level > 0) return refined(s, two_scale_coefficients(bank, f), level, f.derivative);
  if (!f.wavelet) return s;
  const Filter<Ball> halves = refined(s, two_scale_coefficients(bank, f), 1, f.derivative);
  Filter<Ball> result{(halves.first_index + 1) >> 1, {}};
  for (int k = result.first_index; 2 * k <= halves.last_index(); ++k) {
    result.taps.push_back(halves[2 * k]);
  }
  return result;
}

}  // namespace

Filter<Ball> dyadic_values(const FilterDefinition& definition, const BasisFunction& f, int level,
                           long bits) {
  check_between("dyadic level", level, 0, highest_dyadic_level);
  require_continuity(definition, f);
  return accurate_values(definition, bits,
                         [&](const FilterBank<Ball>& bank) { return values(bank, f, level); });
}

}  // namespace wavecurve::certified
