// SPDX-License-Identifier: BSL-1.0
// How the increments of a step are added to the state: as they are, or compensated, where what rounding cuts off is kept and added with the
// next increment (Kahan, in the form that is exact for every two summands).
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "hilger/error_free.hpp"
#include "hilger/inlining.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/state.hpp"

namespace hilger {

/// How a flow adds up its steps.
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
    /// The same of an increment in two parts, of which the second was cut off of the first.
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

/// x, of which the first component is another number.
template <class S, class V>
V with_first(V x, S const& other) {
    shape<V>::component(x, 0) = other;
    return x;
}

/// What a step adds to positions and momenta.
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
    /// The state after a step whose equation is solved. @throws error::not_finite, and x is as it was
    template <class Equation>
    void add(Equation const& e, state<S, V>& x, char const* name) {
        // infinity less itself is NaN, and so is the sum; where the sum alone overflows it is looked at again
        if (not is_finite(all_of(e, x))) [[unlikely]]
            refuse_overflow(e, x, name);
        if constexpr (not Compensated and not s::is_scalar and Equation::ends_alone)
            x.q += e.moved;
        else
            for (int c = 0; c < e.dimension(); ++c) q_.add(s::component(x.q, c), e.end(c), c);
        if (not e.adds_up)
            for (int c = 0; c < e.dimension(); ++c) s::component(x.p, c) = e.whole(c);
        else if constexpr (not Compensated and not s::is_scalar)
            x.p += e.increment;
        else
            for (int c = 0; c < e.dimension(); ++c) p_.add(s::component(x.p, c), e.increment(c), c);
        x.t = x.t + e.h();
    }

private:
    /// The sum of all positions and momenta after the step.
    template <class Equation>
    static S all_of(Equation const& e, state<S, V> const& x) {
        if constexpr (s::size == Eigen::Dynamic and Equation::ends_alone)
            if (e.adds_up) return total_in_rows(x.q, e.moved, x.p, e.increment);
        return S(all_moved(e, x) + (e.adds_up ? total(x.p, e.increment) : total(e.whole, e.whole)));
    }
    /// The sum of all positions after the step.
    template <class Equation>
    static S all_moved(Equation const& e, state<S, V> const& x) {
        if constexpr (Equation::ends_alone)
            return total(x.q, e.moved);
        else
            return total(x.q, x.q) + e.moved.sum();
    }
    /// The sum of all components of four long vectors: several sums at once, for each addition waits for the one before it.
    template <class A, class B, class C, class D>
    static S total_in_rows(A const& a, B const& b, C const& c, D const& d) {
        constexpr Eigen::Index at_once = 8;
        Eigen::Index const n = a.size(), rest = n % at_once;
        Eigen::Array<S, at_once, 1> sums = Eigen::Array<S, at_once, 1>::Zero();
        auto const part = [](auto const& x, Eigen::Index k) { return x.template segment<at_once>(k).array(); };
        for (Eigen::Index k = 0; k < n - rest; k += at_once) sums += (part(a, k) + part(b, k)) + (part(c, k) + part(d, k));
        S sum = sums.sum();
        for (Eigen::Index k = n - rest; k < n; ++k) sum = sum + ((a(k) + b(k)) + (c(k) + d(k)));
        return sum;
    }
    /// @throws error::not_finite, unless it was the sum alone that overflowed
    template <class Equation>
    [[gnu::noinline, gnu::cold]] static void refuse_overflow(Equation const& e, state<S, V> const& x, char const* name) {
        for (int c = 0; c < e.dimension(); ++c) {
            S const q = s::component(x.q, c) + e.end(c), p = e.adds_up ? S(s::component(x.p, c) + e.increment(c)) : S(e.whole(c));
            if (not is_finite(q) or not is_finite(p))
                throw_newton_failure(name, newton_outcome::not_finite, x.q, with_first(x.q, S((q - q) + (p - p))));
        }
    }
    template <class X>
    static S const& component(X const& x, int c) {
        if constexpr (std::same_as<X, S>)
            return x;
        else
            return x(c);
    }
    /// The sum of all components of x and y, of which one may be a number and the other a vector of one.
    template <class X, class Y>
    static S total(X const& x, Y const& y) {
        if constexpr (s::size == Eigen::Dynamic)
            return S((x + y).sum());
        else {
            S sum(0); // one by one: a vector of numbers that were just written one by one would wait for them
            for (int c = 0; c < s::size; ++c) sum = sum + (component(x, c) + component(y, c));
            return sum;
        }
    }
    [[no_unique_address]] summation<Compensated, S, s::size> q_;
    [[no_unique_address]] summation<Compensated, S, s::size> p_;
};

} // namespace hilger::detail
