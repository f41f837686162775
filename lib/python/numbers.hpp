#pragma once

#include <pybind11/pybind11.h>
#include <vector>

#include "wavecurve/certified/decimal_enclosure.hpp"

namespace wavecurve::python {

namespace py = pybind11;

/// (value, radius, exact): texts, of which the Python side makes Decimal and Fraction; exact is None
/// where the number is not known to be rational.
inline py::tuple to_python(const certified::DecimalEnclosure& number) {
  return py::make_tuple(number.value, number.radius, number.exact);
}

inline py::list to_python(const std::vector<certified::DecimalEnclosure>& numbers) {
  py::list result;
  for (const auto& number : numbers) result.append(to_python(number));
  return result;
}

}  // namespace wavecurve::python
