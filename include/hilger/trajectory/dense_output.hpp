// SPDX-License-Identifier: BSL-1.0
// States between the points of a trajectory, as accurate as the points: steps of its method from the point before (partial_step.hpp).
// For recorded states without a method, and for flows with a history, which is in no state: the cubic Hermite polynomial in t through (q,
// p) at both ends of a step, with the slopes of the continuous system, q' = dH/dp = v and p' = dL/dq(q, v) + forces, among them the one of
// the history. Its own error is of order 4 in the step (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section II.6);
// the error of the points adds to it.
#pragma once

#include <algorithm>
#include <functional>

#include "hilger/trajectory/partial_step.hpp"
#include "hilger/trajectory/recording.hpp"
#include "hilger/variational/legendre.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger {

/// q' and p' of the continuous system.
template <class V>
struct slopes {
    V q, p;
};

namespace detail {
/// The slopes at a state of the problem, by kept derivatives; `near` selects a velocity where several have its momentum.
template <class F, class Force, class S, class V>
slopes<V> slopes_by(kept_derivatives<problem<F, Force>> const& kept, state<S, V> const& x, V const& near) {
    V v = velocity_by(kept, x.t, x.q, x.p, near);
    V p = [&] {
        if constexpr (is_traced_at<problem<F, Force>, V>)
            return kept.by_q(x.t, x.q, v);
        else if constexpr (shape<V>::size != Eigen::Dynamic and shape<V>::size <= one_evaluation)
            return expand_at(kept.what(), x.t, x.q, v).e.by_q; // one evaluation, instantiated by the step already
        else {
            V by_q = gradient_first(at_time{kept.what().lagrangian, x.t}, x.q, v);
            if constexpr (not std::same_as<Force, no_force>) by_q += evaluated(at_time{kept.what().force, x.t}(x.q, v));
            return by_q;
        }
    }();
    return {std::move(v), std::move(p)};
}
/// Refused: the force of a history is not in the state.
template <class Damped, class S, class V>
    requires requires(Damped const& d) { d.mechanics, d.damping; }
slopes<V> slopes_by(kept_derivatives<Damped> const&, state<S, V> const& x, V const&) {
    static_assert(sizeof(Damped) == 0, "the slopes of a flow with fractional damping come from its history: give dense_output the path, "
                                       "dense_output(flow.along(T, q0, p0))");
    return {x.q, x.p};
}
} // namespace detail

/// The slopes at a state of the problem. @throws error::singular, error::no_convergence where the Legendre map has no inverse
template <class Problem, class S, class V>
slopes<V> slopes_at(Problem const& mechanics, state<S, V> const& x) {
    return detail::slopes_by(detail::kept_derivatives(mechanics), x, zero_like(x.q));
}

namespace detail {

struct no_derivatives {};
/// The kept derivatives of the undamped problem of a method with a history, for slopes; nothing for other methods.
template <class Method>
auto derivatives_of(Method const& method) {
    if constexpr (has_history<Method>) {
        constexpr bool is_damped = requires { method.undamped(); };
        static_assert(is_damped, "events and dense output are for flows of Lagrangians, damped or not, and not for Newmark's scheme, whose "
                                 "forces are no function of a state");
        return kept_derivatives(method.undamped().mechanics());
    } else
        return no_derivatives{};
}
/// The slopes at x, the current state of an iterator or with `back` the one before, with the force of a history.
template <class Walk, class Kept, class State, class V>
auto slopes_on(Walk const& walk, Kept const& kept, State const& x, V const& near, bool back) {
    auto result = slopes_by(kept, x, near);
    if constexpr (requires { walk.remembered().damping_force(back); }) result.p = result.p + walk.remembered().damping_force(back);
    return result;
}

} // namespace detail

/// The cubic Hermite interpolant in (q, p) between two neighbouring states.
template <class S, class V>
class dense_step {
public:
    dense_step(state<S, V> from, slopes<V> slopes_from, state<S, V> to, slopes<V> slopes_to)
        : a_(std::move(from)), b_(std::move(to)), da_(std::move(slopes_from)), db_(std::move(slopes_to)) {}
    template <class Mechanics>
    dense_step(Mechanics const& mechanics, state<S, V> const& from, state<S, V> const& to)
        : dense_step(detail::kept_derivatives(mechanics), from, to) {}
    template <class Problem>
    dense_step(detail::kept_derivatives<Problem> const& kept, state<S, V> const& from, state<S, V> const& to)
        : dense_step(from, detail::slopes_by(kept, from, detail::mean_velocity(from, to)), to,
                     detail::slopes_by(kept, to, detail::mean_velocity(from, to))) {}

    /// The state at t, the given ones exactly at the ends. @throws error::outside_domain
    [[nodiscard]] state<S, V> operator()(S const& t) const {
        if (not(std::min(a_.t, b_.t) <= t) or not(t <= std::max(a_.t, b_.t))) // NaN is outside too
            error::raise<error::outside_domain>(t, " is outside the step from ", a_.t, " to ", b_.t);
        state<S, V> y = at_fraction(S((t - a_.t) / (b_.t - a_.t)));
        y.t = t;
        return y;
    }
    /// The state at (1 - x) t_i + x t_{i+1}, 0 <= x <= 1: q and p do not depend on the rounding of t.
    [[nodiscard]] state<S, V> at_fraction(S const& x) const {
        if (x == S(1)) return b_;
        S const h = b_.t - a_.t;
        S const t = a_.t + x * h;
        return {h < S(0) ? std::max(t, b_.t) : std::min(t, b_.t), between(a_.q, da_.q, b_.q, db_.q, h, x),
                between(a_.p, da_.p, b_.p, db_.p, h, x)};
    }

private:
    static V between(V const& a, V const& da, V const& b, V const& db, S const& h, S const& x) {
        S const y = S(1) - x;
        return V(a + (b - a) * S(x * x * (S(3) - S(2) * x)) + (da * S(y * y * x * h) - db * S(x * x * y * h)));
    }
    state<S, V> a_, b_;
    slopes<V> da_, db_;
};

/// The states of a trajectory, which is computed for it, or of recorded states of a flow without a history: dense_output(path),
/// dense_output(flow.mechanics(), states).
template <class S, class V>
class dense_output {
    using at = state<S, V>;

public:
    /// States in the order of time, two at least. @throws error::mismatch for fewer, and as slopes_at does
    template <class Mechanics>
    dense_output(Mechanics const& mechanics, std::vector<state<S, V>> states) : states_(std::move(states)) {
        if (states_.size() < 2)
            error::raise<error::mismatch>("states are interpolated between two at least, and there are ", states_.size());
        std::vector<slopes<V>> all;
        detail::kept_derivatives const kept(mechanics);
        for (std::size_t i = 0; i < states_.size(); ++i) {
            std::size_t const before = i == 0 ? 0 : i - 1;
            all.push_back(detail::slopes_by(kept, states_[i], detail::mean_velocity(states_[before], states_[before + 1])));
        }
        interpolate(std::move(all));
    }
    /// @throws as the trajectory does, and slopes_at where there is a history
    template <class Path>
        requires requires(Path const& path) { path.begin(), path.method(); }
    explicit dense_output(Path const& path) {
        using method = std::remove_cvref_t<decltype(path.method())>;
        if constexpr (detail::has_history<method>) {
            auto const kept = detail::derivatives_of(path.method());
            std::vector<slopes<V>> all;
            auto x = path.begin();
            states_.push_back(*x);
            for (++x; not(x == path.end()); ++x) {
                V const near = detail::mean_velocity(states_.back(), *x);
                if (all.empty()) all.push_back(detail::slopes_on(x, kept, states_.back(), near, true));
                all.push_back(detail::slopes_on(x, kept, *x, near, false));
                states_.push_back(*x);
            }
            interpolate(std::move(all));
        } else {
            for (auto const& x : path) states_.push_back(x);
            inside_ = [flow = path.method()](std::size_t, at const& x, at const& y, S const& t) {
                return state_at(flow, x, t, detail::mean_velocity(x, y));
            };
        }
    }
    /// @throws error::outside_domain when t is before the first state or after the last; what a step throws.
    [[nodiscard]] state<S, V> operator()(S const& t) const {
        if (not(states_.front().t <= t) or not(t <= states_.back().t))
            error::raise<error::outside_domain>(t, " is outside the interval [", states_.front().t, ", ", states_.back().t, "]");
        auto const after = std::upper_bound(states_.begin() + 1, states_.end() - 1, t, [](S const& s, auto const& x) { return s < x.t; });
        at const &x = *(after - 1), &y = *after;
        return t == y.t ? y : t == x.t ? x : inside_(static_cast<std::size_t>(after - states_.begin()) - 1, x, y, t);
    }

private:
    void interpolate(std::vector<slopes<V>> all) {
        inside_ = [all = std::move(all)](std::size_t i, at const& x, at const& y, S const& t) {
            return dense_step<S, V>(x, all[i], y, all[i + 1])(t);
        };
    }
    std::vector<at> states_;
    std::function<at(std::size_t, at const&, at const&, S const&)> inside_; ///< step i, from x to y, at t
};
template <class Path>
dense_output(Path const& path) -> dense_output<decltype((*path.begin()).t), decltype((*path.begin()).q)>;

} // namespace hilger
