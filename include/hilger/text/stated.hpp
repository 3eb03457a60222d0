// SPDX-License-Identifier: BSL-1.0
// A formula in text with the meaning of its names.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hilger/function_view.hpp"
#include "hilger/text/vocabulary.hpp"

namespace hilger::text {

/// The components of a position or a velocity: q(k) is component k.
template <class T>
using components_view = hilger::detail::function_view<T(int)>;

/// A formula with the meaning of its names; copies share both. It has values in float, double, long double, float50, float100 and Q, and in
/// traced numbers of these, compiled in hilger::text.
class stated {
public:
    /// @throws error::unreadable with the place of an unknown name, a vector without an index, an index outside of its vector, or a
    /// function with a wrong number of arguments
    stated(expression what, std::shared_ptr<vocabulary const> words, std::string source);

    /// The value at (t, q, v), states given by component: q(k) is component k. With `everywhere` both parts of choices are evaluated.
    template <class T, class Q, class V>
    T value(T const& t, Q const& q, V const& v, bool everywhere = false) const {
        return evaluate<T>(
            t, [&](int k) { return T(q(k)); }, [&](int k) { return T(v(k)); }, everywhere);
    }
    [[nodiscard]] vocabulary const& words() const { return *words_; }
    [[nodiscard]] expression const& formula() const { return what_; }
    /// Whether it contains a name of this role.
    [[nodiscard]] bool reads(meaning::role role) const;
    /// Whether its value depends on the time or the state.
    [[nodiscard]] bool reads_state() const {
        return reads(meaning::role::time) or reads(meaning::role::position) or reads(meaning::role::velocity);
    }
    /// The value of a formula without time and state. @throws error::unreadable if S has no such number, as a root in rationals or 1/0
    template <class S>
    [[nodiscard]] S number() const;
    [[nodiscard]] std::string const& source() const { return source_; }
    /// Number of operations, numbers and names in an evaluation, to tell which formulas are too long to be shown.
    [[nodiscard]] long long operations() const { return operations_; }

private:
    template <class T>
    T evaluate(T const& t, components_view<T> q, components_view<T> v, bool everywhere) const;
    expression what_;
    std::shared_ptr<vocabulary const> words_;
    std::string source_;
    long long operations_ = 0;
};

/// The times in ]a, b[ at which one of the formulas switches, in increasing order; of two that rounding hardly tells apart the first. A
/// formula switches if a comparison of the time alone, as t < 1 or abs(t - 7) < 0.01, changes its outcome, or an abs, min or max of the
/// time has a kink. An affine a + b t is solved exactly; for others, as sin(t) < 0, changes between 4096 equal parts of the interval are
/// bisected down to rounding, and two changes within a part are missed. Comparisons in both parts of a choice count.
/// @throws error::invalid_parameter if one that is not affine changes more often than it is sampled
template <class S>
std::vector<S> switching_times(std::vector<stated> const& formulas, S const& a, S const& b);

} // namespace hilger::text
