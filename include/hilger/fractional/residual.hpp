// SPDX-License-Identifier: BSL-1.0
// The residual of a trajectory with fractional damping. At the inner points of T it is that of the undamped flow, plus
//   (F_{i-1/2} + F_{i+1/2}) / 2,  F = -rho (theta D_{i+1} + (1 - theta) D_i)      read as a mean over each step,
//   -rho D_i                                                                      as impulses at the points, at any end of the steps,
// D_i = h^-beta omega(0)^beta sum_n w_n y_{i-n}; at the nodes of galerkin<s, radau> or lobatto, on any T, A*[-rho D^beta y], A the position
// and D^beta the power of the difference quotient. They are summed here by definition, from all positions and all weights, independently of
// the engines, the step and the histories; the points inside the steps are those of the trajectory.
#pragma once

#include "hilger/embedding/stage_weights.hpp"
#include "hilger/fractional/flow.hpp"
#include "hilger/integrator/residual.hpp"

namespace hilger {

namespace detail {

/// D_0, ..., D_N of one damping. Caputo's derivative is that of q less its start and, for beta >= 1, its tangent, which itself has the
/// derivative v0 for beta = 1. Or the sums of the sizes of their terms.
template <class Damping, class S, class V>
std::vector<V> differences_along(Damping const& d, S const& h, std::vector<V> const& q, V const& v0, bool only_sizes) {
    using G = typename Damping::generating;
    S const beta = d.order.template as<S>();
    bool const caputo = d.history == initial_history::caputo;
    auto w = first_weights<G>(beta, static_cast<index_type>(q.size()));
    for (S& weight : w)
        if (only_sizes) weight = magnitude(weight);
    S const scale = leading_weight<G>(beta) / power(h, beta);
    std::vector<V> y, D;
    for (std::size_t k = 0; k < q.size(); ++k) {
        y.push_back(caputo ? V(q[k] - q[0]) : q[k]);
        if (caputo and not(beta < S(1))) y[k] = y[k] - v0 * S(h * S(static_cast<long long>(k)));
        if (only_sizes) y[k] = sizes(q[k]) + sizes(q[0]) + sizes(v0) * S(h * S(static_cast<long long>(k)));
        V sum = zero_like(q[0]);
        for (std::size_t n = 0; n <= k; ++n) sum = sum + y[k - n] * w[n];
        D.push_back(V(sum * scale));
        if (caputo and beta == S(1)) D[k] = D[k] + (only_sizes ? V(sizes(v0)) : v0);
    }
    return D;
}
/// factor rho D, by components, or its size.
template <class Damping, class S, class V>
void add_damping(V& to, Damping const& d, S const& factor, V const& D, bool only_sizes) {
    using s = shape<V>;
    for (int k = 0; k < s::dimension(to); ++k) {
        S const force = factor * damped_components<Damping, S, V>::coefficient(d, k) * s::component(D, k);
        s::component(to, k) += only_sizes ? S(magnitude(force)) : force;
    }
}

/// The forces of a damping at t_1, ..., t_{N-1}, or the sums of the sizes of their terms.
template <class Damping, class S, class V>
std::vector<V> damping_along(mean_over_step<Damping> const& reading, S const& h, std::vector<V> const& q, V const& v0, bool only_sizes) {
    std::vector<V> force(q.size(), zero_like(q[0]));
    for (Damping const& d : reading.dampings) {
        S const theta = S(1) / S(2) + lag_of<typename Damping::generating, S>() * d.order.template as<S>();
        auto const derivative = differences_along(d, h, q, v0, only_sizes);
        for (std::size_t i = 0; i + 1 < q.size(); ++i)
            for (std::size_t end : {i, i + 1}) {
                add_damping(force[end], d, S(-theta / S(2)), derivative[i + 1], only_sizes);
                add_damping(force[end], d, S((theta - S(1)) / S(2)), derivative[i], only_sizes);
            }
    }
    return force;
}
template <class Damping, class S, class V>
std::vector<V> damping_along(impulses_at_points<Damping> const& reading, S const& h, std::vector<V> const& q, V const& v0,
                             bool only_sizes) {
    std::vector<V> force(q.size(), zero_like(q[0]));
    auto const derivative = differences_along(reading.damping, h, q, v0, only_sizes);
    for (std::size_t i = 0; i < q.size(); ++i) add_damping(force[i], reading.damping, S(-1), derivative[i], only_sizes);
    return force;
}

/// The forces at the nodes x of all steps, or the sums of the sizes of their terms. Caputo's derivative of an order above 1 leaves out the
/// tangent.
template <class Damping, int Stages, class Quadrature, discrete_function X>
std::vector<value_of<X>> damping_along(at_stages<Damping, Stages, Quadrature> const& reading, X const& x, value_of<X> const& q0,
                                       value_of<X> const& v0, bool only_sizes) {
    using V = value_of<X>;
    using S = scalar_of<V>;
    auto const& T = x.root();
    std::vector<V> force(x.size(), zero_like(q0));
    for (Damping const& d : reading.dampings) {
        std::vector<V> y;
        for (index_type i = x.first(); i <= x.last(); ++i) {
            S const time = S(1) < d.order.template as<S>() ? S(x.domain().base.point(T, i) - T.point(0)) : S(0);
            y.push_back(only_sizes ? V(sizes(V(x.get(i))) + sizes(q0) + sizes(v0) * time) : V(x.get(i) - q0 - v0 * time));
        }
        for (std::size_t i = 0; i < y.size(); ++i) {
            auto const step = static_cast<index_type>(i) / Stages;
            auto const w = stage_weights<S, Stages, side::minus, Quadrature>::of(d.order, static_cast<index_type>(i) % Stages, step + 1,
                                                                                 [&](index_type n) { return S(T.step(step - n)); });
            V sum = zero_like(q0);
            for (std::size_t n = 0; n < w.size(); ++n)
                for (std::size_t k = 0; k < Stages; ++k)
                    sum = sum + y[Stages * (w.size() - 1 - n) + k] * (only_sizes ? S(magnitude(w[n][k])) : w[n][k]);
            add_damping(force[i], d, S(-1), sum, only_sizes);
        }
    }
    return force;
}

/// Refused.
template <class Judge, class F, class Force, linear_map A, linear_map B, class W, sums Sums, class Reading, class Scale, class V>
    requires(controls_of<embedding<A, B, W>> != 2 and not takes_any_steps<Reading>)
typename Scale::root_type::scalar_type judged(Judge const&,
                                              trajectory<damped_flow<flow<F, Force, embedding<A, B, W>, Sums>, Reading>, Scale, V> const&) {
    static_assert(controls_of<embedding<A, B, W>> == 2,
                  "fractional damping under embeddings with points inside the steps, as galerkin<2, gauss>, has no equation in the points "
                  "of T alone that this could be judged by; at Radau's nodes it has one");
}
/// The worst row of an equation at x with the contribution of a damping; the sizes of its terms are asked for by a relative measure.
template <class Judge, class Equation, discrete_function X, class Force, class Damping, class Sizes>
auto worst_row(Judge const&, Equation const& equation, X const& x, Force const& force, Damping const& damping, Sizes const& size_of) {
    using V = value_of<X>;
    using S = scalar_of<V>;
    auto const residual = equation.residual(x, force);
    constexpr bool relative = std::same_as<Judge, by_rounding>;
    std::vector<V> size;
    if constexpr (relative) size = sizes_of_rows(equation, x, residual.first(), residual.last(), equation.derivatives(force));
    S worst(0);
    for (index_type i = residual.first(); i <= residual.last(); ++i) {
        V const r = residual.get(i) + damping(i);
        if constexpr (relative)
            worst = larger(worst, largest_in_roundings(r, V(size[static_cast<std::size_t>(i - residual.first())] + size_of(i))));
        else
            worst = larger(worst, S(magnitude(r)));
    }
    return worst;
}
/// The velocity that a trajectory began with.
template <class Path>
auto first_velocity(Path const& path) {
    auto const start = *path.begin();
    return path.starting_velocity() ? *path.starting_velocity()
                                    : velocity_of(at_time{path.method().undamped().mechanics().lagrangian, start.t}, start.q, start.p);
}

/// As without damping; N steps cost N^2 products.
template <class Judge, class F, class Force, linear_map A, linear_map B, class W, sums Sums, class Reading, class Scale, class V>
    requires(controls_of<embedding<A, B, W>> == 2 and not takes_any_steps<Reading>)
auto judged(Judge const& judge, trajectory<damped_flow<flow<F, Force, embedding<A, B, W>, Sums>, Reading>, Scale, V> const& path) {
    auto const& flow = path.method().undamped();
    auto const T = uniform(path.scale().min(), path.scale().domain().base.step(path.scale().root(), path.scale().first()),
                           static_cast<index_type>(path.scale().size()) - 1);
    std::vector<V> q;
    for (auto const& x : path) q.push_back(x.q);
    V const v0 = first_velocity(path);
    auto const along = [&](bool only_sizes) { return damping_along(path.method().damping(), T.h(), q, v0, only_sizes); };
    auto const damping = along(false), size = std::same_as<Judge, by_rounding> ? along(true) : damping;
    auto const at = [](auto const& of) { return [&of](index_type i) { return of[static_cast<std::size_t>(i)]; }; };
    values_so_far<V, std::remove_const_t<decltype(T)>> const x{{}, &T, &q};
    return worst_row(judge, equation_of(flow, T), x, flow.mechanics().force, at(damping), at(size));
}
/// At the nodes of a quadrature, with the values inside the steps that the trajectory has.
template <class Judge, class F, class Force, linear_map A, linear_map B, class W, sums Sums, class Damping, int Stages, class Quadrature,
          class Scale, class V>
auto judged(
    Judge const& judge,
    trajectory<damped_flow<flow<F, Force, embedding<A, B, W>, Sums>, at_stages<Damping, Stages, Quadrature>>, Scale, V> const& path) {
    auto const& flow = path.method().undamped();
    auto const T = scale_of_steps(path.scale());
    auto const equation = equation_of(flow, T);
    auto const x = positions_along(equation, T, path);
    auto const at_nodes = tabulate(equation.action().position[x]);
    V const v0 = first_velocity(path);
    auto const along = [&](bool only_sizes) {
        return function_on(at_nodes.scale(), damping_along(path.method().damping(), at_nodes, V(x.get(0)), v0, only_sizes));
    };
    auto const damping = along(false), size = std::same_as<Judge, by_rounding> ? along(true) : damping;
    auto const contribution = equation.of_force(damping);
    return worst_row(
        judge, equation, x, flow.mechanics().force, [&](index_type i) { return V(contribution.get(i)); },
        [&](index_type i) { return equation.size_of_force(size, i); });
}

} // namespace detail
} // namespace hilger
