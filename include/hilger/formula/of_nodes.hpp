// SPDX-License-Identifier: BSL-1.0
// What one node of a step evaluates, as formulas: the Lagrangian, its derivatives, and forces beside dL/dq as in the discrete
// Lagrange-d'Alembert principle (variational/problem.hpp). Here a state is the list of its d components, whatever its type.
#pragma once

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

#include "hilger/formula/derivative.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger::detail {

using symbol_list = std::vector<symbol>;

/// Matrices row by row, entry (j, k) by component k of the variable.
struct node_formulas {
    symbol L;
    symbol_list g, p;   ///< dL/dq and the force, dL/dv
    symbol_list gq, gv; ///< derivatives of g by q and by v
    symbol_list pq, pv; ///< and of p
};
/// The formulas at variables t, q and v.
struct node_evaluation {
    int dimension;
    bool timed; ///< L or the force takes the time
    std::function<node_formulas(symbol const& t, symbol_list const& q, symbol_list const& v)> at;
};

/// The derivatives of each formula by each variable.
inline symbol_list jacobian(symbol_list const& formulas, symbol_list const& variables) {
    symbol_list rows;
    for (symbol const& f : formulas)
        for (symbol const& x : variables) rows.push_back(partial(f, x));
    return rows;
}
/// Whether one of the formulas has one of the variables in it.
inline bool depends(symbol_list const& formulas, symbol_list const& variables) {
    for (symbol const& by : jacobian(formulas, variables))
        if (not by.is(0)) return true;
    return false;
}

/// Whether one of the variables is written in one of the formulas.
inline bool reads(symbol_list const& formulas, symbol_list const& variables) {
    std::set<formula const*> seen;
    std::function<bool(symbol const&)> const has = [&](symbol const& f) {
        if (f.op() == operation::number or not seen.insert(&f.get()).second) return false;
        if (f.op() == operation::variable)
            return std::any_of(variables.begin(), variables.end(), [&](symbol const& x) { return x.same_as(f); });
        return has(f.first()) or (f.get().b and has(f.second()));
    };
    return std::any_of(formulas.begin(), formulas.end(), has);
}
/// Whether the formulas have branches that one of the variables decides.
inline bool branches(symbol_list const& formulas, symbol_list const& variables) {
    std::set<formula const*> seen;
    std::function<bool(symbol const&)> const has = [&](symbol const& f) {
        if (f.get().is_leaf() or not seen.insert(&f.get()).second) return false;
        symbol_list parts{f.first()};
        if (f.get().b) parts.push_back(f.second());
        if (has_branches(f.op()) and reads(parts, variables)) return true;
        return std::any_of(parts.begin(), parts.end(), has);
    };
    return std::any_of(formulas.begin(), formulas.end(), has);
}

/// Whether a callable takes the time and, where it can say so, reads it: a formula in text takes it always.
template <class F, class V>
bool reads_time(F const& f) {
    if constexpr (requires { f.reads_time(); })
        return f.reads_time();
    else
        return std::invocable<F const&, symbol const&, V const&, V const&>;
}

/// What is to be evaluated for states of the kind V, numbers or vectors of d components. It refers to `what`.
template <class V, class F, class Force>
node_evaluation evaluation_of(problem<F, Force> const& what, int d) {
    using s = shape<V>;
    using vector = typename s::template with<symbol>;
    bool const timed = reads_time<F, vector>(what.lagrangian) or reads_time<Force, vector>(what.force);
    return {d, timed, [&what, d](symbol const& t, symbol_list const& q, symbol_list const& v) {
                vector x = variables<V>("q", d), y = x;
                for (int k = 0; k < d; ++k) {
                    s::component(x, k) = q[static_cast<std::size_t>(k)];
                    s::component(y, k) = v[static_cast<std::size_t>(k)];
                }
                node_formulas n;
                n.L = symbol(at_time{what.lagrangian, t}(x, y));
                n.g = jacobian({n.L}, q);
                n.p = jacobian({n.L}, v);
                if constexpr (not std::same_as<Force, no_force>) {
                    vector const f(at_time{what.force, t}(x, y));
                    for (int k = 0; k < d; ++k) n.g[static_cast<std::size_t>(k)] += s::component(f, k);
                }
                n.gq = jacobian(n.g, q);
                n.gv = jacobian(n.g, v);
                n.pq = jacobian(n.p, q);
                n.pv = jacobian(n.p, v);
                return n;
            }};
}

} // namespace hilger::detail
