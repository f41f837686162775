#include "tools/commands/coefficients/operator_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "wavecurve/certified/detail/rounded_values.hpp"
#include "wavecurve/certified/integrals/homogeneous_operator.hpp"
#include "wavecurve/certified/integrals/integral_decimals.hpp"
#include "wavecurve/certified/integrals/quadrature.hpp"
#include "wavecurve/certified/moments.hpp"
#include "wavecurve/filters/detail/bad_value.hpp"
#include "wavecurve/io/load_filter.hpp"

#include "tools/commands/input/number_option.hpp"
#include "tools/commands/output/number_list.hpp"

namespace wavecurve::tools {

namespace {

using certified::Ball;
using certified::BasisFunction;
using certified::FilterDefinition;
using certified::HomogeneousOperator;
using certified::Rational;

/// A homogeneous operator, or the order of a derivative.
struct NamedOperator {
  HomogeneousOperator homogeneous;
  std::optional<int> derivative;
};

/// A decimal, or p/q.
Rational parse_order(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return Rational::from_decimal(text);
  const auto p = parsed_whole_number(text.substr(0, slash));
  const auto q = parsed_whole_number(text.substr(slash + 1));
  if (!p || !q || *q < 1) throw std::invalid_argument("no fraction");
  return {*p, *q};
}

NamedOperator parse_operator(const std::string& text) {
  using Kind = HomogeneousOperator::Kind;
  constexpr std::string_view fractional = "fractional:", derivative = "derivative:",
                             riesz = "riesz:", hilbert = "hilbert:";
  const std::string_view view = text;
  if (view == "hilbert") return {{Kind::hilbert}, {}};
  try {
    if (view.starts_with(fractional)) {
      const Rational order = parse_order(view.substr(fractional.size()));
      const bool is_whole = fmpz_is_one(fmpq_denref(order.get())) != 0;
      if (!is_whole || order.sign() < 0) return {{Kind::fractional, order}, {}};
      const bool is_small = order <= Rational(highest_derivative + 1);
      return {{}, is_small ? std::atoi(order.to_string().c_str()) : highest_derivative + 1};
    }
    if (view.starts_with(riesz)) return {{Kind::riesz, parse_order(view.substr(riesz.size()))}, {}};
    if (view.starts_with(hilbert)) {
      return {{Kind::hilbert, parse_order(view.substr(hilbert.size()))}, {}};
    }
    if (view.starts_with(derivative)) {
      if (const auto order = parsed_whole_number(view.substr(derivative.size()))) {
        return {{}, static_cast<int>(std::clamp(*order, -1L, highest_derivative + 1L))};
      }
    }
  } catch (const std::invalid_argument&) {  // no number: answered below
  }
  throw std::invalid_argument(must_be(
      "--operator", text,
      "hilbert, hilbert:S, riesz:S, fractional:S such as fractional:0.5, or derivative:K such as "
      "derivative:2"));
}

std::vector<certified::IntegralDecimal> derivative_decimals(const FilterDefinition& definition,
                                                            int derivative,
                                                            const OperatorRange& range,
                                                            int digits) {
  auto all = certified::integral_decimals(
      definition, {.factors = {{{.derivative = derivative}, false}, {{}}}, .period = range.period},
      digits);
  if (!range.period) {
    std::erase_if(all,
                  [&](const auto& entry) { return std::abs(entry.indices[0]) > range.largest; });
  }
  return all;
}

std::vector<certified::IntegralDecimal> operator_decimals(const FilterDefinition& definition,
                                                          const NamedOperator& op,
                                                          const OperatorRange& range, int digits) {
  if (op.derivative) return derivative_decimals(definition, *op.derivative, range, digits);
  const auto decimals = certified::rounded_values(
      [&](long bits) {
        return range.period ? certified::periodic_operator_coefficients(definition, op.homogeneous,
                                                                        *range.period, bits)
                                  .taps
                            : certified::operator_coefficients(definition, op.homogeneous,
                                                               range.largest, bits)
                                  .taps;
      },
      digits, definition.known_bits);
  std::vector<certified::IntegralDecimal> entries;
  int l = range.period ? 0 : -range.largest;
  for (const auto& number : decimals) entries.push_back({{l++}, number});
  return entries;
}

/// Appends numbers of one kind, with the indices first, first + 1, ..
void append(NumberList& list, const std::string& quantity, int first,
            std::vector<certified::DecimalEnclosure> numbers) {
  for (auto& number : numbers) {
    list.entries.push_back(listed({first++}, std::move(number)));
    list.entries.back().quantity = quantity;
  }
}

void append_moments(NumberList& list, const FilterDefinition& definition, int highest, int digits) {
  constexpr long bits_a_moment = 8;  // the sums over n^p cancel by a few bits a power
  const bool is_orthonormal = definition.bank(64).is_orthonormal();
  for (const bool dual : {false, true}) {
    if (dual && is_orthonormal) break;
    for (const bool wavelet : {false, true}) {
      const BasisFunction f{wavelet, dual, 0};
      append(list, "moment(" + name_of(f) + ")", 0,
             certified::rounded_values(
                 [&](long bits) {
                   return moments(definition, f, highest, bits + bits_a_moment * highest);
                 },
                 digits, definition.known_bits));
    }
  }
}

void append_weights(NumberList& list, const FilterDefinition& definition, int highest, int digits) {
  const FilterBank<Ball> bank = definition.bank(64);
  const certified::Support on = support(bank, {});
  const int inside = static_cast<int>(on.last - on.first) + 1;
  const int count = std::min({highest + 1, inside, certified::most_nodes});
  const double middle = moments(definition, {}, 1, 64)[1].to_double();
  const int first = std::clamp(static_cast<int>(std::lround(middle - 0.5 * (count - 1))),
                               static_cast<int>(on.first), static_cast<int>(on.last) - count + 1);
  append(
      list, "weight(phi)", first,
      certified::rounded_values(
          [&](long bits) {
            return equidistant_rule(definition, Rational(first), Rational(1), count, bits).weights;
          },
          digits, definition.known_bits));
}

}  // namespace

std::string operator_output(const std::string& filter, const std::string& text,
                            const OperatorRange& range, int digits, const std::string& format) {
  const NamedOperator op = parse_operator(text);
  const FilterDefinition definition = io::load_filter(filter);
  NumberList list{definition.name, "operator " + text, {{"operator", text}, {"on", nullptr}}, {}};
  if (range.period) {
    list.name += fmt::format(" with period {}", *range.period);
    list.head["period"] = *range.period;
  }
  for (auto& [indices, number] : operator_decimals(definition, op, range, digits)) {
    list.entries.push_back(listed(indices, std::move(number)));
  }
  return number_list_output(list, format);
}

std::string moments_output(const std::string& filter, int highest, int digits,
                           const std::string& format) {
  const FilterDefinition definition = io::load_filter(filter);
  NumberList list{definition.name,
                  fmt::format("moments up to {}", highest),
                  {{"moments", highest}, {"on", nullptr}},
                  {}};
  append_moments(list, definition, highest, digits);
  append(list, "reproduction(phi)", 0,
         certified::rounded_values(
             [&](long bits) { return reproduction_coefficients(definition, bits); }, digits,
             definition.known_bits));
  append_weights(list, definition, highest, digits);
  return number_list_output(list, format);
}

}  // namespace wavecurve::tools
