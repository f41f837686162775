#pragma once

#include <pybind11/pybind11.h>

namespace wavecurve::python {

// One function for each topic; it adds what it is about to the module.
void add_filters(pybind11::module_& module);
void add_coefficients(pybind11::module_& module);
void add_transform(pybind11::module_& module);
void add_tables(pybind11::module_& module);
void add_operators(pybind11::module_& module);
void add_dynamics(pybind11::module_& module);
void add_study(pybind11::module_& module);
void add_curves(pybind11::module_& module);
void add_morphs(pybind11::module_& module);

}  // namespace wavecurve::python
