// SPDX-License-Identifier: BSL-1.0
// Adds the increments of a step to the state: plainly, or compensated, with the rounding error carried to the next increment (Kahan, in the
// form that is exact for every two summands).
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "hilger/error_free.hpp"
#include "hilger/inlining.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/state.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger {

/// Summation of the steps of a flow. `compensated` is the argument that selects the second.
enum class sums { plain, compensated };
inline constexpr std::integral_constant<sums, sums::compensated> compensated{};

} // namespace hilger

namespace hilger::detail {

/// For states of dimension N, or Eigen::Dynamic.
template <bool Compensated, class S, int N>
struct summation {
    constexpr explicit summation(int = N) {}
    HILGER_ALWAYS_INLINE static void add(S& x, S const& increment, int) { x = x + increment; }
    template <class Visit>
    static void visit(Visit&) {}
};

template <class S, int N>
struct summation<true, S, N> {
    std::conditional_t<N == Eigen::Dynamic, std::vector<S>, std::array<S, static_cast<std::size_t>(N < 0 ? 1 : N)>> rest{};

    explicit summation(int d = N) {
        if constexpr (N == Eigen::Dynamic) rest.assign(static_cast<std::size_t>(d), S(0));
    }
    HILGER_ALWAYS_INLINE void add(S& x, S const& increment, int k) {
        S& carry = rest[static_cast<std::size_t>(k)];
        two_sum(x, S(increment + carry), x, carry);
    }
    /// The same for an increment in two parts, the second being the rounding error of the first.
    HILGER_ALWAYS_INLINE void add(S& x, S const& increment, S const& more, int k) {
        S& carry = rest[static_cast<std::size_t>(k)];
        S sum{}, cut{};
        two_sum(increment, S(carry + more), sum, cut);
        two_sum(x, sum, x, carry);
        carry = carry + cut;
    }
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        for (S& carry : rest) each("carry", carry);
    }
};

/// x with another first component.
template <class S, class V>
V with_first(V x, S const& other) {
    shape<V>::component(x, 0) = other;
    return x;
}

/// Sums of positions and of momenta.
template <bool Compensated, class S, class V>
class state_sums {
    using s = shape<V>;

public:
    explicit state_sums(int d) : q_(d), p_(d) {}
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        q_.visit(each);
        p_.visit(each);
    }
    /// Makes x the state after a step of length h: q + moved, p + gained, of d numbers each. @throws error::not_finite, with x unchanged
    template <class Moved, class Gained>
    void add(state<S, V>& x, S const& h, Moved const& moved, Gained const& gained, char const* name) {
        require_finite(x, moved, gained, name);
        if constexpr (not Compensated and not s::is_scalar) {
            x.q += moved;
            x.p += gained;
        } else
            for (int c = 0; c < s::dimension(x.q); ++c) {
                q_.add(s::component(x.q, c), S(component_of(moved, c)), c);
                p_.add(s::component(x.p, c), S(component_of(gained, c)), c);
            }
        x.t = x.t + h;
    }
    /// The same for increments of q in two parts, moved(c) for component c, the second being the rounding error of the first.
    template <class Moved, class Gained>
    void add_in_parts(state<S, V>& x, S const& h, Moved const& moved, Gained const& gained) {
        for (int c = 0; c < s::dimension(x.q); ++c) {
            auto const [increment, more] = moved(c);
            q_.add(s::component(x.q, c), increment, more, c);
            p_.add(s::component(x.p, c), S(component_of(gained, c)), c);
        }
        x.t = x.t + h;
    }
    /// @throws error::not_finite if the increments lead beyond the largest number
    template <class Moved, class Gained>
    static void require_finite(state<S, V> const& x, Moved const& moved, Gained const& gained, char const* name) {
        if constexpr (std::numeric_limits<S>::is_exact) return;
        // infinity less itself is NaN, and so is the sum; if only the sum overflows, the components are checked
        if (is_finite(total(x, moved, gained))) [[likely]]
            return;
        for (int c = 0; c < s::dimension(x.q); ++c) {
            S const q = s::component(x.q, c) + component_of(moved, c), p = s::component(x.p, c) + component_of(gained, c);
            if (not is_finite(q) or not is_finite(p))
                throw_newton_failure(name, newton_outcome::not_finite, x.q, with_first(x.q, S((q - q) + (p - p))));
        }
    }

private:
    /// The sum of all positions and momenta after the step.
    template <class Moved, class Gained>
    static S total(state<S, V> const& x, Moved const& moved, Gained const& gained) {
        if constexpr (s::size == Eigen::Dynamic)
            return S(((x.q + moved) + (x.p + gained)).sum());
        else {
            S sum(0); // one by one: a vector load right after scalar stores would stall
            for (int c = 0; c < s::size; ++c)
                sum = sum + ((s::component(x.q, c) + component_of(moved, c)) + (s::component(x.p, c) + component_of(gained, c)));
            return sum;
        }
    }
    [[no_unique_address]] summation<Compensated, S, s::size> q_;
    [[no_unique_address]] summation<Compensated, S, s::size> p_;
};

} // namespace hilger::detail
