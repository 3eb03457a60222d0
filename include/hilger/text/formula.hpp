// SPDX-License-Identifier: BSL-1.0
// A Lagrangian as a formula: traced without values, differentiated in its graph, and written out. Compiled in hilger::text.
//   formula const L = formula_of([](auto const& q, auto const& v) { return v * v / 2 - (1 - cos(q)); });
//   std::cout << L << L.by_q() << latex(L.by_v());         v²/2 − (1 − cos(q)), −sin(q), v
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "hilger/differentiation/traced/derivatives_of_graph.hpp"
#include "hilger/text/stated.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger {

namespace detail {

/// An operation of a formula, or a constant in it.
using formula_node = traced<double>;

/// A name, and the number of a component if it is not negative.
struct argument_name {
    std::string name;
    int component = -1;
};
/// A graph without values whose arguments have names: d positions, d velocities, the time, and variables.
class named_graph {
public:
    explicit named_graph(int d, bool is_scalar = false);
    /// The variable of this name, by which nothing is differentiated.
    formula_node variable(std::string const& name);
    [[nodiscard]] static formula_node argument(int number) { return formula_node::at(number, 0); }

    formula_graph<double> graph;
    std::vector<argument_name> names; ///< by the numbers of arguments; for all but variables these are those of their nodes
    int dimension;

private:
    std::vector<int> variables_; ///< their nodes
};

/// The formulas of one node of a step, in a graph: the Lagrangian, its derivatives, and forces added to dL/dq by the discrete
/// Lagrange-d'Alembert principle (variational/problem.hpp). Matrices row by row, entry (j, k) by component k of the variable.
struct node_formulas {
    std::shared_ptr<named_graph> in;
    formula_node L;
    std::vector<formula_node> g, p;   ///< dL/dq and the force, dL/dv
    std::vector<formula_node> gq, gv; ///< derivatives of g by q and by v
    std::vector<formula_node> pq, pv; ///< and of p
};
/// Differentiates L, and a force if it has components.
node_formulas differentiated(std::shared_ptr<named_graph> in, formula_node const& L, std::vector<formula_node> const& force);

/// Calls use(t, q, v) with the arguments of a graph, in the shape of V.
template <class V, class Use>
decltype(auto) on_arguments(int d, Use const& use) {
    using s = shape<V>;
    typename s::template with<formula_node> q, v;
    if constexpr (s::size == Eigen::Dynamic) {
        q.resize(d);
        v.resize(d);
    }
    for (int k = 0; k < d; ++k) {
        s::component(q, k) = named_graph::argument(k);
        s::component(v, k) = named_graph::argument(d + k);
    }
    return use(named_graph::argument(2 * d), q, v);
}

} // namespace detail

/// A formula in (t, q, v), or a partial derivative of one. Copies share a graph, which one thread may use at a time.
class formula {
public:
    formula(std::shared_ptr<detail::named_graph> in, detail::formula_node const& what) : in_(std::move(in)), what_(what) {}
    /// The partial derivative by component k of q, of v, and by t.
    [[nodiscard]] formula by_q(int k = 0) const { return by(k); }
    [[nodiscard]] formula by_v(int k = 0) const { return by(in_->dimension + k); }
    [[nodiscard]] formula by_t() const { return by(2 * in_->dimension); }

    /// The value at (t, q, v); `arguments` lists the components of q, then of v, then t.
    [[nodiscard]] double value(std::vector<double> const& arguments) const;
    /// Prints for a terminal, latex in LaTeX. @throws error::no_formula if a constant is not finite
    friend std::ostream& operator<<(std::ostream& out, formula const& f);
    friend std::string latex(formula const& f);
    /// Number of operations and arguments in print, shared ones repeated; at most `most`.
    [[nodiscard]] int size(int most) const;

private:
    [[nodiscard]] formula by(int argument) const;
    std::shared_ptr<detail::named_graph> in_;
    detail::formula_node what_;
};

/// The formula of a callable L(q, v) or L(t, q, v), of states V with d components. @throws error::no_formula if it compares its arguments
template <class V = double, class F>
formula formula_of(F const& lagrangian, int d = detail::shape<V>::size) {
    auto in = std::make_shared<detail::named_graph>(d, detail::shape<V>::is_scalar);
    detail::tracing<double> const here(in->graph);
    auto const L = detail::on_arguments<V>(d, [&](auto const& t, auto const& q, auto const& v) {
        return detail::formula_node(detail::at_time{lagrangian, t}(q, v));
    });
    return {std::move(in), L};
}
/// The formula of a text; its arguments are named as the coordinates, without an index for one that is a number, and as the time.
formula formula_of(text::stated const& lagrangian, std::vector<text::coordinate> const& coordinates, std::string const& time);

} // namespace hilger
