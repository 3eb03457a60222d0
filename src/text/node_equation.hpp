// SPDX-License-Identifier: BSL-1.0
// The equation of a step with one node in a graph, for code that solves it: with y the velocity at the node,
//   x = q + c y,   r = p + f g(x, y) - dL/dv(x, y) = 0,   c = w a_1,   f = w a_0,
// whose derivative by y is -K = f D - d2L/dv2 - c d2L/dvdq with D = dg/dy = c dg/dq + dg/dv.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hilger/step/tableau.hpp"
#include "text/c_statements.hpp"

namespace hilger::detail {

class node_equation {
protected:
    using node_list = std::vector<formula_node>;

    /// The embedding is a function of the variable h. `type` is the C type of values.
    node_equation(node_formulas const& of, tableau<formula_node> const& b, std::string type);

    /// Whether the force or the momentum has branches that depend on y.
    [[nodiscard]] bool has_branches() const;
    [[nodiscard]] static bool are_numbers(node_list const& all);
    [[nodiscard]] formula_node variable(std::string const& name) const { return in_.variable(name); }
    [[nodiscard]] formula_node y(int k) const { return named_graph::argument(N + k); }
    [[nodiscard]] std::string name_of_x(int k) const { return in_.names[static_cast<std::size_t>(k)].name; }
    [[nodiscard]] std::size_t at(int j, int k) const { return static_cast<std::size_t>(j * N + k); }
    [[nodiscard]] bool has_slope(int j, int k) const { return not D_[at(j, k)].is(0); }
    /// The element of K, given the variable of an element of D.
    [[nodiscard]] formula_node slope_of_row(int j, int k, std::string const& D) const;
    /// Names a formula in h; numbers, h and formulas that have a name keep theirs.
    formula_node constant(std::string const& name, formula_node const& value);
    [[nodiscard]] std::string name_of(formula_node const& argument) const {
        return in_.names[static_cast<std::size_t>(in_.graph[argument.place()].b)].name;
    }
    [[nodiscard]] c_statements statements(std::string indent, std::string letter = "u") const {
        return {in_, std::move(indent), std::move(letter), type_};
    }
    /// The statements for the time and the position at the node, as far as they are used. Adds the names that they read to `used`.
    std::string position(std::string const& in, std::set<std::string>& used) const;
    /// A block that computes g when the position is the end point, where the iterations do not need it.
    std::string force_at_the_end(std::set<std::string>& used) const;

    named_graph& in_;
    tracing<double> const here_;
    int N;
    std::string type_;
    std::vector<std::pair<std::string, formula_node>> constants_;
    formula_node w_, c_, f_, time_;
    node_formulas node_;
    node_list D_;
    bool linear_ = false; ///< the equation is linear in y
};

} // namespace hilger::detail
