// SPDX-License-Identifier: BSL-1.0
// Operators on T that Python composes, and embeddings made of them.
#include "crossing.hpp"
#include "engine/methods/lambda.hpp"
#include "hilger/function/function.hpp"
#include "hilger/scale/time_scale.hpp"

namespace bindings {

namespace {

namespace text = hilger::text;
using text::operator_formula;

char const* const how_to_say = "how a Lagrangian's variables are read on T is said by h.embedding(position, velocity)";

std::optional<text::stated> number_from(py::handle x, bool one_over = false) {
    auto const e = as_expression(x);
    if (not e) return {};
    if (one_over and text::is_zero(*e)) hilger::error::raise<hilger::error::invalid_parameter>("an operator is divided by 0");
    try {
        return text::stated(one_over ? text::expression::number("1") / *e : *e, text::no_words(), "the factor of an operator");
    } catch (hilger::error::unreadable const&) {
        if (not py::isinstance<text::expression>(x)) throw;
        throw py::type_error("the factor of an operator is a number, and here is the formula " + std::string(py::str(x)) + "; " +
                             how_to_say);
    }
}
/// An operator, or a number as a multiple of the identity.
std::optional<operator_formula> operator_from(py::handle x) {
    if (py::isinstance<operator_formula>(x)) return x.cast<operator_formula>();
    auto const c = number_from(x);
    return c ? std::optional(operator_formula::multiple(*c, {})) : std::nullopt;
}
py::object added(operator_formula const& a, py::handle x, bool minus, bool reflected) {
    auto b = operator_from(x);
    if (not b) return not_implemented();
    if (minus) return py::cast(reflected ? *b - a : a - *b);
    return py::cast(reflected ? *b + a : a + *b);
}
py::object multiplied(operator_formula const& a, py::handle x, bool over) {
    if (auto const c = number_from(x, over)) return py::cast(operator_formula::multiple(*c, a));
    if (over or not py::isinstance<operator_formula>(x)) return not_implemented();
    return py::cast(a * x.cast<operator_formula>());
}

/// Prints at most 10 000 characters: a power of a sum grows by its terms each time.
std::string printed(operator_formula const& a, hilger::print_style style) {
    if (text::written(a, "q", 10'000)) return text::written(a, style);
    auto const lost = a.lost();
    std::string const words = "an operator of more than 10 000 characters, which loses " + std::to_string(lost.front) +
                              " points at the beginning and " + std::to_string(lost.back) + " at the end";
    return style == hilger::print_style::latex ? "\\text{" + words + "}" : words;
}
/// The number of the first point of T at which A[f] lives, and its values from there on.
template <class S>
py::tuple applied(operator_formula const& a, typename crossing<S>::given const& points, typename crossing<S>::given const& values) {
    auto const t = crossing<S>::vector_of(points), f = crossing<S>::vector_of(values);
    hilger::time_scale<S> const T(std::vector<S>(t.data(), t.data() + t.size()));
    if (f.size() != t.size())
        hilger::error::raise<hilger::error::mismatch>("a function on T has a value at each of its ", t.size(), " points, and here are ",
                                                      f.size());
    auto const x = hilger::function_on(T, std::vector<S>(f.data(), f.data() + f.size()));
    auto const lost = a.lost();
    text::operator_in_numbers<S> const op(a);
    std::vector<S> made;
    for (hilger::index_type i = lost.front; i < t.size() - lost.back; ++i) made.push_back(op.value(x, i));
    return py::make_tuple(lost.front, crossing<S>::array(std::move(made), 0));
}

} // namespace

void add_operators(py::module_& m) {
    py::class_<operator_formula>(
        m, "Operator",
        "A linear operator on functions on T: sums, multiples and compositions of identity, sigma, rho, Delta_plus "
        "and Delta_minus. A * B and A[B] are A after B; A == B compares what they do on every scale, and the points that "
        "they lose at its ends.")
        .def("__add__", [](operator_formula const& a, py::handle x) { return added(a, x, false, false); })
        .def("__radd__", [](operator_formula const& a, py::handle x) { return added(a, x, false, true); })
        .def("__sub__", [](operator_formula const& a, py::handle x) { return added(a, x, true, false); })
        .def("__rsub__", [](operator_formula const& a, py::handle x) { return added(a, x, true, true); })
        .def("__mul__", [](operator_formula const& a, py::handle x) { return multiplied(a, x, false); })
        .def("__rmul__", [](operator_formula const& a, py::handle x) { return multiplied(a, x, false); })
        .def("__truediv__", [](operator_formula const& a, py::handle x) { return multiplied(a, x, true); })
        .def("__pow__",
             [](operator_formula const& a, py::object const& times) {
                 auto const n_or_less = PyIndex_Check(times.ptr()) != 0 ? PyNumber_AsSsize_t(times.ptr(), nullptr) : -1;
                 if (n_or_less < 0)
                     throw py::type_error("an operator is repeated n = 0, 1, 2, ... times by A**n, and here is n = " +
                                          std::string(py::repr(times)));
                 auto n = static_cast<hilger::index_type>(n_or_less);
                 auto power = *operator_from(py::int_(1)), square = a;
                 for (; n > 0; n /= 2, square = n > 0 ? square * square : square)
                     if (n % 2 == 1) power = power * square;
                 return power;
             })
        .def("__neg__", [](operator_formula const& a) { return -a; })
        .def("__pos__", [](operator_formula const& a) { return a; })
        .def("__getitem__",
             [](operator_formula const& a, py::handle x) {
                 if (py::isinstance<operator_formula>(x)) return a * x.cast<operator_formula>();
                 throw py::type_error(
                     "an operator acts on another one, as sigma[Delta_plus], and on a function of t by h.apply(sigma, f, T); "
                     "how a Lagrangian's variables are read on T is said by h.embedding(position, velocity)");
             })
        .def_property_readonly_static("__array_ufunc__", [](py::object const&) { return py::none(); }) // not an array of operators
        .def("__eq__",
             [](operator_formula const& a, py::handle x) {
                 if (not py::isinstance<operator_formula>(x)) return not_implemented();
                 return py::object(py::bool_(a == x.cast<operator_formula>()));
             })
        .def(
            "equals",
            [](operator_formula const& a, py::handle x, bool uniform) {
                auto const b = operator_from(x);
                if (not b) throw py::type_error("an operator, as h.sigma, was expected, and here is " + std::string(py::repr(x)));
                return text::equal(a, *b, uniform);
            },
            py::arg("other"), py::arg("uniform") = false, "What == asks; with uniform=True on scales of equal steps alone.")
        .def(
            "adjoint", [](operator_formula const& a) { return a.adjoint(); },
            "The operator B with <A f, g> = <f, B g> for all f that vanish at the ends of T: adjoint(sigma) = rho between the nabla and "
            "the Delta sum, adjoint(Delta_plus) = -Delta_minus. Of a sum it is taken between the sums of its first term.")
        .def_property_readonly(
            "text", [](operator_formula const& a) { return text::text_of(a); }, "As it is written in files, of q.")
        .def("__repr__", [](operator_formula const& a) { return printed(a, hilger::print_style::terminal); })
        .def("_repr_latex_", [](operator_formula const& a) { return "$" + printed(a, hilger::print_style::latex) + "$"; })
        .def("_on_points", &applied<double>)
        .def("_on_points_exactly", &applied<hilger::Q>)
        .def("_on_points_in_50_digits", &applied<hilger::float50>)
        .def(py::pickle([](operator_formula const& a) { return text::text_of(a); },
                        [](std::string const& kept) { return text::operator_in(kept); }));
    m.def("read_operator", [](std::string const& of) { return text::operator_in(of); });
    m.def("require_method", [](engine::problem const& what, std::string const& method, bool in_double) {
        if (not engine::is_embedding_in_text(method)) return;
        if (in_double) // its factors may be rounded
            (void)engine::lambda_of<double>(what, method, 1.0);
        else
            (void)engine::lambda_of<hilger::float50>(what, method, hilger::float50(1));
    });
}

} // namespace bindings
