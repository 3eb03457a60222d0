// SPDX-License-Identifier: BSL-1.0
// Stand-alone C99 of an embedded Lagrangian, from the types that run: the Lagrangian is traced, differentiated in its graph, and written
// out with the embedding's operators on a symbolic h. Compiled in hilger::text.
//   std::cout << c_code(embed(L, mid_point), "pendulum");
//   std::cout << c_code<Eigen::Vector2d>(embed(L, mid_point), "kepler");
#pragma once

#include "hilger/integrator/flow.hpp"
#include "hilger/text/formula.hpp"
#include "hilger/variational/print.hpp"

namespace hilger {

namespace detail {

/// The contents of a written step: a node's formulas, the position and the weight of the node in the variable h, and its presentation.
struct c_step_of {
    std::string name;
    node_formulas node;
    tableau<formula_node> embedding;
    bool is_timed, is_forced, is_scalar;
    std::string embedding_name, equations;
};
std::string c_code(c_step_of const& what);
/// The C function int NAME_solve(double K[n][n], double x[n]): x becomes K^-1 x.
std::string c_solve(std::string const& name, int n);

/// @throws error::invalid_parameter if `name` is no name in C, or the number of components is not known
void require_c_code(std::string const& name, int d, int known);

/// Whether a callable takes the time and, if it can tell, reads it: a formula in text always takes it.
template <class F, class V>
bool takes_time(F const& f) {
    if constexpr (requires { f.reads_time(); })
        return f.reads_time();
    else
        return std::invocable<F const&, formula_node const&, V const&, V const&>;
}
/// The discrete equations as variational/print.hpp writes them, on a T of equal steps.
template <class F, linear_map A, linear_map B, class W, bool Checked>
std::string written_equations(F const& L, embedding<A, B, W, Checked> const& e, std::string const& indent) {
    auto const T = uniform(0.0, 1.0, 2);
    auto const EL = variation(action<F, A, B, W, std::remove_cvref_t<decltype(T)>>{L, e.position, e.velocity, T});
    return text_lines(EL, indent) + indent + text_lines(hamiltonian_form(EL), indent);
}

} // namespace detail

/// C99 that needs math.h alone, for states of the kind V: double, or an Eigen vector of d components. With d = 1 for a number, and the time
/// `double t` as the first argument of all if L or the force depends on it (t at q, at q0 for the residual):
///   double NAME_lagrangian(const double q[d], const double v[d])
///   void NAME_momentum(const double q[d], const double v[d], double p[d])                    p = dL/dv
///   void NAME_residual(double h, const double q0[d], const double q1[d], const double q2[d], double r[d])
///       r = d_2 L_h(q0, q1) + d_1 L_h(q1, q2) and the forces, a momentum
///   int NAME_step(double h, double q[d], double p[d], double v[d])
///       one step; v is the guess of the velocity at the node, and becomes that velocity: of several solutions the one that Newton's method
///       finds from there. Returns NAME_ok (0), or NAME_singular, NAME_no_convergence, NAME_not_finite with q, p and v unchanged.
/// @throws error::no_formula if L compares its arguments, error::invalid_parameter if `name` is no name in C, or V is dynamic without d
template <class V = double, class F, class Force, class E>
std::string c_code(flow<F, Force, E, sums::plain> const& method, std::string const& name, int d = detail::shape<V>::size) {
    static_assert(facts_of<E>.one_node,
                  "C code is written for embeddings whose integral has one node in a step, as mid-point and order one");
    detail::require_c_code(name, d, detail::shape<V>::size);
    auto const in = std::make_shared<detail::named_graph>(d, detail::shape<V>::is_scalar);
    detail::tracing<double> const here(in->graph);
    auto const& what = method.mechanics();
    return detail::on_arguments<V>(d, [&](auto const& t, auto const& q, auto const& v) {
        using vector = std::remove_cvref_t<decltype(q)>;
        std::vector<detail::formula_node> force;
        if constexpr (not std::same_as<Force, no_force>) detail::put_force<V>(detail::at_time{what.force, t}(q, v), d, force);
        detail::formula_node const L(detail::at_time{what.lagrangian, t}(q, v));
        return detail::c_code({name, detail::differentiated(in, L, force), tableau_of(method.embedding(), in->variable("h")),
                               detail::takes_time<F, vector>(what.lagrangian) or detail::takes_time<Force, vector>(what.force),
                               not force.empty(), detail::shape<V>::is_scalar, method.embedding().name,
                               detail::written_equations(what.lagrangian, method.embedding(), " *   ")});
    });
}

/// Refuses all other methods.
template <class V = double, class Method>
std::string c_code(Method const&, std::string const&, int = 0) {
    static_assert(sizeof(Method) == 0, "C code is that of a flow of one embedding with plain sums and without a history, c_code(embed(L, "
                                       "mid_point), name): flows of a composition are written one by one");
    return {};
}

} // namespace hilger
