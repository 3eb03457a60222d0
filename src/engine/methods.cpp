// SPDX-License-Identifier: BSL-1.0
#include "engine/methods.hpp"

#include <algorithm>
#include <iomanip>
#include <ostream>

namespace engine {

bool method_entry::is_in(scalar_kind numbers) const { return std::find(scalars.begin(), scalars.end(), numbers) != scalars.end(); }

bool method_entry::is_called(std::string const& method) const {
    auto const colon = name.find(':');
    return colon == std::string::npos ? method == name : method.starts_with(name.substr(0, colon + 1));
}

std::vector<method_entry> const& all_methods() {
    using enum method_kind;
    using enum scalar_kind;
    static std::vector<method_entry> const all{
        {"order-one", 1, embedding, {machine, digits, rationals}, "L(q, Delta_plus[q]) under the Delta integral"},
        {"order-one-left", 1, embedding, {machine, digits, rationals}, "L(q, Delta_minus[q]) under the nabla integral"},
        {"mid-point",
         2,
         embedding,
         {machine, digits, rationals},
         "position and force in the middle of the step; with fractional damping too"},
        {"mid-point+", 2, embedding, {machine}, "the same with compensated sums"},
        {"theta:0.3", 1, embedding, {machine, digits, rationals}, "position and force at (1 - 0.3) q_i + 0.3 q_{i+1}"},
        {"verlet", 2, composition, {machine, digits, rationals}, "Stoermer and Verlet: explicit where L = v.Mv/2 - U(q)"},
        {"blanes-moan-4", 4, composition, {machine}, "steps of order-one and of its adjoint by turns"},
        {"kahan-li-8", 8, composition, {machine, digits}, "seventeen steps of verlet"},
        {"kahan-li-8+", 8, composition, {machine}, "the same with compensated sums"},
        {"gauss-2", 4, embedding, {machine}, "Galerkin's embedding with 2 Gauss nodes in a step"},
        {"gauss-4", 8, embedding, {machine}, "Galerkin's embedding with 4 Gauss nodes in a step"},
        {"gauss-6", 12, embedding, {machine}, "Galerkin's embedding with 6 Gauss nodes in a step"},
        {"gauss-8", 16, embedding, {machine, digits}, "Galerkin's embedding with 8 Gauss nodes in a step"},
        {"gauss-16", 32, embedding, {digits}, "Galerkin's embedding with 16 Gauss nodes in a step"},
        {"lobatto-3", 4, embedding, {machine}, "Galerkin's embedding with 3 Lobatto nodes in a step"},
        {"radau-3", 5, memory, {machine}, "with fractional damping, at 3 Radau nodes in a step, on any T"},
        {"radau-4", 7, memory, {machine}, "with fractional damping, at 4 Radau nodes in a step, on any T"},
        {"radau-5", 9, memory, {machine}, "with fractional damping, at 5 Radau nodes in a step, on any T"},
        {"g-alpha-newmark", 2, structure, {machine, digits}, "linear structures with fractional damping or a material, by weights of bdf2"},
        {"gl-newmark", 1, structure, {machine, digits}, "the same by weights of Gruenwald and Letnikov"},
        {"two-sided:0.75", 1, two_ends, {machine}, "v is the fractional difference of that order: looks to both ends"},
    };
    return all;
}

void list_methods(std::ostream& out) {
    for (method_entry const& one : all_methods()) {
        std::string numbers;
        for (auto const& [kind, word] : {std::pair{scalar_kind::machine, "double"}, std::pair{scalar_kind::digits, "digits"},
                                         std::pair{scalar_kind::rationals, "rationals"}})
            if (one.is_in(kind)) numbers += (numbers.empty() ? "" : ", ") + std::string(word);
        out << std::left << std::setw(17) << one.name << "order " << std::setw(4) << one.order << one.what << " (" << numbers << ")\n";
    }
    out << "and embeddings of operators, as integral(L((q + sigma[q])/2, Delta_plus[q])), in all numbers\n";
}

std::vector<std::string> method_names(problem const& what, scalar_kind numbers, bool between_ends) {
    std::vector<std::string> names;
    for (method_entry const& one : all_methods()) {
        bool const has_number = one.name.find(':') != std::string::npos;
        bool const remembers = one.kind == method_kind::structure or one.kind == method_kind::memory or
                               (one.name == "mid-point" and numbers == scalar_kind::machine);
        bool const is_for = what.material       ? one.kind == method_kind::structure
                            : what.has_memory() ? remembers
                            : between_ends      ? one.kind == method_kind::embedding and one.order <= 2 and one.name.back() != '+'
                                                : one.kind == method_kind::embedding or one.kind == method_kind::composition;
        if (is_for and not has_number and one.is_in(numbers)) names.push_back(one.name);
    }
    return names;
}

void refuse_method(std::string const& method, scalar_kind numbers, std::string const& scalar) {
    bool const is_double = numbers == scalar_kind::machine;
    std::string known;
    for (method_entry const& one : all_methods())
        if (one.is_in(numbers) and (is_double or one.kind != method_kind::structure)) known += (known.empty() ? "" : ", ") + one.name;
    if (is_double) hilger::error::raise<hilger::error::invalid_parameter>("there is no method '", method, "': there are ", known);
    hilger::error::raise<hilger::error::invalid_parameter>("in ", scalar, " the methods are ", known,
                                                           " and embeddings, as integral(L(q, Delta_plus[q])), and not '", method, "'");
}

} // namespace engine
