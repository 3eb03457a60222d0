// SPDX-License-Identifier: BSL-1.0
// Which branches a callable took. A Lagrangian may compare its arguments, q(0) < 0 ? a : b, or take the larger of two: it is then one
// formula on each of its branches, and what is concluded from one formula - that a Newton iteration is done, that an equation is linear,
// that a mass is constant - holds where the same branches are taken. Comparisons of jets therefore write down how they came out, on the
// thread that makes them. Nothing else writes there: of a callable that compares nothing a compiler sees that nothing has changed.
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

/// Writes a comparison down. @returns its outcome
HILGER_ALWAYS_INLINE constexpr bool compared(bool outcome, bool of_velocity) {
    if (not std::is_constant_evaluated()) {
        comparisons& all = comparisons_of_this_thread;
        ++all.made;
        if (of_velocity) ++all.of_velocity;
        all.outcomes = all.outcomes * outcome_base + (outcome ? 2 : 1);
    }
    return outcome;
}

/// -0 has a sign too.
template <class S>
constexpr bool has_minus_sign(S const& x) {
    if constexpr (std::is_floating_point_v<S>)
        return std::signbit(x);
    else
        return x < S(0);
}

/// What is compared.
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

/// How many comparisons there were. One number, and not the three above: that it has not changed is then seen by a compiler too.
HILGER_ALWAYS_INLINE inline std::uint64_t comparisons_made() { return comparisons_of_this_thread.made; }

HILGER_ALWAYS_INLINE inline std::uint64_t comparisons_of_velocity() { return comparisons_of_this_thread.of_velocity; }

/// How the comparisons of one evaluation came out. Two evaluations of a callable with equal paths took the same branches.
struct branch_path {
    std::uint64_t made = 0, outcomes = 0;
    friend constexpr bool operator==(branch_path const&, branch_path const&) = default;
};

/// Looks at what is compared from here on.
class branch_watch {
public:
    branch_watch() : before_(comparisons_of_this_thread) {}
    /// Whether anything was.
    [[nodiscard]] bool saw_any() const { return comparisons_made() != before_.made; }
    [[nodiscard]] branch_path path() const {
        branch_path p{comparisons_of_this_thread.made - before_.made, 0};
        std::uint64_t earlier = before_.outcomes, base = outcome_base; // what is left of the earlier ones is before_ * base^made
        for (std::uint64_t n = p.made; n > 0; n >>= 1, base *= base)
            if (n & 1) earlier *= base;
        p.outcomes = comparisons_of_this_thread.outcomes - earlier;
        return p;
    }
    /// Forgets what was compared: it is no part of the evaluation in which it happened.
    void forget() const { comparisons_of_this_thread = before_; }

private:
    comparisons before_;
};

/// Comparisons inside do not count: those of an iteration whose result alone an evaluation depends on.
struct unwatched {
    branch_watch before{};
    unwatched() = default;
    unwatched(unwatched const&) = delete;
    unwatched& operator=(unwatched const&) = delete;
    ~unwatched() { before.forget(); }
};

} // namespace hilger::detail
