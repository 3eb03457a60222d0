// SPDX-License-Identifier: BSL-1.0
// The nodes of a graph as text, for readers and for compilers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hilger/printing/expression.hpp"
#include "hilger/text/formula.hpp"

namespace hilger::detail {

/// Text and its precedence: a context that binds more tightly puts it into parentheses.
struct written {
    enum binding { sum, product, factor, atom };
    std::string text;
    binding tie = atom;
    [[nodiscard]] std::string in(binding place) const { return tie < place ? "(" + text + ")" : text; }
};

/// Whether an operation has two operands.
inline bool takes_two(std::string_view name) {
    for (std::string_view const known : {"+", "-", "*", "/", "pow", "hypot", "atan2", "over_norm", "max", "min", "where", "elsewhere"})
        if (name == known) return true;
    return false;
}
/// The operands of a value, direct and indirect, and the value itself, in the order of the graph.
std::vector<int> nodes_below(formula_graph<double> const& g, std::vector<formula_node> const& results);

/// A formula for a reader, with the factors of a product and equal terms of a sum gathered.
/// @throws error::no_formula when a constant is not finite
std::string printed(named_graph const& in, formula_node const& f, print_style style);

/// @throws error::no_formula when it is not finite
double finite_constant(double x);

} // namespace hilger::detail
