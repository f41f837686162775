// Certified connection coefficients of every kind, moments, quadrature.
#include <optional>
#include <pybind11/stl.h>
#include <string>
#include <utility>
#include <vector>

#include "wavecurve/certified/certified_decimals.hpp"
#include "wavecurve/certified/detail/rounded_values.hpp"
#include "wavecurve/certified/integrals/homogeneous_operator.hpp"
#include "wavecurve/certified/integrals/integral_decimals.hpp"
#include "wavecurve/certified/integrals/quadrature.hpp"
#include "wavecurve/certified/moments.hpp"
#include "wavecurve/certified/rational.hpp"

#include "python/filter_source.hpp"
#include "python/interruptible.hpp"
#include "python/numbers.hpp"
#include "python/topics.hpp"
#include "verification/quantities/filter_values.hpp"
#include "verification/quantities/integral_expression.hpp"
#include "verification/quantities/list_quantity.hpp"

namespace wavecurve::python {

namespace {

using certified::DecimalEnclosure;
using certified::FilterDefinition;
using certified::IntegralDecimal;
using certified::Rational;

py::dict coefficients(const PythonFilter& filter, int p, int q, int digits, bool divide_by_first) {
  const auto found = interruptible([source = filter.source, p, q, digits, divide_by_first] {
    return certified::certified_decimals(
        source.define(), {.p = p, .q = q, .digits = digits, .divide_by_first = divide_by_first});
  });
  py::dict result;
  result["alpha"] = to_python(found.alpha);
  result["mu"] = to_python(found.mu);
  result["nu"] = to_python(found.nu);
  return result;
}

py::list integral_list(const std::vector<IntegralDecimal>& entries) {
  py::list result;
  for (const auto& [indices, number] : entries) {
    result.append(py::make_tuple(py::tuple(py::cast(indices)), to_python(number)));
  }
  return result;
}

py::tuple integrals(const PythonFilter& filter, const std::string& text,
                    const std::optional<std::string>& on, std::optional<int> period, int digits) {
  std::optional<DyadicInterval> interval;
  if (on) interval = verification::parse_interval(*on);
  ProductIntegral integral = verification::parse_integral(text, interval);
  integral.period = period;
  const auto entries = interruptible([source = filter.source, integral, digits] {
    return certified::integral_decimals(source.define(), integral, digits);
  });
  return py::make_tuple("int(" + verification::to_string(integral) + ")", integral_list(entries));
}

py::list derivative_operator(const PythonFilter& filter, int order, int digits) {
  return integral_list(interruptible([source = filter.source, order, digits] {
    return certified::integral_decimals(source.define(), {{{{.derivative = order}, false}, {{}}}},
                                        digits);
  }));
}

/// Rational texts "p/q" or decimals.
Rational rational(const std::string& text) {
  const auto slash = text.find('/');
  if (slash == std::string::npos) return Rational::from_decimal(text);
  return Rational::from_decimal(text.substr(0, slash)) /
         Rational::from_decimal(text.substr(slash + 1));
}

py::list homogeneous_operator(const PythonFilter& filter, const std::string& kind,
                              const std::string& order, int up_to, int digits) {
  using Kind = certified::HomogeneousOperator::Kind;
  return to_python(interruptible([=, source = filter.source] {
    const FilterDefinition definition = source.define();
    const certified::HomogeneousOperator op{kind == "hilbert" ? Kind::hilbert
                                            : kind == "riesz" ? Kind::riesz
                                                              : Kind::fractional,
                                            rational(order)};
    return certified::rounded_values(
        [&](long bits) {
          return certified::operator_coefficients(definition, op, up_to, bits).taps;
        },
        digits, definition.known_bits);
  }));
}

py::list moments(const PythonFilter& filter, bool wavelet, bool dual, int highest, int digits) {
  constexpr long bits_a_moment = 8;  // the sums over n^p cancel by a few bits a power
  return to_python(interruptible([=, source = filter.source] {
    const FilterDefinition definition = source.define();
    return certified::rounded_values(
        [&](long bits) {
          return certified::moments(definition, {wavelet, dual, 0}, highest,
                                    bits + bits_a_moment * highest);
        },
        digits, definition.known_bits);
  }));
}

py::list reproduction(const PythonFilter& filter, int digits) {
  return to_python(interruptible([source = filter.source, digits] {
    const FilterDefinition definition = source.define();
    return certified::rounded_values(
        [&](long bits) { return certified::reproduction_coefficients(definition, bits); }, digits,
        definition.known_bits);
  }));
}

py::list quadrature_weights(const PythonFilter& filter, const std::string& first,
                            const std::string& step, int count, int digits) {
  return to_python(interruptible([=, source = filter.source] {
    const FilterDefinition definition = source.define();
    return certified::rounded_values(
        [&](long bits) {
          return certified::equidistant_rule(definition, rational(first), rational(step), count,
                                             bits)
              .weights;
        },
        digits, definition.known_bits);
  }));
}

py::object index_to_python(const verification::EntryIndex& index) {
  const bool is_whole = index.dyadic_level() == 0;
  py::object first = is_whole ? py::object(py::int_(static_cast<int>(index.first)))
                              : py::object(py::str(index.first_text()));
  if (index.count == 1) return first;
  if (index.count == 2) return py::make_tuple(first, index.second);
  return py::make_tuple(first, index.second, index.third);
}

py::tuple quantity(const PythonFilter& filter, const std::string& text, int digits, int level,
                   int highest_moment) {
  const verification::Quantity parsed = verification::parse_quantity(text);
  const auto entries = interruptible([=, source = filter.source] {
    verification::FilterValues values(source.define());
    return verification::list_quantity(values, parsed, {digits, level, highest_moment});
  });
  py::list result;
  for (const auto& [index, number] : entries) {
    result.append(py::make_tuple(index_to_python(index), to_python(number)));
  }
  return py::make_tuple(verification::to_string(parsed), result);
}

}  // namespace

void add_coefficients(py::module_& module) {
  module.def("coefficients", &coefficients, py::arg("filter"), py::arg("p"), py::arg("q"),
             py::arg("digits"), py::arg("divide_by_first"));
  module.def("integrals", &integrals, py::arg("filter"), py::arg("text"), py::arg("on"),
             py::arg("period"), py::arg("digits"));
  module.def("derivative_operator", &derivative_operator, py::arg("filter"), py::arg("order"),
             py::arg("digits"));
  module.def("homogeneous_operator", &homogeneous_operator, py::arg("filter"), py::arg("kind"),
             py::arg("order"), py::arg("up_to"), py::arg("digits"));
  module.def("moments", &moments, py::arg("filter"), py::arg("wavelet"), py::arg("dual"),
             py::arg("highest"), py::arg("digits"));
  module.def("reproduction", &reproduction, py::arg("filter"), py::arg("digits"));
  module.def("quadrature_weights", &quadrature_weights, py::arg("filter"), py::arg("first"),
             py::arg("step"), py::arg("count"), py::arg("digits"));
  module.def("quantity", &quantity, py::arg("filter"), py::arg("text"), py::arg("digits"),
             py::arg("level"), py::arg("highest_moment"));
}

}  // namespace wavecurve::python
