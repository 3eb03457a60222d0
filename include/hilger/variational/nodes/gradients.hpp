// SPDX-License-Identifier: BSL-1.0
// First derivatives of a problem at one node, force included: all that iterations without Newton need.
#pragma once

#include "hilger/inlining.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger::detail {

/// Whether the problem takes the time.
template <class F, class Force, class S, class V>
inline constexpr bool is_timed = [] {
    using X = typename jets_for<V>::position;
    using Y = typename jets_for<V>::velocity;
    using Z = typename jets_for<V>::of_force;
    return std::invocable<F const&, S const&, X const&, Y const&> or std::invocable<Force const&, S const&, Z const&, Z const&> or
           requires(F const& f, S const& t, V const& x) {
        f.expand(t, x, x);
    };
}();

/// Whether L takes the time and cannot tell that it does not read it: a formula in text always takes it, and can tell.
template <class F, class S, class V>
inline constexpr bool always_reads_time = is_timed<F, no_force, S, V> and not requires(F const& f) {
    f.reads_time();
};
template <class S, class V, class F>
bool reads_time_in(F const& lagrangian) {
    if constexpr (requires { lagrangian.reads_time(); })
        return lagrangian.reads_time();
    else
        return is_timed<F, no_force, S, V>;
}

/// by_q = dL/dq + force and by_v = dL/dv at (t, q, v). @returns how L depends on q and v as far as this evaluation tells
template <class F, class Force, class S, class V>
HILGER_ALWAYS_INLINE inline dependence gradients_at(problem<F, Force> const& what, S const& t, V const& q, V const& v, V& by_q, V& by_v) {
    using s = shape<V>;
    dependence on{dependence::no_polynomial, dependence::no_polynomial, true};
    if constexpr (requires { what.lagrangian.gradients(t, q, v, by_q, by_v); })
        on = what.lagrangian.gradients(t, q, v, by_q, by_v);
    else if constexpr (requires { at_time{what.lagrangian, t}.expand(q, v); }) {
        auto const e = at_time{what.lagrangian, t}.expand(q, v);
        by_q = e.by_q;
        by_v = e.by_v;
        on = e.on;
    } else if constexpr (s::size != Eigen::Dynamic and s::size <= one_evaluation) {
        [&]<int... K>(std::integer_sequence<int, K...> all) HILGER_ALWAYS_INLINE {
            std::array<S, sizeof...(K)> const x{s::component(q, K)...}, y{s::component(v, K)...};
            auto const z = jets_of<1, s::is_scalar>(at_time{what.lagrangian, t}, x, y, all);
            ((s::component(by_q, K) = z.template by<K>(), s::component(by_v, K) = z.template by<s::size + K>()), ...);
            on = z.on;
        }
        (std::make_integer_sequence<int, s::size>{});
    } else {
        by_q = gradient_first(at_time{what.lagrangian, t}, q, v);
        by_v = gradient_second(at_time{what.lagrangian, t}, q, v);
    }
    if constexpr (not std::same_as<Force, no_force>) by_q = by_q + force_at(what.force, t, q, v);
    return on;
}

} // namespace hilger::detail
