// SPDX-License-Identifier: BSL-1.0
// The flow (q_i, p_i) -> (q_{i+1}, p_{i+1}) of an embedded Lagrangian, in position-momentum form: p_i = -d_1 L_h(q_i, q_{i+1}) is
// solved for q_{i+1}, and p_{i+1} = d_2 L_h(q_i, q_{i+1}) follows (Cresson-Safi (95), (96) for mid-point, definition 12 for p). The same
// p serves every embedding; for order one it is the p^sigma of Cresson-Safi (15): p_{i+1} = dL/dv(q_i, Delta_plus[q]_i).
//   auto flow = embed(L, mid_point);
//   for (auto [t, q, p] : flow.along(T, q0, p0)) ...        one state at a time, nothing stored
#pragma once

#include "hilger/inlining.hpp"
#include "hilger/step/galerkin/step.hpp"
#include "hilger/step/many_nodes.hpp"
#include "hilger/step/mechanical.hpp"
#include "hilger/step/small/one_node.hpp"
#include "hilger/step/sum_of_embeddings.hpp"
#include "hilger/trajectory/stepping.hpp"
#include "hilger/variational/legendre.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

namespace detail {

/// The stepper of a refused problem, so that no other error follows.
template <class S, class V>
struct no_step {
    S length{};
    no_step_force none{};
    [[nodiscard]] S const& h() const { return length; }
    [[nodiscard]] no_step_force& extra() { return none; }
    [[nodiscard]] static bool needs_guess() { return false; }
    void guess(V const&) const {}
    template <class... Arguments>
    void prepare(Arguments const&...) const {}
    template <class... Arguments>
    void advance(Arguments const&...) const {}
    template <class Visit>
    void visit(Visit&) const {}
};

/// -d_0 L_h and d_n L_h at the control values U(0), ..., U(n), forces included: the momenta with which a step begins and ends.
template <class Derivatives, class S, class Values>
auto momenta_of_step(Derivatives const& derivatives, tableau<S> const& b, S const& t, S const& h, Values const& U) {
    auto const& first = U(0);
    using V = std::remove_cvref_t<decltype(first)>;
    int const last = b.controls - 1;
    V before = zero_like(first), after = before;
    for (int k = 0; k < b.nodes; ++k) {
        V position = first * b.a(k, 0), velocity = first * b.b(k, 0);
        for (int m = 1; m <= last; ++m) {
            auto const& value = U(m);
            position = position + value * b.a(k, m);
            velocity = velocity + value * b.b(k, m);
        }
        auto const [by_q, by_v] = derivatives.gradients(b.part_of(k), b.time(k, t, h), position, velocity);
        before = before - (by_q * S(b.w(k) * b.a(k, 0)) + by_v * S(b.w(k) * b.b(k, 0)));
        after = after + (by_q * S(b.w(k) * b.a(k, last)) + by_v * S(b.w(k) * b.b(k, last)));
    }
    return std::pair<V, V>(std::move(before), std::move(after));
}
/// The same for a step without values inside.
template <class Derivatives, class S, class V>
std::pair<V, V> momenta_of_step(Derivatives const& derivatives, tableau<S> const& b, S const& t, S const& h, V const& q0, V const& q1) {
    return momenta_of_step(derivatives, b, t, h, [&](int m) -> V const& { return m == 0 ? q0 : q1; });
}

} // namespace detail

/// The flow of L with a force under the embedding E; see embed().
template <class F, class Force, class E, sums Sums>
class flow : public stepping<flow<F, Force, E, Sums>> {
public:
    using problem_type = problem<F, Force>;
    static_assert(detail::is_local<E>,
                  "an action whose position or velocity reads all points before or after (Delta_minus_alpha, an antiderivative, an "
                  "operator that does not say what it reads) has an "
                  "equation that looks to both ends of T, and initial values do not determine its solution; with both end values given, "
                  "solve(equation, T, {.q0 = ..., .qN = ...}) solves it");
    static_assert(not detail::is_local<E> or detail::is_on_one_step<E>,
                  "position and velocity of an embedding that is stepped read the two ends of one step, and these reach over two steps or "
                  "more: solve(variation(action), T, values) goes on from as many first values as their equation needs");

    constexpr flow(F lagrangian, Force force, E embedding)
        : problem_{std::move(lagrangian), std::move(force)}, embedding_(std::move(embedding)) {}

    /// The data by which a trajectory of states V over times S is advanced: coefficients of the embedding, last velocities, factorizations.
    template <class S, class V, class Extra = detail::no_step_force>
    class stepper {
        using s = detail::shape<V>;
        static constexpr bool small =
            facts_of<E>.one_node and not detail::is_node_force<Extra> and s::size != Eigen::Dynamic and s::size <= detail::one_evaluation;
        static constexpr bool carried = Sums == sums::compensated;
        static constexpr bool known =
            is_mechanical<F> and not detail::is_node_force<Extra> and facts_of<E>.one_node and std::same_as<Force, no_force>;
        using table = typename detail::table_of_galerkin<E, S>::type;
        /// Whether there are control values inside the step and perhaps only the forces at the nodes to iterate.
        static constexpr bool inner = not std::is_void_v<table> and not detail::is_node_force<Extra> and
                                      (is_mechanical<F> or std::same_as<Force, no_force> or not detail::is_traced_state<V>);
        static auto choose(flow const& f, S const& h, V const& like, Extra const& extra) {
            if constexpr (not detail::is_local<E> or not detail::is_on_one_step<E>)
                return detail::no_step<S, V>{};
            else if constexpr (inner)
                return detail::galerkin_step<problem_type, table, carried, S, V, Extra>(f.problem_, tableau_of(f.embedding_, h), h, like,
                                                                                        extra);
            else if constexpr (known)
                return detail::mechanical_step<F, facts_of<E>, carried, S, V, Extra>(tableau_of(f.embedding_, h), h, f.problem_.lagrangian,
                                                                                     like, extra);
            else if constexpr (small)
                return detail::one_node<problem_type, facts_of<E>, carried, S, V, Extra>(tableau_of(f.embedding_, h), h, like, extra);
            else
                return detail::many_nodes<carried, S, V, Extra, controls_of<E>>(tableau_of(f.embedding_, h), h, like, extra);
        }

    public:
        stepper(flow const& f, S const& h, V const& like, Extra const& extra = {}) : stepper_(choose(f, h, like, extra)) {}
        /// The force that is constant in a step (step/force.hpp).
        [[nodiscard]] Extra& extra() { return stepper_.extra(); }

        /// The velocity that the first step begins with, at x, or one near it: Newton's method starts there.
        /// @throws as velocity_of
        void start_with(flow const& f, state<S, V> const& x, V const& v) {
            if constexpr (inner)
                stepper_.start_with(v);
            else if constexpr (not known)
                if (stepper_.needs_guess()) stepper_.guess(velocity_of(detail::at_time{f.problem_.lagrangian, x.t}, x.q, x.p, v));
        }
        /// For who takes shorter steps where Newton's method does not converge: other ways to the root cost more than these.
        void do_not_search() { stepper_.do_not_search(); }
        /// Advances x by one step h. @throws error::no_convergence, error::singular, error::not_finite, and x is as it was.
        void advance(flow const& f, state<S, V>& x, S const& h) {
            begin(f, x, h);
            try {
                stepper_.advance(what(f), x);
            } catch (std::nested_exception const& failure) { // where it failed is for the caller to say
                if (dynamic_cast<interrupted<S, V> const*>(&failure) == nullptr) throw;
                failure.rethrow_nested();
            }
        }
        /// Prepares steps of length h from x.
        void begin(flow const& f, state<S, V> const& x, S const& h) {
            prepare(f, h);
            if constexpr (not known and not inner)
                if (stepper_.needs_guess()) [[unlikely]]
                    stepper_.guess(velocity_of(detail::at_time{f.problem_.lagrangian, x.t}, x.q, x.p));
        }
        /// Advances x by one step of the prepared length. No address escapes, so that the state and a small stepper can live in registers.
        /// @throws the same as a step_failure
        HILGER_ALWAYS_INLINE void advance_equally(flow const& f, state<S, V>& x) {
            if constexpr (small and not known)
                stepper_.advance(what(f), x); // says so itself
            else
                saying_where(x, stepper_.h(), [&] { stepper_.advance(what(f), x); });
        }
        /// The control value m inside the last step, 0 < m < controls_of<E> - 1, less q_i.
        [[nodiscard]] V inside(int m) const { return stepper_.inside(m); }
        /// Calls each(label, number) for everything that later steps depend on; `each` may change the numbers, as reading them back does.
        template <class Visit>
        void visit(flow const& f, Visit& each) {
            S h = stepper_.h();
            each("step", h);
            prepare(f, h);
            stepper_.visit(each);
        }

    private:
        void prepare(flow const& f, S const& h) {
            if (h == stepper_.h()) [[likely]]
                return;
            stepper_.prepare(tableau_of(f.embedding_, h), h);
        }
        /// The argument of a step: the problem with its type where derivatives in registers are compiled with it.
        HILGER_ALWAYS_INLINE static decltype(auto) what(flow const& f) {
            if constexpr (inner or small or known)
                return (f.problem_);
            else
                return detail::given<problem_type, V>(f.problem_);
        }
        decltype(choose(std::declval<flow const&>(), std::declval<S const&>(), std::declval<V const&>(),
                        std::declval<Extra const&>())) stepper_;
    };
    template <class S, class V>
    using memory = stepper<S, V>;

    /// p_i = -d_1 L_h(q0, q1), forces included: the momentum with which the step from q0 arrives at q1.
    template <class S, class V>
    [[nodiscard]] V momentum_between(S const& t, V const& q0, V const& q1, S const& h) const {
        static_assert(controls_of<E> == 2, "two positions give a momentum where a step has no inner control values");
        return detail::momenta_of_step(detail::derivatives_at_nodes(problem_), tableau_of(embedding_, h), t, h, q0, q1).first;
    }
    /// p = dL/dv(t, q, v)
    template <class S, class V>
    [[nodiscard]] V momentum(S const& t, V const& q, V const& v) const {
        return momentum_of(detail::at_time{problem_.lagrangian, t}, q, v);
    }
    [[nodiscard]] problem_type const& mechanics() const { return problem_; }
    [[nodiscard]] E const& embedding() const { return embedding_; }

private:
    problem_type problem_;
    [[no_unique_address]] E embedding_;
};

/// The flow of L, or of with_force(L, f), under an embedding: embed(L, mid_point), or embed(L, mid_point, compensated) with compensated
/// sums. L is a callable L(q, v) or L(t, q, v) with a number as its value; embeddings over several steps do not compile.
template <class F, class E>
    requires(not function_expression<F>)
constexpr auto embed(F const& L, E const& how) { return flow<F, no_force, E, sums::plain>(L, {}, how); }
template <class F, class E>
constexpr auto embed(lagrangian<F> const& L, E const& how) {
    return flow<F, no_force, E, sums::plain>(L.function, {}, how);
}
template <class F, class Force, class E>
constexpr auto embed(problem<F, Force> const& forced, E const& how) {
    return flow<F, Force, E, sums::plain>(forced.lagrangian, forced.force, how);
}
template <class L, class E>
constexpr auto embed(L const& l, E const& how, std::integral_constant<sums, sums::compensated>) {
    auto const plain = embed(l, how);
    auto const& what = plain.mechanics();
    using F = std::remove_cvref_t<decltype(what.lagrangian)>;
    using Force = std::remove_cvref_t<decltype(what.force)>;
    return flow<F, Force, E, sums::compensated>(what.lagrangian, what.force, how);
}
/// The flow of a discrete Euler-Lagrange equation, with a force f(q, v) or f(t, q, v) beside dL/dq or without.
template <class F, linear_map A, linear_map B, class W, class Root, class Force = no_force>
constexpr auto flow_of(euler_lagrange<action<F, A, B, W, Root>> const& equation, Force const& force = {}) {
    auto const& S = equation.action();
    return embed(with_force(lagrangian(S.function), force), make_embedding<W>(S.position, S.velocity, "the embedding of an action"));
}
template <class First, class Second, class Force = no_force>
constexpr auto flow_of(euler_lagrange<action_sum<First, Second>> const& equation, Force const& force = {}) {
    auto const& S = equation.action();
    return embed(with_force(lagrangian(detail::function_of(S)), force), detail::embedding_of(S));
}
/// The same for operators that are inconsistent on purpose.
template <class F, linear_map A, linear_map B, class W, class Root>
constexpr auto flow_of(euler_lagrange<action<F, A, B, W, Root>> const& equation, inconsistent_t) {
    auto const& S = equation.action();
    return embed(lagrangian(S.function), make_embedding<W>(S.position, S.velocity, "the embedding of an action", inconsistent));
}

} // namespace hilger
