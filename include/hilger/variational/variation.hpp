// SPDX-License-Identifier: BSL-1.0
// The discrete Euler-Lagrange equation of an action, read off from the adjoints of its two operators:
//   A*[dL/dq] + B*[dL/dv] = 0  at the inner points of T,  A = position, B = velocity.
// Nothing is written per scheme: order one gives dL/dq - Delta_minus[dL/dv] = 0 (Cresson-Safi (14)), mid-point gives
// [dL/dq]_{1/2,-} - Delta_{1/2,-}[dL/dv] = 0 (Cresson-Safi (56)).
#pragma once

#include "hilger/adjoint/adjoint.hpp"
#include "hilger/variational/action.hpp"
#include "hilger/variational/nodes/node_derivatives.hpp"

namespace hilger {

namespace detail {

/// Whether the points of a family are equidistant on a uniform T: T_{o,lambda} for lambda = 1/2 only, the nodes of a quadrature not.
template <class Base>
inline constexpr bool has_equal_steps = false;
template <>
inline constexpr bool has_equal_steps<nodes> = true;
template <class Lambda>
inline constexpr bool has_equal_steps<between<Lambda>> = true;
template <class Lambda>
inline constexpr bool has_equal_steps<joined<Lambda>> = std::is_same_v<Lambda, fraction<1, 2>>;
template <int Parts>
inline constexpr bool has_equal_steps<parts_of_steps<Parts>> = true;

/// A without the reweightings that are the identity on a uniform T.
struct on_equal_steps {
    template <linear_map A>
    static constexpr auto of(A const& a) {
        return a;
    }
    template <class Base, class From, class To>
    static constexpr auto of(reweight<Base, From, To> const& a) {
        if constexpr (has_equal_steps<Base>)
            return identity_on<Base, From, To>{};
        else
            return a;
    }
    template <class C, linear_map A>
    static constexpr auto of(multiple<C, A> const& a) {
        return a.c * of(a.a);
    }
    template <linear_map A, linear_map B>
    static constexpr auto of(operator_sum<A, B> const& s) {
        return of(s.a) + of(s.b);
    }
    template <linear_map A, linear_map B>
    static constexpr auto of(composition<A, B> const& ab) {
        auto const a = of(ab.a);
        auto const b = of(ab.b);
        if constexpr (is_identity<std::remove_cvref_t<decltype(a)>>)
            return b;
        else if constexpr (is_identity<std::remove_cvref_t<decltype(b)>>)
            return a;
        else
            return a * b;
    }
};

/// 1 at one point of a family, 0 at the others.
template <class Root, class Base>
struct unit_at : function_interface<unit_at<Root, Base>> {
    using root_type = Root;
    using domain_type = hilger::domain<Base>;
    Root const* T;
    index_type k;
    [[nodiscard]] constexpr Root const& root() const { return *T; }
    [[nodiscard]] static constexpr domain_type domain() { return {}; }
    [[nodiscard]] constexpr auto get(index_type i) const { return typename Root::scalar_type(i == k ? 1 : 0); }
};

} // namespace detail

/// The equation of one action, in the sum over T with the weights P.
template <class Action, class P = typename Action::position_type::from_weight>
class euler_lagrange {
    using A = typename Action::position_type;
    using B = typename Action::velocity_type;
    using W = typename Action::weight;
    using Root = typename Action::root_type;
    template <class Force>
    using problem_with = problem<typename Action::function_type, Force>;

    // An operator without run-time parameters is its type: static_assert then knows the equation's operators on a run-time scale too.
    static constexpr bool by_type = std::conjunction_v<std::is_empty<A>, std::is_empty<B>>;

    /// The adjoint of a, written on T.
    template <linear_map Op>
    static constexpr auto adjoint_on_T(Op const& a) {
        if constexpr (not Root::is_uniform)
            return adjoint_between<P, W>(a);
        else if constexpr (detail::has_equal_steps<typename Op::to>)
            return detail::on_equal_steps::of(a.adjoint());
        else
            return detail::on_equal_steps::of(adjoint_between<P, W>(a));
    }
    template <linear_map Op>
    static constexpr auto written_on_T(Op const& a) {
        if constexpr (Root::is_uniform)
            return uniformly(adjoint_on_T(a));
        else
            return adjoint_on_T(a);
    }
    /// The same in the paper's form: on T_lambda^- if the integral is over T_lambda, else on T.
    template <linear_map Op, class Scale>
    static constexpr auto as_written(Op const& a, Scale const& scale) {
        auto const there = [&] {
            if constexpr (requires { scale.lambda; })
                return projection<std::remove_cvref_t<decltype(scale.lambda)>, true>{{}, scale.lambda} * adjoint_on_T(a);
            else
                return adjoint_on_T(a);
        }();
        if constexpr (Root::is_uniform)
            return uniformly(there);
        else
            return there;
    }

public:
    constexpr explicit euler_lagrange(Action s) : action_(std::move(s)) {}

    [[nodiscard]] constexpr Action const& action() const { return action_; }
    /// The operators on dL/dq and on dL/dv. On a uniform T they compare with == as operators on uniform scales.
    [[nodiscard]] static constexpr auto force() requires by_type { return as_written(A{}, typename A::to{}); }
    [[nodiscard]] static constexpr auto momentum() requires by_type { return as_written(B{}, typename B::to{}); }
    [[nodiscard]] constexpr auto force() const requires(not by_type) { return as_written(action_.position, base()); }
    [[nodiscard]] constexpr auto momentum() const requires(not by_type) { return as_written(action_.velocity, base()); }
    /// The same on T, as in the terms of a sum of equations.
    [[nodiscard]] constexpr auto force_on_T() const { return written_on_T(action_.position); }
    [[nodiscard]] constexpr auto momentum_on_T() const { return written_on_T(action_.velocity); }

    /// The left-hand side at x in C(T), a function on T^+-; zero exactly if x solves the equation. Traced vectors share one formula.
    template <discrete_function X>
    constexpr auto residual(X const& x) const {
        if constexpr (detail::is_traced_at<problem_with<no_force>, value_of<X>>) {
            using V = value_of<X>;
            detail::kept_derivatives const L(problem_with<no_force>{action_.function, {}});
            return residual_of(
                x, [L](auto const& t, auto const& q, auto const& v) { return L.by_q(t, V(q), V(v)); },
                [L](auto const& t, auto const& q, auto const& v) { return L.by_v(t, V(q), V(v)); });
        } else
            return residual_of(
                x,
                [L = action_.function](auto const& t, auto const& q, auto const& v) {
                    return gradient_first(detail::at_time{L, t}, q, v);
                },
                [L = action_.function](auto const& t, auto const& q, auto const& v) {
                    return gradient_second(detail::at_time{L, t}, q, v);
                });
    }
    /// The same with a force f(q, v) or f(t, q, v) added to dL/dq (Lagrange-d'Alembert).
    template <discrete_function X, class Force>
    constexpr auto residual(X const& x, Force const& force) const {
        if constexpr (std::same_as<Force, no_force>)
            return residual(x);
        else {
            auto const f = action_.at_nodes(
                x, [force](auto const& t, auto const& q, auto const& v) { return detail::force_at(force, t, evaluated(q), evaluated(v)); });
            return residual(x) + of_force(f);
        }
    }
    /// The contribution of the values of a force at the nodes of the integral.
    template <discrete_function F>
    constexpr auto of_force(F const& f) const {
        return at_inner_points(adjoint_on_T(action_.position)[counted(f)]);
    }
    /// The same at point k for values and weights of one sign.
    template <discrete_function F>
    constexpr auto size_of_force(F const& sizes, index_type k) const {
        using V = value_of<F>;
        using S = typename Root::scalar_type;
        detail::unit_at<Root, typename A::from> const unit{{}, &sizes.root(), k};
        return V(of_force(apply_pointwise([](V const& f, S const& weight) { return V(f * S(weight < S(0) ? -1 : 1)); }, sizes,
                                          action_.position[unit]))
                     .get(k));
    }
    /// The derivatives of L at any node, with a force added to dL/dq if there is one.
    template <class Force = no_force>
    [[nodiscard]] auto derivatives(Force const& force = {}) const {
        return detail::kept_derivatives(problem_with<Force>{action_.function, force});
    }
    /// The derivative of the residual at x by the value x(k), a function on T^+- of d x d matrices.
    template <discrete_function X, class Force>
    constexpr auto residual_slope(X const& x, index_type k, detail::kept_derivatives<problem_with<Force>> const& kept) const {
        using V = value_of<X>;
        using S = typename Root::scalar_type;
        auto const seconds =
            action_.at_nodes(x, [kept](auto const& t, auto const& q, auto const& v) { return kept.expand(t, V(q), V(v)); });
        detail::unit_at<Root, typename A::from> const unit{{}, &x.root(), k};
        auto const a = action_.position[unit];
        auto const b = action_.velocity[unit];
        auto const of_position = apply_pointwise(
            [](auto const& at, S const& of_q, S const& of_v) { return block_of<V>(at.e.qq * of_q + at.e.qv * of_v); }, seconds, a, b);
        auto const of_velocity = apply_pointwise(
            [](auto const& at, S const& of_q, S const& of_v) { return block_of<V>(at.vq_ * of_q + at.e.vv * of_v); }, seconds, a, b);
        return sum_of_adjoints(of_position, of_velocity);
    }
    /// The sum of the magnitudes of the terms of the residual at its point k: from absolute values of weights and of derivatives of L.
    template <discrete_function X, class Force>
    constexpr auto residual_size(X const& x, index_type k, detail::kept_derivatives<problem_with<Force>> const& kept) const {
        using V = value_of<X>;
        using S = typename Root::scalar_type;
        auto const firsts =
            action_.at_nodes(x, [kept](auto const& t, auto const& q, auto const& v) { return kept.gradients(0, t, V(q), V(v)); });
        detail::unit_at<Root, typename A::from> const unit{{}, &x.root(), k};
        auto const sized = [&](auto const& op, auto part) {
            return apply_pointwise(
                [part](auto const& at, S const& weight) { return V(detail::sizes(at.*part) * S(weight < S(0) ? -1 : 1)); }, firsts,
                op[unit]);
        };
        using pair = std::pair<V, V>;
        return V(sum_of_adjoints(sized(action_.position, &pair::first), sized(action_.velocity, &pair::second)).get(k));
    }
    /// The values of x that the residual at a point of T reads. An adjoint mirrors the reach; its weights depend on T alone.
    static constexpr reach reads = [] {
        constexpr reach both = A::reads | B::reads;
        return reach::composed<typename A::to>(reach::mirrored<typename A::from, typename A::to>(A::reads), both) |
               reach::composed<typename B::to>(reach::mirrored<typename B::from, typename B::to>(B::reads), both);
    }();
    /// The domain of the values of L that the equation reads: on a uniform T it has no weights, and omits end points with weight zero in
    /// the integral. (On other scales the operators contain the weights.)
    template <class Base, int Front, int Back>
    static constexpr auto counted(domain<Base, Front, Back> const& d) {
        constexpr bool uniform = Root::is_uniform;
        return domain<Base, std::max(Front, uniform and W::vanishes_first ? 1 : 0), std::max(Back, uniform and W::vanishes_last ? 1 : 0)>{
            d.base};
    }

private:
    /// With functions for dL/dq and dL/dv at a node.
    template <discrete_function X, class First, class Second>
    constexpr auto residual_of(X const& x, First first, Second second) const {
        auto const Lq = read_by<A>(action_.at_nodes(x, std::move(first)));
        auto const Lv = read_by<B>(action_.at_nodes(x, std::move(second)));
        return sum_of_adjoints(Lq, Lv);
    }
    /// The left-hand side with by_q and by_v for dL/dq and dL/dv.
    template <discrete_function Lq, discrete_function Lv>
    constexpr auto sum_of_adjoints(Lq by_q, Lv by_v) const {
        return at_inner_points(adjoint_on_T(action_.position)[counted(std::move(by_q))] +
                               adjoint_on_T(action_.velocity)[counted(std::move(by_v))]);
    }
    /// Tabulates values that the adjoint of a nonlocal Op reads at every point.
    template <linear_map Op, discrete_function G>
    static constexpr auto read_by(G g) {
        if constexpr (Op::reads.is_local())
            return g;
        else
            return tabulate(g);
    }
    template <discrete_function G>
    static constexpr auto counted(G g) {
        auto const here = counted(g.domain());
        if constexpr (std::same_as<std::remove_const_t<decltype(here)>, typename G::domain_type>)
            return g;
        else
            return detail::restrict_to(std::move(g), here);
    }
    /// Fractional differences have values at the ends too, where variations vanish and no equation holds.
    template <discrete_function R>
    static constexpr auto at_inner_points(R r) {
        using D = typename R::domain_type;
        if constexpr (D::front > 0 and D::back > 0)
            return r;
        else
            return detail::restrict_to(std::move(r),
                                       domain<typename D::base_type, std::max(D::front, 1), std::max(D::back, 1)>{r.domain().base});
    }
    [[nodiscard]] constexpr auto base() const { return action_.position.image(domain<typename A::from>{}).base; }
    Action action_;
};

/// The discrete Euler-Lagrange equation of the action S: its critical points for variations that vanish at both ends.
template <class F, linear_map A, linear_map B, class W, class Root>
constexpr auto variation(action<F, A, B, W, Root> const& S) {
    return euler_lagrange<action<F, A, B, W, Root>>(S);
}

template <class Action, class P, class Other, class Q>
constexpr auto operator+(euler_lagrange<Action, P> const&, euler_lagrange<Other, Q> const&) {
    return does_not_compile<"equations are not added up, actions are: variation(S + R) is the equation of the sum of the actions S and R",
                            Action, Other>{};
}

template <class F, linear_map A, linear_map B>
constexpr auto variation(lagrangian_density<F, A, B> const&) {
    return does_not_compile<
        "a variation is that of an action, as integral(L(q, Delta_plus[q]), T), and this is a Lagrangian without its integral", F>{};
}

} // namespace hilger
