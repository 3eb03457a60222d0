// SPDX-License-Identifier: BSL-1.0
// The branches taken by a callable. A Lagrangian may compare its arguments, q(0) < 0 ? a : b, or take the larger of two: each branch is a
// formula, and a conclusion from it - a Newton iteration is done, an equation is linear, a mass is constant - holds only if the same
// branches are taken. Comparisons of jets therefore record their outcomes, on the thread that makes them. Nothing else writes there: if a
// callable compares nothing, a compiler sees that nothing has changed.
#pragma once

#include <cmath>
#include <cstdint>
#include <type_traits>

#include "hilger/inlining.hpp"

namespace hilger::detail {

/// The comparisons of jets so far: how many, how many of them looked at a velocity, and their outcomes in order, as one number.
struct comparisons {
    std::uint64_t made = 0, of_velocity = 0, outcomes = 0;
};
inline constexpr std::uint64_t outcome_base = 0xd1342543de82ef95u; // odd, so that powers of it have inverses

inline constinit thread_local comparisons comparisons_of_this_thread{};

/// Records a comparison. @returns its outcome
HILGER_ALWAYS_INLINE constexpr bool compared(bool outcome, bool of_velocity) {
    if (not std::is_constant_evaluated()) {
        comparisons& all = comparisons_of_this_thread;
        ++all.made;
        if (of_velocity) ++all.of_velocity;
        all.outcomes = all.outcomes * outcome_base + (outcome ? 2 : 1);
    }
    return outcome;
}

/// -0 is negative, too.
template <class S>
constexpr bool has_minus_sign(S const& x) {
    if constexpr (std::is_floating_point_v<S>)
        return std::signbit(x);
    else
        return x < S(0);
}

/// Kinds of comparisons.
enum class relation : std::uint8_t { equal, less, less_or_equal, signs_differ };
template <class S>
HILGER_ALWAYS_INLINE constexpr bool holds(relation how, S const& x, S const& y) {
    switch (how) {
    case relation::equal:
        return x == y;
    case relation::less:
        return x < y;
    case relation::less_or_equal:
        return x <= y;
    case relation::signs_differ:
        break;
    }
    return has_minus_sign(x) != has_minus_sign(y);
}

/// Number of comparisons so far. One number, not the three above: a compiler, too, then sees that it has not changed.
HILGER_ALWAYS_INLINE inline std::uint64_t comparisons_made() { return comparisons_of_this_thread.made; }

HILGER_ALWAYS_INLINE inline std::uint64_t comparisons_of_velocity() { return comparisons_of_this_thread.of_velocity; }

/// The outcomes of the comparisons of one evaluation. Evaluations of a callable with equal paths took the same branches.
struct branch_path {
    std::uint64_t made = 0, outcomes = 0;
    friend constexpr bool operator==(branch_path const&, branch_path const&) = default;
};

/// Observes the comparisons from here on.
class branch_watch {
public:
    branch_watch() : before_(comparisons_of_this_thread) {}
    [[nodiscard]] bool saw_any() const { return comparisons_made() != before_.made; }
    [[nodiscard]] branch_path path() const {
        branch_path p{comparisons_of_this_thread.made - before_.made, 0};
        std::uint64_t earlier = before_.outcomes, base = outcome_base; // the earlier ones contribute before_ * base^made
        for (std::uint64_t n = p.made; n > 0; n >>= 1, base *= base)
            if (n & 1) earlier *= base;
        p.outcomes = comparisons_of_this_thread.outcomes - earlier;
        return p;
    }
    /// Removes the comparisons from the record: they are no part of the enclosing evaluation.
    void forget() const { comparisons_of_this_thread = before_; }

private:
    comparisons before_;
};

/// Suspends recording: for an iteration of which only the result enters an evaluation.
struct unwatched {
    branch_watch before{};
    unwatched() = default;
    unwatched(unwatched const&) = delete;
    unwatched& operator=(unwatched const&) = delete;
    ~unwatched() { before.forget(); }
};

} // namespace hilger::detail
