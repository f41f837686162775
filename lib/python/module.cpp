// wavecurve._native: the library as Python's package wavecurve calls it. Here arguments and results are
// converted; what is computed, and every message, is the library's.
#include <pybind11/pybind11.h>
#include <pybind11/stl/filesystem.h>
#include <regex>
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

/// Where a filter is not smooth enough, the exponents are attributes as well: found and needed.
void set_arithmetic_error(const std::string& message) {
  static const std::regex exponents(
      "Sobolev exponent is ([-0-9.]+), but it must exceed ([-0-9.]+)");
  const py::object error = py::handle(PyExc_ArithmeticError)(message);
  std::smatch numbers;
  if (std::regex_search(message, numbers, exponents)) {
    error.attr("found") = py::float_(py::str(numbers[1].str()));
    error.attr("needed") = py::float_(py::str(numbers[2].str()));
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
