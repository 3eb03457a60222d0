// SPDX-License-Identifier: BSL-1.0
// Common declarations of the Python module. The module _core is internal to the package beside it.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "hilger/text/expression.hpp"

namespace py = pybind11;

namespace bindings {

/// A number or a formula of Python as a formula; nothing for other types.
std::optional<hilger::text::expression> as_expression(py::handle x);
inline py::object not_implemented() { return py::reinterpret_borrow<py::object>(Py_NotImplemented); }
void add_expressions(py::module_& m);
void add_problems(py::module_& m);
void add_motions(py::module_& m);
void add_ensembles(py::module_& m);
void add_identities(py::module_& m);
void add_operators(py::module_& m);

} // namespace bindings
