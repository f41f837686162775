// wavecurve._native: the library as Python's package wavecurve calls it. Here arguments and results are
// converted; what is computed, and every message, is the library's.
#include <charconv>
#include <optional>
#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>
#include <stdexcept>
#include <string>
#include <system_error>

#include "python/topics.hpp"
#include "verification/suite/data_folder.hpp"

namespace wavecurve::python {

namespace {

namespace py = pybind11;

void set_os_error(const std::system_error& error) {
  const py::object args = py::make_tuple(error.code().value(), error.what());
  PyErr_SetObject(PyExc_OSError, args.ptr());
}

/// The number behind the last place of some words, if there is one: before them may stand a filter's name, which holds anything.
std::optional<double> number_behind(const std::string& message, const std::string& words) {
  const std::size_t place = message.rfind(words);
  if (place == std::string::npos) return std::nullopt;
  double number = 0;
  const char* const start = message.data() + place + words.size();
  const auto [end, error] = std::from_chars(start, message.data() + message.size(), number);
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

/// Where a filter is not smooth enough, the exponents are attributes as well: found and needed.
void set_arithmetic_error(const std::string& message) {
  const py::object error = py::handle(PyExc_ArithmeticError)(message);
  const auto found = number_behind(message, "Sobolev exponent is ");
  const auto needed = number_behind(message, "but it must exceed ");
  if (found && needed) {
    error.attr("found") = *found;
    error.attr("needed") = *needed;
  }
  PyErr_SetObject(PyExc_ArithmeticError, error.ptr());
}

/// Bad arguments are ValueError, numbers that do not exist ArithmeticError, files and the machine OSError.
void translate(std::exception_ptr pointer) {
  try {
    if (pointer) std::rethrow_exception(pointer);
  } catch (const std::domain_error& error) {
    set_arithmetic_error(error.what());
  } catch (const std::system_error& error) {
    set_os_error(error);
  }
}

}  // namespace

PYBIND11_MODULE(_native, module) {
  module.doc() = "The compiled part of wavecurve; use the package's own functions.";
  py::register_exception_translator(&translate);
  module.def("use_data_folder", &verification::use_data_folder, py::arg("folder"),
             "Say where the published tables and the examples lie.");
  module.attr("version") = WAVECURVE_VERSION;
  add_filters(module);
  add_coefficients(module);
  add_transform(module);
  add_tables(module);
  add_operators(module);
  add_dynamics(module);
  add_study(module);
  add_curves(module);
  add_morphs(module);
}

}  // namespace wavecurve::python
