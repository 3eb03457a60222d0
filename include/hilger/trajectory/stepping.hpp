// SPDX-License-Identifier: BSL-1.0
// The base of all methods, flows and compositions of flows: they offer memory<S, V> (trajectory/trajectory.hpp), and `along` makes
// trajectories from initial data.
#pragma once

#include <optional>
#include <tuple>
#include <utility>

#include "hilger/trajectory/initial_data.hpp"
#include "hilger/trajectory/trajectory.hpp"
#include "hilger/variational/check.hpp"

namespace hilger {

namespace detail {
/// The result of a refused `along`: an empty range, so that no other error follows.
template <class S, class V, class Scale>
struct refused_walk {
    Scale const& T;
    [[nodiscard]] state<S, V> const* begin() const { return nullptr; }
    [[nodiscard]] state<S, V> const* end() const { return nullptr; }
    [[nodiscard]] Scale const& scale() const { return T; }
};
template <class S, class V, class Scale>
refused_walk<S, V, Scale> no_walk(Scale const& T) {
    return {T};
}
} // namespace detail

/// See above. Method has memory<S, V>, momentum(t, q, v) and momentum_between(t, q0, q1, h).
template <class Method>
class stepping : public detail::along_in_braces_of<Method, 0, 2, 3, 4, 5, 6, Eigen::Dynamic> {
    template <class Scale>
    using scalar_on = typename Scale::root_type::scalar_type;

public:
    /// Also from initial data in braces: along(T, {.q0 = 1.0, .v0 = 0.0}).
    using detail::along_in_braces_of<Method, 0, 2, 3, 4, 5, 6, Eigen::Dynamic>::along;

    /// The states at the points of T, from (q0, p0) at its first one, computed one at a time during iteration. q0 and p0 are two numbers or
    /// two vectors of one length, or convert to such exactly (hilger/variational/given_state.hpp); states are of the kind of q0.
    /// @throws error::not_finite at once when q0 or p0 is not finite, error::mismatch when they have different lengths; during iteration, a
    /// step_failure with the last good state.
    template <time_scale_like Scale, class X, class Y>
    auto along(Scale const& T, X const& q0, Y const& p0) const {
        return make_trajectory<X, Y>(T, [&]<class V>(std::type_identity<V>) {
            return std::pair{detail::as_state<V>(q0), detail::as_state<V>(p0)};
        });
    }
    /// From other initial data: p0 = dL/dv(t_0, q0, v0), p0 itself, or p0 = -d_1 L_h(q0, q1). @throws as above, and where that momentum
    /// does not exist
    template <time_scale_like Scale, class W>
    auto along(Scale const& T, initial_velocity<W> const& from) const {
        return make_trajectory<W, W>(T, [&]<class V>(std::type_identity<V>) {
            V q0 = detail::as_state<V>(from.q0), v0 = detail::as_state<V>(from.v0);
            detail::require_same_dimension(q0, v0, "the initial position and velocity");
            V p0 = self().momentum(T.min(), q0, v0);
            if (detail::all_finite(q0) and detail::all_finite(v0) and not detail::all_finite(p0))
                error::raise<error::not_finite>("the momentum dL/dv at the initial position and velocity is NaN or infinity, and they are "
                                                "finite: L has none there");
            return std::tuple{std::move(q0), std::move(p0), std::move(v0)};
        });
    }
    template <time_scale_like Scale, class W>
    auto along(Scale const& T, initial_momentum<W> const& from) const {
        return along(T, from.q0, from.p0);
    }
    template <time_scale_like Scale, class W>
    auto along(Scale const& T, initial_positions<W> const& from) const {
        using root_scalar = scalar_on<Scale>;
        constexpr bool says_momentum = requires(Method const& m, root_scalar const& t) { m.momentum_between(t, t, t, t); };
        static_assert(says_momentum, "two positions say which momentum a step of an embedding begins with; with fractional damping, and of "
                                     "structures, a trajectory begins at {.q0 = ..., .v0 = ...}");
        if constexpr (says_momentum)
            return make_trajectory<W, W>(T, [&]<class V>(std::type_identity<V>) {
                scalar_on<Scale> const h = T.domain().base.step(T.root(), T.first());
                V q0 = detail::as_state<V>(from.q0), q1 = detail::as_state<V>(from.q1);
                detail::require_same_dimension(q0, q1, "the first two positions");
                V p0 = self().momentum_between(T.min(), q0, q1, h), v0 = (q1 - q0) / h;
                return std::tuple{std::move(q0), std::move(p0), std::move(v0)};
            });
        else
            return detail::no_walk<root_scalar, root_scalar>(T);
    }
    template <time_scale_like Scale, class X>
    auto along(Scale const& T, X const&) const {
        static_assert(not std::same_as<X, X>, "a walk starts from a position and a momentum, along(T, q0, p0), or from {.q0 = ..., .v0 = "
                                              "...}, or .p0 or .q1 in place of .v0");
        return detail::no_walk<scalar_on<Scale>, scalar_on<Scale>>(T);
    }
    template <class T, class... Data>
        requires(not time_scale_like<T> and sizeof...(Data) <= 2)
    auto along(T const& points, Data const&...) const {
        static_assert(not std::same_as<T, T>, "a walk goes along a time scale, as uniform(0.0, 0.1, 100) or time_scale{0.0, 0.1, 0.3}");
        return detail::no_walk<double, double>(points);
    }
    template <class Derived>
    auto along(scale_interface<Derived> const& T, detail::anything_in_braces const&) const {
        using S = scalar_on<Derived>;
        return detail::not_initial_data<Derived>(), detail::no_walk<S, S>(T);
    }
    template <class Derived>
    auto along(scale_interface<Derived> const& T, detail::any_ends_in_braces const&) const {
        using S = scalar_on<Derived>;
        static_assert(not std::same_as<S, S>,
                      "both ends say no step to begin with: solve(variation(S), T, {.q0 = ..., .qN = ...}) joins them");
        return detail::no_walk<S, S>(T);
    }
    /// The state after one step of length h, without memory of others. @throws error::no_convergence, error::singular, error::not_finite
    template <class S, class V>
    state<S, V> step(state<S, V> from, std::type_identity_t<S> const& h) const {
        typename Method::template memory<S, V> memory(self(), h, from.q);
        memory.advance(self(), from, h);
        return from;
    }

    /// The trajectory from a state. Methods with more conditions on T or the state have a function of this name.
    template <time_scale_like Scale, class V>
    auto start(Scale const& T, V q0, V p0) const {
        return trajectory<Method, Scale, V>(self(), T, std::move(q0), std::move(p0));
    }

private:
    /// The trajectory from the position and momentum, and perhaps velocity, that begin(type) makes of data of types X and Y; an empty one
    /// after a refusal in one sentence.
    template <class X, class Y, class Scale, class Begin>
    auto make_trajectory(Scale const& T, Begin const& begin) const {
        using S = scalar_on<Scale>;
        using V = detail::given_state_t<S, X>;
        using F = typename detail::mechanics_of<Method>::lagrangian;
        using Force = typename detail::mechanics_of<Method>::force;
        if constexpr (not detail::are_given_states<S, X, Y>())
            return detail::refuse_states<S, X, Y>(), detail::no_walk<S, V>(T);
        else if constexpr (not detail::is_lagrangian<F, S, V>() or not detail::is_force<Force, S, V>())
            return detail::refuse_mechanics<F, Force, S, V>(), detail::no_walk<S, V>(T);
        else {
            auto from = begin(std::type_identity<V>{});
            auto path = self().start(T, std::move(std::get<0>(from)), std::move(std::get<1>(from)));
            if constexpr (std::tuple_size_v<decltype(from)> == 3) path.starts_with(std::move(std::get<2>(from)));
            return path;
        }
    }
    [[nodiscard]] Method const& self() const { return static_cast<Method const&>(*this); }
};

} // namespace hilger
