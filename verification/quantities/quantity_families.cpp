#include "verification/quantities/quantity_families.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <map>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "wavecurve/certified/autocorrelation.hpp"
#include "wavecurve/certified/connection_coefficients.hpp"
#include "wavecurve/certified/integrals/exact_integrals.hpp"
#include "wavecurve/certified/integrals/product_integrals.hpp"
#include "wavecurve/certified/lifting.hpp"
#include "wavecurve/certified/moments.hpp"
#include "wavecurve/certified/point_values.hpp"
#include "wavecurve/certified/sobolev_exponent.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"

namespace wavecurve::verification {

namespace {

using certified::Ball;
using certified::BasisFunction;
using certified::FilterDefinition;
using certified::Rational;
using certified::WorkingPrecision;

/// Sums of a filter's products lose a few bits; enclosures stay right whatever this is.
constexpr long extra_bits = 32;

/// A sequence that is all there: values from `first` on, in steps of 2^-level.
Sequence stored(Filter<Ball> values, int first, int last, int level = 0) {
  const auto shared = std::make_shared<const Filter<Ball>>(std::move(values));
  return {[shared, level](const EntryIndex& index) {
            return (*shared)[static_cast<int>(std::ldexp(index.first, level))];
          },
          {},
          first,
          last};
}

void add_exact_values(Sequence& sequence, Filter<Rational> exact) {
  const auto shared = std::make_shared<const Filter<Rational>>(std::move(exact));
  sequence.exact = [shared](const EntryIndex& index) {
    return std::optional((*shared)[index.integer()]);
  };
}

// --- filters ---

Sequence tap_sequence(const FilterDefinition& definition, const Quantity& bare, const EntryIndex&,
                      long bits) {
  const WorkingPrecision precision(bits + extra_bits);
  const FilterBank<Ball> bank = definition.bank(bits);
  const auto [wavelet, dual, derivative] = bare.factors.front().function;
  const Filter<Ball>& taps = wavelet ? (dual ? bank.analysis_high : bank.synthesis_high)
                                     : (dual ? bank.analysis_low : bank.synthesis_low);
  return stored(taps, taps.first_index, taps.last_index());
}

Sequence autocorrelation_sequence(const FilterDefinition& definition, const Quantity&,
                                  const EntryIndex&, long bits) {
  const WorkingPrecision precision(bits + extra_bits);
  Filter<Ball> alpha = certified::autocorrelation(definition, bits);
  const int last = alpha.last_index();
  Filter<Ball> both{-last, {}};
  for (int n = -last; n <= last; ++n) both.taps.push_back(alpha[std::abs(n)]);
  Sequence result = stored(std::move(both), -last, last);
  if (definition.exact) {
    result.exact = [alpha = definition.exact->synthesis](const EntryIndex& index) {
      return std::optional(alpha[std::abs(index.integer())]);
    };
  }
  return result;
}

// --- integrals ---

/// int f(x) g(x - l) dx of two functions of one side and kind: mu or nu of some orders, which have
/// exact fractions for some families.
std::optional<Sequence> symmetric_integrals(const FilterDefinition& definition,
                                            const BasisFunction& f, const BasisFunction& g,
                                            long bits) {
  if (f.wavelet != g.wavelet || f.dual != g.dual) return std::nullopt;
  const FilterDefinition side = f.dual ? certified::dual(definition) : definition;
  const int p = g.derivative, q = f.derivative;
  const auto known = certified::connection_coefficients(side, p, q, bits);
  const int taps = f.dual ? definition.bank(bits).analysis_low.size()
                          : definition.bank(bits).synthesis_low.size();
  const Filter<Ball>& values = f.wavelet ? known.nu : known.mu;
  const int last = std::max(taps, values.last_index() + 1);
  Sequence result = stored(values, -last, last);
  if (const auto exact = certified::exact_connection_coefficients(side, p, q)) {
    add_exact_values(result, f.wavelet ? exact->nu : exact->mu);
  }
  return result;
}

/// The functions in the order of their shifts.
ProductIntegral product_of(const Quantity& bare) {
  std::vector<Factor> factors = bare.factors;
  std::ranges::stable_sort(factors, {}, &Factor::shift);
  ProductIntegral integral{.factors = {}, .interval = bare.interval};
  for (const Factor& factor : factors) {
    integral.factors.push_back({factor.function, factor.shift > 0});
  }
  return integral;
}

/// Where a table may list entries, with a zero at either end.
template <class Scalar>
std::pair<int, int> index_range(const ShiftTensor<Scalar>& values) {
  int first = 0, last = 0;
  for (std::size_t i = 0; i < values.dimensions(); ++i) {
    first = i == 0 ? values.first[i] : std::min(first, values.first[i]);
    last = i == 0 ? values.last(i) : std::max(last, values.last(i));
  }
  return {first - 1, last + 1};
}

/// All shifts of a product over the line or an interval, and as fractions where they are known.
Sequence tensor_sequence(const FilterDefinition& definition, const ProductIntegral& integral,
                         long bits) {
  const auto values = std::make_shared<const ShiftTensor<Ball>>(
      certified::product_integrals(definition, integral, bits));
  const auto [first, last] = index_range(*values);
  Sequence result{
      [values](const EntryIndex& index) { return values->at(index.integers()); }, {}, first, last};
  if (auto exact = certified::exact_product_integrals(definition, integral)) {
    const auto shared = std::make_shared<const ShiftTensor<Rational>>(*std::move(exact));
    result.exact = [shared](const EntryIndex& index) {
      return std::optional(shared->at(index.integers()));
    };
  }
  return result;
}

/// The integrals from 0 to x, minus those from x to 0 for x < 0; each x is computed when it is asked
/// for. Beyond the supports of the factors they are constant in x.
Sequence up_to_x_sequence(const FilterDefinition& definition, const ProductIntegral& integral,
                          long bits) {
  const FilterBank<Ball> bank = definition.bank(bits);
  double first = 0, last = 0;  // of the supports that are not shifted, as of 0
  for (const IntegralFactor& factor : integral.factors) {
    if (factor.shifted) continue;
    const certified::Support on = certified::support(bank, factor.function);
    first = std::min(first, on.first);
    last = std::max(last, on.last);
  }
  ProductIntegral whole = integral;
  whole.interval =
      DyadicInterval{static_cast<int>(std::floor(first)), static_cast<int>(std::ceil(last))};
  const auto [lowest, highest] = index_range(certified::product_integrals(definition, whole, bits));
  const auto known = std::make_shared<std::map<double, ShiftTensor<Ball>>>();
  const auto enclosure = [=](const EntryIndex& index) {
    const double x = index.first;
    if (x == 0) return Ball(0);
    if (!known->contains(x)) {
      const int level = index.dyadic_level();
      const int end = static_cast<int>(std::ldexp(x, level));
      ProductIntegral up_to_x = integral;
      up_to_x.interval = DyadicInterval{std::min(end, 0), std::max(end, 0), level};
      known->emplace(x, certified::product_integrals(definition, up_to_x, bits));
    }
    const int shifts[] = {index.second, index.third};
    const Ball value =
        known->at(x).at(std::span(shifts, static_cast<std::size_t>(index.count - 1)));
    return x < 0 ? -value : value;
  };
  return {enclosure,
          {},
          std::min(lowest, static_cast<int>(std::floor(first))),
          std::max(highest, static_cast<int>(std::ceil(last)))};
}

Sequence integral_sequence(const FilterDefinition& definition, const Quantity& bare,
                           const EntryIndex&, long bits) {
  const ProductIntegral integral = product_of(bare);
  if (bare.up_to_x) return up_to_x_sequence(definition, integral, bits);
  if (integral.factors.size() == 2 && !integral.interval) {
    const BasisFunction &f = integral.factors[0].function, &g = integral.factors[1].function;
    if (auto known = symmetric_integrals(definition, f, g, bits)) return *known;
  }
  return tensor_sequence(definition, integral, bits);
}

// --- functions ---

Sequence value_sequence(const FilterDefinition& definition, const Quantity& bare,
                        const EntryIndex& sample, long bits) {
  const int level = sample.dyadic_level();
  Filter<Ball> values =
      certified::dyadic_values(definition, bare.factors.front().function, level, bits);
  const int first = values.first_index >> level, last = (values.last_index() >> level) + 1;
  return stored(std::move(values), first - 1, last + 1, level);
}

Sequence moment_sequence(const FilterDefinition& definition, const Quantity& bare,
                         const EntryIndex& sample, long bits) {
  const int highest = std::max(std::abs(sample.integer()), 1);
  check_between("moment", highest, 0, certified::highest_moment);
  constexpr long bits_a_moment = 8;  // the sums over n^p cancel by a few bits a power
  return stored({0, certified::moments(definition, bare.factors.front().function, highest,
                                       bits + extra_bits + bits_a_moment * highest)},
                0, highest);
}

Sequence one_number(const Ball& value) { return stored({0, {value}}, 0, 0); }

Sequence sobolev_sequence(const FilterDefinition& definition, const Quantity& bare,
                          const EntryIndex&, long) {
  return one_number(certified::sobolev_exponent(definition, bare.factors.front().function));
}

/// Closed forms only: a spline of order D is D - 1 times Lipschitz differentiable, and phi of D4 has
/// the exponent 2 - log_2(1 + sqrt 3) (Daubechies and Lagarias 1992).
Sequence hoelder_sequence(const FilterDefinition& definition, const Quantity& bare,
                          const EntryIndex&, long bits) {
  const WorkingPrecision precision(bits + extra_bits);
  const auto [wavelet, dual, derivative] = bare.factors.front().function;
  const std::string& name = definition.name;
  if (!dual && derivative == 0) {
    if (name == "db2") {
      return one_number(Ball(2) - log(Ball(1) + sqrt(Ball(3))) / log(Ball(2)));
    }
    if (name.starts_with("bspline")) {
      return one_number(Ball(definition.bank(bits).synthesis_low.size() - 2));
    }
  }
  throw std::domain_error("no certified Hoelder exponent is known for " +
                          certified::name_of(bare.factors.front().function) + " of filter " + name +
                          "; for phi and psi of db2 and of the splines it is");
}

Sequence lifting_sequence(const FilterDefinition& definition, const Quantity&, const EntryIndex&,
                          long bits) {
  auto [steps, factor] = certified::lifting_steps(definition, bits + extra_bits);
  steps.push_back(factor);
  const int last = static_cast<int>(steps.size()) - 1;
  return stored({0, std::move(steps)}, 0, last);
}

constexpr QuantityFamily families[] = {
    {"h", "taps of phi's filter, sum sqrt 2; index n. dual(h), g, dual(g): phi~, psi, psi~",
     "h*sqrt2", 1, 1, tap_sequence},
    {"alpha", "autocorrelation 2 sum h_i h_{i+n} of the taps; index n", "alpha", 0, 0,
     autocorrelation_sequence},
    {"int",
     "integrals of two to four factors over the line, or on [a,b], on [0,x]; indices [x,] l, m, n",
     "int(phi'', phi)", 2, most_factors, integral_sequence},
    {"value", "phi, psi, dual(phi), dual(psi), or a derivative, at integers and dyadic points x",
     "phi'", 1, 1, value_sequence},
    {"moment", "int x^p f(x) dx; index p", "moment(psi)", 1, 1, moment_sequence},
    {"sobolev", "Sobolev exponent; index 0", "sobolev(phi)", 1, 1, sobolev_sequence},
    {"holder", "Hoelder exponent where a closed form is known; index 0", "holder(phi)", 1, 1,
     hoelder_sequence},
    {"lifting", "lifting steps in the order of a transform, then the factor; index k", "lifting", 0,
     0, lifting_sequence},
};

}  // namespace

std::span<const QuantityFamily> quantity_families() { return families; }

const QuantityFamily& quantity_family(std::string_view name) {
  const auto* const known = std::ranges::find(families, name, &QuantityFamily::name);
  if (known != std::end(families)) return *known;
  throw std::invalid_argument(unknown_name("quantity", name, families, &QuantityFamily::name));
}

}  // namespace wavecurve::verification
