#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "wavecurve/certified/filter_definition.hpp"
#include "wavecurve/filters/user_filter.hpp"

namespace wavecurve::python {

/// What a filter bank of Python was made of: a name or the path of a file, or a user's own taps. Its
/// definition, of any precision, is made where it is needed, since it may not change threads.
struct FilterSource {
  std::variant<std::string, UserFilter> origin;

  certified::FilterDefinition define() const;
};

/// A filter bank as Python has it.
struct PythonFilter {
  FilterSource source;
  FilterBank<double> bank;

  explicit PythonFilter(FilterSource from);
};

}  // namespace wavecurve::python
