// SPDX-License-Identifier: BSL-1.0
// The equation of a step with one node in formulas, for whoever prints its solution: with y the velocity at the node,
//   x = q + c y,   r = p + f g(x, y) - dL/dv(x, y) = 0,   c = w a_1,   f = w a_0,
// whose derivative by y is -K = f D - d2L/dv2 - c d2L/dvdq with D = dg/dy = c dg/dq + dg/dv.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "hilger/formula/of_nodes.hpp"
#include "hilger/step/tableau.hpp"

namespace hilger::detail {

inline std::string element(std::string const& array, int k) { return array + "[" + std::to_string(k) + "]"; }
inline std::string element(std::string const& array, int j, int k) { return element(element(array, j), k); }

/// The variables array[0], ..., array[n - 1].
inline symbol_list c_array(std::string const& array, int n) {
    symbol_list x;
    for (int k = 0; k < n; ++k) x.push_back(symbol::variable(element(array, k)));
    return x;
}
/// The variables name0, ..., or name alone when it is one.
inline symbol_list c_locals(std::string const& name, int n) {
    symbol_list x;
    for (int k = 0; k < n; ++k) x.push_back(symbol::variable(n == 1 ? name : name + std::to_string(k)));
    return x;
}
class node_equation {
protected:
    node_equation(node_evaluation const& what, tableau<symbol> const& b, symbol const& h)
        : N(what.dimension), w_(b.w(0)), c_(constant("c", w_ * b.a(0, 1))), f_(constant("f", w_ * b.a(0, 0))),
          time_(symbol::variable("t") + b.a(0, 1) * h), x_(c_locals("x", N)), y_(c_array("y", N)),
          node_(what.at(symbol::variable("t_node"), x_, y_)) {
        for (std::size_t k = 0; k < node_.gq.size(); ++k) D_.push_back(f_.is(0) ? symbol(0) : c_ * node_.gq[k] + node_.gv[k]);
        auto slopes = D_;
        for (std::size_t k = 0; k < D_.size(); ++k) slopes.push_back(node_.pv[k] + c_ * node_.pq[k]);
        linear_ = not depends(slopes, y_) and (c_.is(0) or not depends(slopes, x_));
    }
    /// A formula in h under a name; a number or h itself needs none.
    symbol constant(std::string const& name, symbol const& value) {
        if (value.get().is_leaf()) return value;
        for (auto const& [known, same] : constants_)
            if (same.same_as(value)) return symbol::variable(known);
        constants_.emplace_back(name, value);
        return symbol::variable(name);
    }

    int N;
    std::vector<std::pair<std::string, symbol>> constants_;
    symbol w_, c_, f_, time_;
    symbol_list x_, y_;
    node_formulas node_;
    symbol_list D_;
    bool linear_ = false; ///< in y
};

} // namespace hilger::detail
