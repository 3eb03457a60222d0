// SPDX-License-Identifier: BSL-1.0
// The problem to be stepped: a Lagrangian L(q, v) or L(t, q, v), and perhaps forces f(q, v) or f(t, q, v) that do not derive from it. In
// the discrete Lagrange-d'Alembert principle a force is added to dL/dq under the adjoint of the position operator.
#pragma once

#include "hilger/differentiation/derivatives.hpp"
#include "hilger/fixed_text.hpp"
#include "hilger/inlining.hpp"

namespace hilger {

/// Stands for the force of a problem without one.
struct no_force {};

/// A Lagrangian and a force, callables of (q, v) or of (t, q, v).
template <class F, class Force = no_force>
struct problem {
    [[no_unique_address]] F lagrangian;
    [[no_unique_address]] Force force;
};

/// Whether there is a force.
template <class Problem>
inline constexpr bool has_force = true;
template <class F>
inline constexpr bool has_force<problem<F, no_force>> = false;

namespace detail {

/// Whether L(t, q, v) or f(t, q, v) accepts a time of any number type, by a member is_generic_in_time = true. Otherwise the time is a
/// number of T, and std::sin(t) compiles.
template <class F>
inline constexpr bool is_generic_in_time = requires {
    requires F::is_generic_in_time;
};

/// f at time t, a function of two states, whether f takes the time or not.
template <class F, class S>
struct at_time {
    F const& f;
    S const& t;
    template <class X, class Y>
    HILGER_ALWAYS_INLINE constexpr auto operator()(X const& x, Y const& y) const {
        if constexpr (std::invocable<F const&, S const&, X const&, Y const&>)
            return value_from(f, t, x, y);
        else
            return call(f, x, y);
    }
    /// The members of L at time t: its derivatives, its Legendre map and the inverse of that.
#define HILGER_MEMBER_AT_TIME(type, member)                                                                                                \
    template <class V>                                                                                                                     \
        requires(                                                                                                                          \
            requires(F const& g, S const& u, V const& x) { g.member(u, x, x); } or requires(F const& g, V const& x) { g.member(x, x); })   \
    type member(V const& x, V const& y)                                                                                                    \
    const {                                                                                                                                \
        if constexpr (requires { f.member(t, x, y); })                                                                                     \
            return f.member(t, x, y);                                                                                                      \
        else                                                                                                                               \
            return f.member(x, y);                                                                                                         \
    }
    HILGER_MEMBER_AT_TIME(expansion<V>, expand)
    HILGER_MEMBER_AT_TIME(V, momentum)
    HILGER_MEMBER_AT_TIME(V, velocity)
#undef HILGER_MEMBER_AT_TIME
};
template <class F, class S>
at_time(F const&, S const&) -> at_time<F, S>;

/// f + g, each of (q, v) or of (t, q, v): Lagrangians, or forces that act together. @throws error::mismatch for vectors of two lengths
template <class F, class G>
struct sum_of_callables {
    [[no_unique_address]] F first;
    [[no_unique_address]] G second;
    template <class Q, class V>
        requires std::invocable<F const&, Q const&, V const&> and std::invocable<G const&, Q const&, V const&>
    constexpr auto operator()(Q const& q, V const& v) const { return sum(evaluated(first(q, v)), evaluated(second(q, v))); }
    template <class S, class Q, class V>
        requires std::invocable<F const&, S const&, Q const&, V const&> or std::invocable<G const&, S const&, Q const&, V const&>
    constexpr auto operator()(S const& t, Q const& q, V const& v) const {
        return sum(evaluated(at_time<F, S>{first, t}(q, v)), evaluated(at_time<G, S>{second, t}(q, v)));
    }

private:
    template <class X, class Y>
    static constexpr auto sum(X const& f, Y const& g) {
        if constexpr (requires { f.size() == g.size(); })
            if (f.size() != g.size())
                error::raise<error::mismatch>("forces that act together have one dimension, and these have ", f.size(), " and ", g.size());
        return plain_t<decltype(f + g)>(f + g);
    }
};
template <class F, class Force>
void is_problem(problem<F, Force> const&);

template <class X>
concept has_components = requires(X const& x) {
    x(0);
};
template <class X>
decltype(auto) component_of(X const& x, int k) {
    if constexpr (has_components<X>)
        return x(k);
    else
        return x;
}

/// Requires a force to be a state like q, of d components. @throws error::mismatch if only run time shows that it is not
template <class V, class X>
HILGER_ALWAYS_INLINE constexpr void require_force(X const& force, int d) {
    static_assert(has_components<X> != shape<V>::is_scalar, "a force is a state like q: a number for a number, a vector for a vector");
    if constexpr (has_components<X>) {
        constexpr int size = X::SizeAtCompileTime;
        if constexpr (size > 0 and shape<V>::size > 0)
            static_assert(size == shape<V>::size, "a force is a state like q, and this one has another number of components");
        else if (force.size() != d)
            error::raise<error::mismatch>("a force has a component for each of q, ", d, ", and this one has ", force.size());
    }
}
/// Appends the components of a traced force.
template <class V, class X, class T>
void put_force(X const& force, int d, std::vector<T>& components) {
    require_force<V>(force, d);
    for (int k = 0; k < d; ++k) components.push_back(T(component_of(force, k)));
}
/// The force at (t, q, v), a state like q.
template <class Force, class S, class V>
V force_at(Force const& force, S const& t, V const& q, V const& v) {
    auto const f = at_time{force, t}(in_constants(q), in_constants(v));
    require_force<V>(f, shape<V>::dimension(q));
    V x = zero_like(q);
    for (int k = 0; k < shape<V>::dimension(q); ++k)
        shape<V>::component(x, k) = as_jet<jet<scalar_of<V>, 0, 1, 1>>(component_of(f, k)).value;
    return x;
}

/// The numbers that a Lagrangian of states V is called with: jets of few variables, or traced.
template <class V>
struct jets_for {
    using S = scalar_of<V>;
    using s = shape<V>;
    using whole = qv_jet<S, s::size>;
    using position = typename s::template with<q_jet<S, s::size>>;
    using velocity = typename s::template with<v_jet<S, s::size>>;
    using of_force = typename s::template with<jet<S, 0, 2 * s::size, 1>>;
};
template <class V>
    requires is_traced_state<V>
struct jets_for<V> {
    using whole = traced<scalar_of<V>>;
    using position = typename shape<V>::template with<whole>;
    using velocity = position;
    using of_force = position;
};

/// Derivatives at one node, with forces, as node_jet has them (step/small/node.hpp).
template <class V>
struct node_table {
    expansion<V> e;
    block_of<V> vq_;
    using s = shape<V>;
    dependence on() const { return e.on; }
    template <int J>
    auto by_q() const {
        return s::component(e.by_q, J);
    }
    template <int J>
    auto by_v() const {
        return s::component(e.by_v, J);
    }
    template <int J, int K>
    auto qq() const {
        return s::entry(e.qq, J, K);
    }
    template <int J, int K>
    auto qv() const {
        return s::entry(e.qv, J, K);
    }
    template <int J, int K>
    auto vq() const {
        return s::entry(vq_, J, K);
    }
    template <int J, int K>
    auto vv() const {
        return s::entry(e.vv, J, K);
    }
};

/// The expansion of L at (t, q, v), with the force in by_q, qq and qv, and d2L/dv dq stored apart.
template <class F, class Force, class S, class V>
node_table<V> expand_at(problem<F, Force> const& what, S const& t, V const& q, V const& v) {
    using s = shape<V>;
    expansion<V> e = hilger::expand(at_time{what.lagrangian, t}, q, v);
    int const d = s::dimension(q);
    block_of<V> vq = s::zero_block(d);
    for (int j = 0; j < d; ++j)
        for (int k = 0; k < d; ++k) s::entry(vq, j, k) = s::entry(e.qv, k, j);
    if constexpr (not std::same_as<Force, no_force>) {
        e.on = dependence{dependence::no_polynomial, dependence::no_polynomial, true};
        if constexpr (is_traced_state<V>) {
            traced_there<V> const there(q, v, on_position | on_velocity, [&](auto const& x, auto const& y, std::vector<traced<S>>& f) {
                put_force<V>(at_time{what.force, t}(x, y), d, f);
                return traced<S>(0);
            });
            e.by_q = e.by_q + there.by_q;
            there.for_each_in(block_qq, [&](int row, int column, S const& x) { e.qq(row, column) += x; });
            there.for_each_in(block_qv, [&](int row, int column, S const& x) { e.qv(row, column) += x; });
        } else {
            constexpr int C = s::size;
            using J = jet<S, 0, 2 * C, 1>;
            auto const f = at_time{what.force, t}(with_variables<J, C>(q, 0, 0, {}), with_variables<J, C>(v, 0, C, {}));
            require_force<V>(f, d);
            for (int row = 0; row < d; ++row) {
                J const x(component_of(f, row));
                s::component(e.by_q, row) = s::component(e.by_q, row) + x.value;
                for (int k = 0; k < C; ++k) {
                    s::entry(e.qq, row, k) = s::entry(e.qq, row, k) + x.derivative(k);
                    s::entry(e.qv, row, k) = s::entry(e.qv, row, k) + x.derivative(C + k);
                }
            }
        }
    }
    return {std::move(e), std::move(vq)};
}

} // namespace detail

/// L and a force f(q, v) or f(t, q, v), a state like q: embed(with_force(L, f), mid_point). With the mid-point embedding f is evaluated
/// with dL/dq, at the middle of the step, which keeps order 2. Of three arguments the time is the first, for a force as for a Lagrangian,
/// whatever their names. Forces add up: with_force(with_force(L, f), g).
template <class L, class Force>
constexpr auto with_force(L const& l, Force f) {
    static_assert(
        not requires { l.action(); },
        "a force is stated with L, with_force(L, f), or beside the data of an equation, solve(equation, T, {.q0 = ..., .v0 = ...}, f)");
    static_assert(
        not requires { l.mechanics; },
        "forces come before the damping, with_fractional_damping(with_force(L, f), ...), and here a force is added to what is damped");
    if constexpr (requires { l.function; })
        return problem<std::remove_cvref_t<decltype(l.function)>, Force>{l.function, std::move(f)};
    else if constexpr (requires { detail::is_problem(l); }) {
        using before = std::remove_cvref_t<decltype(l.force)>;
        using F = std::remove_cvref_t<decltype(l.lagrangian)>;
        if constexpr (std::same_as<before, no_force>)
            return problem<F, Force>{l.lagrangian, std::move(f)};
        else
            return problem<F, detail::sum_of_callables<before, Force>>{l.lagrangian, {l.force, std::move(f)}};
    } else
        return problem<L, Force>{l, std::move(f)};
}

} // namespace hilger
