// SPDX-License-Identifier: BSL-1.0
// Formulas from the operators and functions of Python. Numbers keep all their digits: 0.1 has those of its repr, Fraction(1, 3) is a
// quotient, Decimal and mpf have their own.
#include <optional>
#include <unordered_map>

#include "bindings.hpp"
#include "hilger/error.hpp"
#include "hilger/text/stated.hpp"
#include "hilger/version.hpp"

namespace bindings {

using hilger::text::expression;
using hilger::text::kind;

namespace {

expression of_digits(std::string digits) {
    bool const minus = digits.starts_with('-');
    expression const size = expression::number(minus ? digits.substr(1) : std::move(digits));
    return minus ? -size : size;
}
bool is_a(py::handle x, char const* module, char const* type) {
    // A type of a module that was never imported has no objects.
    py::dict const loaded = py::module_::import("sys").attr("modules");
    return loaded.contains(module) and py::isinstance(x, py::object(py::object(loaded[module]).attr(type)));
}
std::string text_of(py::handle x) { return py::str(x); }
void require_finite(py::handle is_finite, py::handle x) {
    if (not is_finite.cast<bool>())
        hilger::error::raise<hilger::error::not_finite>("a number in a formula is finite, and this one is ", text_of(x));
}
/// The value of a formula of numbers alone.
double number_of(expression const& x) {
    try {
        return hilger::text::stated(x, hilger::text::no_words(), "the formula").number<double>();
    } catch (hilger::error::exception const&) {
        throw py::type_error("a formula of numbers alone is a number, and this one is none: " + text_of(py::str(py::cast(x))));
    }
}

} // namespace

std::optional<expression> as_expression(py::handle x) {
    if (py::isinstance<expression>(x)) return x.cast<expression>();
    if (py::isinstance<py::bool_>(x) or py::isinstance<py::str>(x)) return {};
    if (py::isinstance<py::int_>(x)) return of_digits(text_of(x));
    if (py::isinstance<py::float_>(x)) { // numpy.float64 too
        double const number = x.cast<double>();
        if (not std::isfinite(number))
            hilger::error::raise<hilger::error::not_finite>("a number in a formula is finite, and this one is ", number);
        return of_digits(text_of(py::repr(py::float_(number))));
    }
    if (is_a(x, "numbers", "Rational")) {
        expression const above = of_digits(text_of(x.attr("numerator")));
        std::string const below = text_of(x.attr("denominator"));
        return below == "1" ? above : above / expression::number(below);
    }
    if (is_a(x, "decimal", "Decimal")) {
        require_finite(x.attr("is_finite")(), x);
        return of_digits(text_of(py::str("{:f}").attr("format")(x)));
    }
    if (is_a(x, "mpmath.ctx_mp_python", "_constant")) // pi, evaluated in as many digits as requested
        return as_expression(x(py::arg("dps") = 110));
    if (is_a(x, "mpmath", "mpf")) { // with its own digits, whatever the current precision
        py::module_ const mpmath = py::module_::import("mpmath");
        require_finite(mpmath.attr("isfinite")(x), x);
        long const bits = x.attr("man_exp").cast<py::tuple>()[0].attr("bit_length")().cast<long>();
        return of_digits(text_of(
            mpmath.attr("nstr")(x, py::int_(std::max(55L, bits * 31 / 100 + 3)), py::arg("min_fixed") = -400, py::arg("max_fixed") = 400)));
    }
    if (is_a(x, "numpy", "longdouble")) {
        require_finite(py::module_::import("numpy").attr("isfinite")(x), x);
        return of_digits(text_of(py::str(x)));
    }
    if (is_a(x, "numbers", "Real")) return as_expression(py::float_(py::reinterpret_borrow<py::object>(x))); // numpy's numbers
    return {};
}

namespace {

/// A binary operation, and its reflection where the other operand is a number.
template <class Type>
void add_operator(Type& type, char const* name, char const* reflected, kind what, bool swap = false) {
    auto const made = [what, swap](expression const& x, expression const& y) {
        return py::cast(swap ? expression(what, "", {y, x}) : expression(what, "", {x, y}));
    };
    type.def(
        name,
        [made](expression const& x, py::handle y) {
            auto const other = as_expression(y);
            return other ? made(x, *other) : not_implemented();
        },
        py::is_operator());
    if (reflected != nullptr)
        type.def(
            reflected,
            [made](expression const& x, py::handle y) {
                auto const other = as_expression(y);
                return other ? made(*other, x) : not_implemented();
            },
            py::is_operator());
}
expression required(py::handle x) {
    if (auto const e = as_expression(x)) return *e;
    std::string const type = text_of(py::type::of(x).attr("__name__"));
    throw py::type_error("a formula or a number was expected, and here is a " + type +
                         (type == "bool" ? ": conditions are made by <, <=, >, >=, &, | and ~, and == of formulas is none" : ""));
}

std::string text_for_people(expression const& x) {
    constexpr std::size_t page = 2000;
    return hilger::text::written(x, page).value_or("a formula of more than " + std::to_string(page) + " characters");
}

// Subexpressions that are shared stay shared after unpickling. The numbers of kinds are valid within one version.
using kept_node = std::tuple<int, std::string, std::vector<std::size_t>>;
using kept = std::tuple<int, int, std::vector<kept_node>>;
kept kept_of(expression const& x) {
    std::unordered_map<hilger::text::node const*, std::size_t> places;
    std::vector<kept_node> nodes;
    std::vector<hilger::text::node const*> open{&x.root()};
    while (not open.empty()) {
        auto const* const here = open.back();
        bool ready = true;
        for (auto const& part : here->parts)
            if (not places.contains(part.get())) {
                open.push_back(part.get());
                ready = false;
            }
        if (not ready) continue;
        open.pop_back();
        if (not places.emplace(here, nodes.size()).second) continue;
        std::vector<std::size_t> parts;
        for (auto const& part : here->parts) parts.push_back(places.at(part.get()));
        nodes.emplace_back(static_cast<int>(here->what), here->name, parts);
    }
    return {HILGER_VERSION_MAJOR, HILGER_VERSION_MINOR, nodes};
}
expression from_kept(kept const& x) {
    auto const& [major, minor, nodes] = x;
    if (major != HILGER_VERSION_MAJOR or minor != HILGER_VERSION_MINOR)
        hilger::error::raise<hilger::error::invalid_parameter>("a formula was kept by hilger ", major, '.', minor,
                                                               ", and this is another version");
    std::vector<expression> made;
    for (auto const& [what, name, parts] : nodes) {
        std::vector<expression> of;
        for (std::size_t const k : parts) of.push_back(made.at(k));
        made.emplace_back(static_cast<kind>(what), name, of);
    }
    return made.back();
}

} // namespace

void add_expressions(py::module_& m) {
    py::class_<expression> type(m, "Expression", "A formula of coordinates, velocities, the time and numbers.");
    add_operator(type, "__add__", "__radd__", kind::plus);
    add_operator(type, "__sub__", "__rsub__", kind::minus);
    add_operator(type, "__mul__", "__rmul__", kind::times);
    add_operator(type, "__truediv__", "__rtruediv__", kind::over);
    add_operator(type, "__pow__", "__rpow__", kind::power);
    add_operator(type, "__and__", nullptr, kind::both);
    add_operator(type, "__or__", nullptr, kind::either);
    add_operator(type, "__lt__", nullptr, kind::less);
    add_operator(type, "__le__", nullptr, kind::less_or_equal);
    add_operator(type, "__gt__", nullptr, kind::less, true);
    add_operator(type, "__ge__", nullptr, kind::less_or_equal, true);
    type.def(
        "__neg__", [](expression const& x) { return -x; }, py::is_operator());
    type.def(
        "__invert__", [](expression const& x) { return expression(kind::not_so, "", {x}); }, py::is_operator());
    type.def("__repr__", &text_for_people);
    type.def("__float__", &number_of);
    type.def(py::pickle(&kept_of, &from_kept));
    type.def(
        "__pos__", [](expression const& x) { return x; }, py::is_operator());
    type.def("__abs__", [](expression const& x) { return expression::call("abs", {x}); });
    type.def("__bool__", [](expression const&) -> bool {
        throw py::type_error("a formula is neither true nor false; what depends on a condition is hilger.where(condition, a, b)");
    });
    type.def_property_readonly("name", [](expression const& x) -> std::optional<std::string> {
        return x.root().what == kind::name ? std::optional(x.root().name) : std::nullopt;
    });
    m.def("variable", &expression::variable);
    m.def("element", [](std::string const& name, int k) { return expression::element(name, expression::number(std::to_string(k))); });
    m.def("call", [](std::string const& function, py::args const& arguments) {
        std::vector<expression> parts;
        for (py::handle const x : arguments) parts.push_back(required(x));
        return expression::call(function, parts);
    });
    m.def("where", [](py::handle condition, py::handle a, py::handle b) {
        expression const asked = required(condition);
        if (not hilger::text::is_condition(asked.root().what))
            hilger::error::raise<hilger::error::invalid_parameter>(
                "where(condition, a, b) asks a comparison, as q > 1, or several with &, | and ~, and here is ", text_of(condition));
        return expression(kind::choice, "", {asked, required(a), required(b)});
    });
    m.def("read", [](std::string const& text, std::string const& source) { return hilger::text::read(text, source); });
    m.def("as_expression", &required);
    py::list functions;
    for (auto const name : hilger::text::functions_of_one) {
        functions.append(py::str(name.data(), name.size()));
        // numpy's functions find them as methods: numpy.sin(q)
        type.def(std::string(name).c_str(), [f = std::string(name)](expression const& x) { return expression::call(f, {x}); });
    }
    m.attr("functions_of_one") = functions;
    for (std::string const name : {"sin", "cos", "tan", "sinh", "cosh", "tanh"}) // numpy's names of their inverses
        type.def(("arc" + name).c_str(), [f = "a" + name](expression const& x) { return expression::call(f, {x}); });
}

} // namespace bindings
