// SPDX-License-Identifier: BSL-1.0
// A walk goes on with the numbers of what was remembered, and not with what the memory knew of its problem: masses, dampings and methods of
// one type have other numbers in another trajectory. What is remembered of the problem itself, as the force at the last point, is seen in
// the next step.
#pragma once

#include <optional>
#include <type_traits>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/step/state.hpp"

namespace hilger::detail {

/// Whether a step from `start` leads to b as it led to a, but for what compilers make different of the same formula.
template <class V>
bool is_the_same(V const& start, V const& a, V const& b) {
    using S = scalar_of<V>;
    S const change = magnitude(V(a - start)), size = std::max(S(magnitude(a)), S(magnitude(start)));
    return not(S(square_root_of_epsilon<S>() * change + S(64) * epsilon<S>() * size) < S(magnitude(V(a - b))));
}

/// The numbers of a memory, in the order in which it shows them: written first, and read once.
template <class S>
class numbers_of_memory {
public:
    struct writer {
        numbers_of_memory& to;
        template <class X>
        void operator()(char const*, X const& x) {
            to.of<X>().push_back(static_cast<kept<X>>(x));
        }
    };
    struct reader {
        numbers_of_memory& from;
        std::size_t whole = 0, real = 0, wide = 0;
        template <class X>
        void operator()(char const*, X& x) {
            std::size_t& next = std::is_integral_v<X> ? whole : std::is_same_v<X, S> ? wide : real;
            auto const& all = from.of<X>();
            if (next == all.size()) refuse();
            x = static_cast<X>(all[next++]);
        }
        /// That all were read. @throws error::mismatch
        void require_end() const {
            if (whole != from.whole_.size() or real != from.real_.size() or wide != from.wide_.size()) refuse();
        }
    };

private:
    [[noreturn]] static void refuse() {
        error::raise<error::mismatch>("a trajectory resumes from a checkpoint of its own method, and the one of this checkpoint remembers "
                                      "another number of values: it had another history or order, or was made for other numbers of steps");
    }
    template <class X>
    using kept = std::conditional_t<std::is_integral_v<X>, long long, X>;
    template <class X>
    auto& of() {
        if constexpr (std::is_integral_v<X>)
            return whole_;
        else if constexpr (std::is_same_v<X, S>)
            return wide_;
        else {
            static_assert(std::is_same_v<X, double>, "a memory shows whole numbers, numbers of its scalar, and double");
            return real_;
        }
    }
    std::vector<long long> whole_;
    std::vector<double> real_;
    std::vector<S> wide_;
};

/// What a trajectory of `method` remembers where another memory does, as far as it shows it.
template <class S, class V, class Memory, class Method>
Memory taken_over(Memory from, Method const& method, S const& h, V const& like) {
    if constexpr (requires(typename numbers_of_memory<S>::writer each) { from.visit(method, each); }) {
        numbers_of_memory<S> numbers;
        typename numbers_of_memory<S>::writer write{numbers};
        from.visit(method, write);
        Memory own(method, h, like);
        typename numbers_of_memory<S>::reader read{numbers};
        own.visit(method, read);
        read.require_end();
        return own;
    } else
        return from;
}
/// That a step of length h leads where another memory leads that knows more, or nothing, of another problem. @throws error::mismatch
template <class S, class V, class Method, class Memory, class Other>
void require_same_step(Memory remembered, Other const& other, Method const& method, state<S, V> const& at, S const& h) {
    std::optional<state<S, V>> with, without;
    try {
        state<S, V> x = at;
        remembered.advance(method, x, h);
        with = x;
        Memory another = other(at, x);
        x = at;
        another.advance(method, x, h);
        without = x;
    } catch (std::exception const&) { // then it tells nothing
    }
    if (without and not(is_the_same(at.q, with->q, without->q) and is_the_same(at.p, with->p, without->p)))
        error::raise<error::mismatch>(
            "a trajectory resumes from a checkpoint of its own problem and method, and a step from this one, at t = ", at.t,
            ", leads elsewhere. With another Lagrangian, force or damping a new trajectory begins at that "
            "state");
}
/// That a step of length h with what is remembered leads where one without it does. @throws error::mismatch
template <class S, class V, class Memory, class Method>
void require_its_own(Memory const& remembered, Method const& method, state<S, V> const& at, S const& h) {
    require_same_step(
        remembered,
        [&](state<S, V> const& from, state<S, V> const& to) {
            Memory nothing(method, h, from.q);
            if constexpr (requires(V const& v) { nothing.start_with(method, from, v); })
                nothing.start_with(method, from, mean_velocity(from, to));
            return nothing;
        },
        method, at, h);
}

} // namespace hilger::detail
