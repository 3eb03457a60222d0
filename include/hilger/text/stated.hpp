// SPDX-License-Identifier: BSL-1.0
// A formula in text with what its names stand for.
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

/// A formula and what its names stand for. Copies share both. It has values in float, double, long double, float50, float100 and Q, in
/// traced numbers of these: these are compiled in hilger::text.
class stated {
public:
    /// @throws error::unreadable with the place of a name that nothing is known of, of a vector without an index, an index outside of its
    ///         vector, a function with a wrong number of arguments
    stated(expression what, std::shared_ptr<vocabulary const> words, std::string source);

    /// The value at (t, q, v), states given by component: q(k) is component k. With `everywhere` both parts of choices are evaluated.
    template <class T, class Q, class V>
    T value(T const& t, Q const& q, V const& v, bool everywhere = false) const {
        return evaluate<T>(
            t, [&](int k) { return T(q(k)); }, [&](int k) { return T(v(k)); }, everywhere);
    }
    [[nodiscard]] vocabulary const& words() const { return *words_; }
    [[nodiscard]] expression const& formula() const { return what_; }
    /// Whether one of the names in it stands for the time, or for velocities.
    [[nodiscard]] bool reads(meaning::role role) const;
    /// Whether it has other values at other states.
    [[nodiscard]] bool reads_state() const {
        return reads(meaning::role::time) or reads(meaning::role::position) or reads(meaning::role::velocity);
    }
    /// The value of one that does not. @throws error::unreadable where S has no such number, as a root in rationals or 1/0
    template <class S>
    [[nodiscard]] S number() const;
    [[nodiscard]] std::string const& source() const { return source_; }
    /// How many operations a value takes, and numbers and names it reads: to know what is too long to be shown.
    [[nodiscard]] long long operations() const { return operations_; }

private:
    template <class T>
    T evaluate(T const& t, components_view<T> q, components_view<T> v, bool everywhere) const;
    expression what_;
    std::shared_ptr<vocabulary const> words_;
    std::string source_;
    long long operations_ = 0;
};

/// The times in ]a, b[ at which one of the formulas switches, in increasing order; of two that rounding hardly tells apart the first: where
/// a comparison of the time alone, as t < 1 or abs(t - 7) < 0.01, comes out another way, or an abs, a min or a max of it has a kink. An
/// affine a + b t is followed exactly; of anything else, as sin(t) < 0, changes are looked for at 4096 equal distances of the interval and
/// halved down to rounding, so that what changes and changes back between two of them is not seen. Comparisons in both parts of a choice
/// count, whether the state leads there or not.
/// @throws error::invalid_parameter where one that is not affine changes more often than it is looked at
template <class S>
std::vector<S> switching_times(std::vector<stated> const& formulas, S const& a, S const& b);

} // namespace hilger::text
