// SPDX-License-Identifier: BSL-1.0
// A point of a trajectory, and the errors that report where it ended.
#pragma once

#include <exception>
#include <memory>
#include <sstream>
#include <string>

#include "hilger/shape.hpp"

namespace hilger {

/// A point of a trajectory: time, position, momentum.
template <class S, class V>
struct state {
    S t;
    V q;
    V p;
    friend bool operator==(state const&, state const&) = default;
};

/// The point where a trajectory stopped: the states up to `last` are valid.
template <class S, class V>
class interrupted {
    // Exceptions are aligned to 16 bytes at least, and AVX registers want 32: the state is allocated apart.
    std::shared_ptr<state<S, V> const> kept_;

public:
    explicit interrupted(state<S, V> reached) : kept_(std::make_shared<state<S, V> const>(std::move(reached))), last(*kept_) {}
    state<S, V> const& last;
};

/// A failed step, as its error (no_convergence, no_branch, singular, not_finite, outside_domain) and as interrupted<S, V>. The Newton
/// iterate and its residual, if any, are in the nested exception (std::rethrow_if_nested).
template <class Cause, class S, class V>
struct step_failure : Cause, interrupted<S, V> {
    step_failure(std::string const& what, state<S, V> reached) : Cause(what), interrupted<S, V>(std::move(reached)) {}
};

namespace detail {

/// The mean velocity between two states.
template <class S, class V>
V mean_velocity(state<S, V> const& x, state<S, V> const& y) {
    return (y.q - x.q) / S(y.t - x.t);
}

template <class Cause, class S, class V>
[[noreturn, gnu::noinline, gnu::cold]] void stop_at(state<S, V> const& at, S const& h, Cause const& cause) {
    std::ostringstream message;
    message << "the step from t = " << at.t << " with h = " << h << " failed: " << cause.what();
    std::throw_with_nested(step_failure<Cause, S, V>(message.str(), at));
}

/// Rethrows the current exception as a step_failure.
template <class S, class V>
[[noreturn, gnu::noinline, gnu::cold]] void stop_at(state<S, V> const& at, S const& h) {
    try {
        throw;
    } catch (error::no_branch const& cause) {
        stop_at(at, h, cause);
    } catch (error::no_convergence const& cause) {
        stop_at(at, h, cause);
    } catch (error::singular const& cause) {
        stop_at(at, h, cause);
    } catch (error::not_finite const& cause) {
        stop_at(at, h, cause);
    } catch (error::outside_domain const& cause) { // more steps than the history has room for
        stop_at(at, h, cause);
    }
}

} // namespace detail

/// Returns work(), the step from `at` with length h. @throws step_failure of the error thrown by work
template <class S, class V, class Work>
decltype(auto) saying_where(state<S, V> const& at, S const& h, Work const& work) {
    try {
        return work();
    } catch (...) {
        detail::stop_at(at, h);
    }
}

} // namespace hilger
