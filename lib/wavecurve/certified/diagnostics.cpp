#include "wavecurve/certified/diagnostics.hpp"

#include <cmath>
#include <stdexcept>
#include <vector>

#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"

namespace wavecurve::certified {

namespace {

/// G(w) = g_0 + 2 sum_{l>0} g_l cos(l w).
class GramSymbol {
 public:
  explicit GramSymbol(Filter<Ball> gram) : gram_(std::move(gram)) {}

  /// Encloses G over an interval: the mean value form around its middle.
  Ball over(const Ball& interval) const {
    const Ball middle = interval.midpoint();
    return at(middle) + slope(interval) * (interval - middle);
  }

  int terms() const { return gram_.last_index() + 1; }

  Ball at(const Ball& w) const {
    Ball sum = gram_[0];
    for (int l = 1; l <= gram_.last_index(); ++l) sum += Ball(2) * gram_[l] * cos(Ball(l) * w);
    return sum;
  }

 private:
  Ball slope(const Ball& w) const {
    Ball sum(0);
    for (int l = 1; l <= gram_.last_index(); ++l) sum -= Ball(2 * l) * gram_[l] * sin(Ball(l) * w);
    return sum;
  }

  Filter<Ball> gram_;
};

std::vector<Ball> halves(const Ball& interval) {
  const Ball quarter = interval.radius() / Ball(2);
  std::vector<Ball> parts;
  for (const Ball& middle : {interval.midpoint() - quarter, interval.midpoint() + quarter}) {
    parts.push_back(middle);
    arb_add_error(parts.back().get(), quarter.get());
  }
  return parts;
}

Ball lower_end(const Ball& x) {
  Ball end;
  arb_get_lbound_arf(arb_midref(end.get()), x.get(), WorkingPrecision::bits());
  return end;
}

Ball smaller(const Ball& a, const Ball& b) {
  Ball result;
  arb_min(result.get(), a.get(), b.get(), WorkingPrecision::bits());
  return result;
}

/// The minimum of sign * G over [0, pi]. Parts that cannot hold it are dropped; the rest is halved
/// until the lower bound has met the smallest value seen, or until halving gives no more: G is known
/// at a point only as well as its coefficients are, and where over a whole part it is known nearly
/// as well, halves of the part would not be told apart. The bound of the work is for symbols that
/// are flat over wide parts. The result encloses the minimum wherever this ends.
Ball minimum(const GramSymbol& symbol, int sign) {
  constexpr double relative_width = 1e-10;
  constexpr int most_terms = 100000;
  const Ball half_pi = Ball::pi() / Ball(2);
  Ball whole = half_pi;
  arb_add_error(whole.get(), half_pi.get());
  std::vector<Ball> parts{whole};
  // The ends are likely places; without them a minimum at an end is only approached.
  Ball best = smaller(Ball(sign) * symbol.at(Ball(0)), Ball(sign) * symbol.at(Ball::pi()));
  for (int terms = 0;;) {
    std::vector<Ball> kept;
    Ball lowest = best;
    bool can_improve = false;
    for (const Ball& part : parts) {
      for (const Ball& half : halves(part)) {
        terms += symbol.terms();
        const Ball in_the_middle = Ball(sign) * symbol.at(half.midpoint());
        const Ball over_half = Ball(sign) * symbol.over(half);
        best = smaller(best, in_the_middle);
        const Ball bound = lower_end(over_half);
        if (certainly_less(best, bound)) continue;
        lowest = smaller(lowest, bound);
        kept.push_back(half);
        can_improve |= over_half.radius_double() > 2 * in_the_middle.radius_double();
      }
    }
    parts = std::move(kept);
    const Ball enclosure = hull(lowest, best);
    const bool is_narrow =
        enclosure.radius_double() <= relative_width * std::abs(enclosure.to_double());
    if (is_narrow || !can_improve || terms > most_terms) return enclosure;
  }
}

bool mirror_image(const Filter<Ball>& filter, int sign) {
  for (int i = 0; i < filter.size(); ++i) {
    const Ball& a = filter.taps[static_cast<std::size_t>(i)];
    const Ball& b = filter.taps[static_cast<std::size_t>(filter.size() - 1 - i)];
    if (!a.overlaps(sign > 0 ? b : -b)) return false;
  }
  return true;
}

}  // namespace

std::optional<RieszBounds> riesz_bounds(const FilterDefinition& definition) {
  constexpr long bits = 128;
  const WorkingPrecision precision(bits);
  try {
    if (definition.bank(bits).is_orthonormal()) {
      if (!is_proved_smoother(definition, Rational(0))) return std::nullopt;
      return RieszBounds{Ball(1), Ball(1)};
    }
    const GramSymbol symbol(connection_coefficients(definition, 0, 0, bits).mu);
    RieszBounds bounds{minimum(symbol, 1), -minimum(symbol, -1)};
    if (!bounds.lower.is_positive()) return std::nullopt;
    return bounds;
  } catch (const std::domain_error&) {
    return std::nullopt;
  }
}

Symmetry symmetry(const Filter<Ball>& filter) {
  if (mirror_image(filter, 1)) return Symmetry::symmetric;
  return mirror_image(filter, -1) ? Symmetry::antisymmetric : Symmetry::none;
}

std::pair<double, double> wavelet_support(const FilterBank<Ball>& bank) {
  return {0.5 * (bank.synthesis_low.first_index + bank.synthesis_high.first_index),
          0.5 * (bank.synthesis_low.last_index() + bank.synthesis_high.last_index())};
}

}  // namespace wavecurve::certified
