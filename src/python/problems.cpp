// SPDX-License-Identifier: BSL-1.0
#include "bindings.hpp"
#include "engine/ensemble/ensemble.hpp"
#include "hilger/text/formula.hpp"

namespace bindings {

namespace {

namespace text = hilger::text;

using given_parameter = std::variant<std::string, std::vector<std::string>>;

using coordinates_of_python = std::vector<std::tuple<std::string, std::string, int>>;

std::vector<text::coordinate> names_of(coordinates_of_python const& coordinates) {
    std::vector<text::coordinate> all;
    for (auto const& [q, v, size] : coordinates) all.push_back({q, v, size});
    return all;
}
engine::problem made(text::expression const& L, coordinates_of_python const& coordinates, std::string const& time,
                     std::map<std::string, given_parameter> const& parameters) {
    auto words = std::make_shared<text::vocabulary>(names_of(coordinates), time);
    for (auto const& [name, digits] : parameters) std::visit([&, &n = name](auto const& d) { words->set(n, d); }, digits);
    return {text::stated_lagrangian(text::stated(L, std::move(words), "L")), {}, {}, "direct"};
}
std::string written(engine::problem const& of, coordinates_of_python const& coordinates, std::string const& time, bool latex_wanted) {
    constexpr long long page = 2000;
    if (auto const n = of.lagrangian.formula().operations(); n > page)
        return (latex_wanted ? "\\text{a formula of " : "a formula of ") + std::to_string(n) + " operations" + (latex_wanted ? "}" : "");
    auto const L = hilger::formula_of(of.lagrangian.formula(), names_of(coordinates), time);
    std::ostringstream out;
    if (latex_wanted)
        out << latex(L);
    else
        out << L;
    return out.str();
}

} // namespace

void add_problems(py::module_& m) {
    py::class_<engine::problem>(m, "Problem")
        .def(py::init(&made))
        .def("copy", [](engine::problem const& p) { return p; })
        .def("set_force",
             [](engine::problem& p, std::vector<text::expression> const& components) {
                 std::vector<text::stated> all;
                 auto const words = std::make_shared<text::vocabulary>(p.lagrangian.formula().words());
                 for (auto const& f : components) all.emplace_back(f, words, "the force");
                 p.force.emplace(std::move(all));
             })
        .def("add_damping",
             [](engine::problem& p, double rho, double alpha) {
                 p.damping.push_back({rho, alpha});
             })
        .def("set_material",
             [](engine::problem& p, double relaxed_modulus, double unrelaxed_modulus, double relaxation_time, double alpha) {
                 p.material = {relaxed_modulus, unrelaxed_modulus, relaxation_time, alpha};
             })
        .def("add",
             [](engine::problem& p, engine::problem const& other, std::string const& method) {
                 p.besides.push_back({other.lagrangian, method});
             })
        .def("transform_time",
             [](engine::problem& p, text::expression const& g, coordinates_of_python const& coordinates) {
                 engine::require_constant_energy(p);
                 p.time_transformation.emplace(g, p.lagrangian.formula(), names_of(coordinates), "g");
             })
        // The same problem, with these parameters, in this order, given by the members of an ensemble.
        .def("brought_by_members",
             [](engine::problem const& p, std::vector<std::string> const& names) {
                 text::vocabulary words = p.lagrangian.formula().words();
                 for (std::string const& name : names) words.bring_with_states(name);
                 return engine::with_words(p, words);
             })
        .def_readwrite("history", &engine::problem::history)
        .def("dimension", [](engine::problem const& p) { return p.lagrangian.formula().words().dimension(); })
        .def("written", &written)
        .def("equation", &engine::equation_of_method)
        .def("c_code", &engine::c_code_of);
}

} // namespace bindings
