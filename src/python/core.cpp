// SPDX-License-Identifier: BSL-1.0
#include "bindings.hpp"

#include <exception>
#include <stdexcept>

#include "hilger/error.hpp"
#include "hilger/version.hpp"

namespace {

template <class Error>
void add_error(py::module_& m, char const* name, py::object const& base) {
    py::register_exception<Error>(m, name, base);
}

} // namespace

PYBIND11_MODULE(_core, m) {
    namespace error = hilger::error;
    m.attr("version") =
        std::to_string(HILGER_VERSION_MAJOR) + "." + std::to_string(HILGER_VERSION_MINOR) + "." + std::to_string(HILGER_VERSION_PATCH);
    // The translator registered last is tried first: derived types come after their bases.
    py::object const base = py::register_exception<error::exception>(m, "Error", PyExc_RuntimeError);
    py::object const value = py::reinterpret_steal<py::object>(
        PyErr_NewException("hilger._core.InvalidInput", py::make_tuple(base, py::handle(PyExc_ValueError)).ptr(), nullptr));
    m.attr("InvalidInput") = value;
    add_error<error::invalid_scale>(m, "InvalidScale", value);
    add_error<error::outside_domain>(m, "OutsideDomain", value);
    add_error<error::mismatch>(m, "Mismatch", value);
    add_error<error::invalid_parameter>(m, "InvalidParameter", value);
    add_error<error::not_finite>(m, "NotFinite", base);
    static py::handle const not_finite = m.attr("NotFinite").ptr();
    py::register_exception_translator([](std::exception_ptr thrown) { // rationals have no infinity
        try {
            if (thrown) std::rethrow_exception(thrown);
        } catch (std::overflow_error const&) {
            PyErr_SetString(not_finite.ptr(), "a division by zero, for which there is no rational number");
        }
    });
    add_error<error::unreadable>(m, "Unreadable", value);
    add_error<error::singular>(m, "Singular", base);
    add_error<error::ill_conditioned>(m, "IllConditioned", base);
    add_error<error::no_formula>(m, "NoFormula", base);
    add_error<error::no_convergence>(m, "NoConvergence", base);
    bindings::add_expressions(m);
    bindings::add_problems(m);
    bindings::add_motions(m);
    bindings::add_ensembles(m);
    bindings::add_operators(m);
    bindings::add_identities(m);
}
