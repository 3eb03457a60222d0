// SPDX-License-Identifier: BSL-1.0
// The state between two points of a trajectory: a shorter step of its method from the point before, with the order of the method.
#pragma once

#include <limits>
#include <optional>
#include <type_traits>

#include "hilger/scalar.hpp"
#include "hilger/trajectory/trajectory.hpp"

namespace hilger {

namespace detail {

/// The state a length behind x, with a copy of the memory. From another start or of another length, a step may be too long for Newton's
/// method: then it is divided, into eight at most. @throws step_failure
template <class Method, class Memory, class S, class V>
state<S, V> partial_step(Method const& method, Memory const& memory, state<S, V> const& x, S const& length) {
    for (int parts = 1;; parts *= 2) {
        try {
            S const h = length / S(parts);
            Memory own = memory;
            state<S, V> y = x;
            for (int k = 0; k < parts; ++k) saying_where(y, h, [&] { own.advance(method, y, h); });
            return y;
        } catch (error::no_convergence const&) {
            if (parts == 8) throw;
        }
    }
}

} // namespace detail

/// The state of a method at t, by a step from x: where several velocities have its momentum, with the one near that given. @throws
/// step_failure
template <class Method, class S, class V>
state<S, V> state_at(Method const& method, state<S, V> const& x, S const& t, std::type_identity_t<std::optional<V>> const& near = {}) {
    static_assert(not detail::has_history<Method>, "a step of a flow with a history begins at no state alone");
    S const length = t - x.t;
    state<S, V> y = x;
    if (S(1024) * S((std::numeric_limits<S>::min)()) < magnitude(length)) { // others have no inverse
        typename Method::template memory<S, V> memory(method, length, x.q);
        if constexpr (requires { memory.start_with(method, x, *near); })
            if (near) memory.start_with(method, x, *near);
        y = detail::partial_step(method, memory, x, length);
    }
    y.t = t;
    return y;
}

} // namespace hilger
