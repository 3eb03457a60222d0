// SPDX-License-Identifier: BSL-1.0
// The times at which formulas switch (hilger/text/stated.hpp). Behind each switch the formulas are traced (differentiation/traced), and
// their comparisons of the time are followed to the next zero.
#pragma once

#include <algorithm>
#include <optional>

#include "hilger/differentiation/traced/arithmetic.hpp"
#include "hilger/error.hpp"
#include "hilger/scalar.hpp"
#include "hilger/text/stated.hpp"

namespace hilger::text {

namespace detail {

/// The comparisons of the time in formulas, traced at one time.
template <class S>
struct time_comparisons {
    std::vector<bool> outcomes;
    std::vector<S> zeros; ///< of differences that are affine in the traced branch
    bool all_affine = true;

    time_comparisons(std::vector<stated> const& formulas, S const& t) {
        using T = traced<S>;
        int const d = formulas.front().words().dimension();
        hilger::detail::formula_graph<S> g(d);
        hilger::detail::unwatched const while_tracing;
        hilger::detail::tracing<S> const here(g);
        auto const q = [](int k) { return T::at(k, S(1)); };
        auto const v = [d](int k) { return T::at(d + k, S(1)); };
        for (stated const& f : formulas) f.value(T::at(2 * d, t), q, v, true);
        if (g.guards().empty()) return;
        std::vector<S> value(static_cast<std::size_t>(g.size()), S(1));
        std::vector<std::optional<S>> slope(value.size());
        for (int k = 0; k < g.size(); ++k) {
            auto const at = static_cast<std::size_t>(k);
            if (auto const& n = g[k]; n.what != nullptr) {
                n.what->run(value.data(), k, 1, &n.a, &n.b);
                slope[at] = slope_of(n, value, slope);
            } else if (g.is_number(k)) {
                value[at] = g.number(k);
                slope[at] = S(0);
            } else if (k == 2 * d) {
                value[at] = t;
                slope[at] = S(1);
            }
        }
        for (auto const& c : g.guards()) {
            auto const a = static_cast<std::size_t>(c.a), b = static_cast<std::size_t>(c.b);
            if ((g[c.a].on | g[c.b].on) != hilger::detail::on_time) continue;
            outcomes.push_back(c.outcome);
            if (not slope[a] or not slope[b])
                all_affine = false;
            else if (not(*slope[a] == *slope[b]))
                zeros.push_back(S(t - (value[a] - value[b]) / (*slope[a] - *slope[b])));
        }
    }

private:
    /// The slope of an operation that is affine in the time; nothing for any other.
    template <class Node>
    static std::optional<S> slope_of(Node const& n, std::vector<S> const& value, std::vector<std::optional<S>> const& slope) {
        namespace of = hilger::detail;
        auto const a = static_cast<std::size_t>(n.a), b = static_cast<std::size_t>(n.b);
        if (not slope[a] or not slope[b]) return {};
        S const &x = *slope[a], &y = *slope[b];
        if (n.what == &of::operation_object<of::plus_traced, S>) return S(x + y);
        if (n.what == &of::operation_object<of::minus_traced, S>) return S(x - y);
        if (n.what == &of::operation_object<of::minus_of_traced, S>) return S(-x);
        if (x == S(0) and y == S(0)) return S(0);
        if (n.what == &of::operation_object<of::over_traced, S> and y == S(0)) return S(x / value[b]);
        if (n.what == &of::operation_object<of::times_traced, S> and (x == S(0) or y == S(0))) return S(x * value[b] + y * value[a]);
        return {};
    }
};

/// Goes from `low`, which has the outcomes `so`, in equal steps to the first point with others, and bisects there down to rounding; `high`
/// when the outcomes never change.
template <class S>
S first_change(std::vector<stated> const& formulas, std::vector<bool> const& so, S low, S const& high, S const& step) {
    auto const same = [&](S const& t) { return time_comparisons<S>(formulas, t).outcomes == so; };
    S next = low;
    do {
        low = next;
        if (not(low < high)) return high;
        next = std::min(S(low + step), high);
    } while (same(next));
    for (S middle = S((low + next) / S(2)); low < middle and middle < next; middle = S((low + next) / S(2)))
        (same(middle) ? low : next) = middle;
    return next;
}

} // namespace detail

template <class S>
std::vector<S> switching_times(std::vector<stated> const& formulas, S const& a, S const& b) {
    constexpr int looks = 4096;
    std::vector<S> found;
    if (std::none_of(formulas.begin(), formulas.end(), [](stated const& f) { return f.reads(meaning::role::time); })) return found;
    S const unit = S(64) * epsilon<S>() * std::max(magnitude(a), magnitude(b)), step = S(b - a) / S(looks);
    int changes = 0;
    for (S now = a; S(now + S(2) * unit) < b;) {
        S const behind = now + unit;
        detail::time_comparisons<S> const there(formulas, behind);
        S next = b;
        for (S const& zero : there.zeros)
            if (S(behind + unit) < zero and zero < next) next = zero;
        if (not there.all_affine)
            if (S const end = next - unit, change = detail::first_change(formulas, there.outcomes, behind, end, step); change < end) {
                next = change;
                if (++changes > looks)
                    error::raise<error::invalid_parameter>(formulas.front().source(),
                                                           " compares a function of the time that changes more than ", looks,
                                                           " times between ", a, " and ", b, ": a shorter interval has fewer of them");
            }
        if (next < b) found.push_back(next);
        now = next;
    }
    return found;
}

} // namespace hilger::text
