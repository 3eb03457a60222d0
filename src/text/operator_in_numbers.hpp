// SPDX-License-Identifier: BSL-1.0
// The factors of operators as numbers, and operators as rows of coefficients (hilger/text/operator.hpp).
#pragma once

#include <optional>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/scalar.hpp"
#include "hilger/text/operator.hpp"

namespace hilger::text {

template <class S>
operator_in_numbers<S>::operator_in_numbers(operator_formula const& a) {
    add(a);
}
template <class S>
std::size_t operator_in_numbers<S>::add(operator_formula const& a) {
    auto const& n = a.root();
    item made{n.what, n.which, n.from, n.to, S(1), 0, 0};
    if (n.factor) made.factor = n.factor->template number<S>();
    if (not is_finite(made.factor))
        error::raise<error::not_finite>(n.factor->source(), ": ", written(n.factor->formula(), 80).value_or("a factor"),
                                        " is no finite number");
    if (not n.parts.empty()) made.first = add(n.parts[0]);
    if (n.parts.size() > 1) made.second = add(n.parts[1]);
    items_.push_back(std::move(made));
    return items_.size() - 1;
}
template <class S>
typename operator_in_numbers<S>::row_type operator_in_numbers<S>::before(std::size_t k, detail::steps_view<S> const& T, row_type after,
                                                                         bool sizes) const {
    item const& n = items_[k];
    row_type made;
    switch (n.what) {
    case kind::shift:
        for (auto const& [i, c] : after) made[n.which == side::plus ? i + 1 : i - 1] += c;
        return made;
    case kind::derivative:
        for (auto const& [i, c] : after) {
            index_type const left = n.which == side::plus ? i : i - 1;
            S const slope = c / T.step(left);
            made[left + 1] += slope;
            made[left] += sizes ? slope : S(-slope);
        }
        return made;
    case kind::reweight:
        for (auto& [i, c] : after) c *= ratio_of_weights(n, T, i);
        return after;
    case kind::multiple:
        for (auto& [i, c] : after) c *= sizes and S(0) > n.factor ? S(-n.factor) : n.factor;
        return before(n.first, T, std::move(after), sizes);
    case kind::sum:
        made = before(n.first, T, after, sizes);
        for (auto const& [i, c] : before(n.second, T, std::move(after), sizes)) made[i] += c;
        return made;
    case kind::product:
        return before(n.second, T, before(n.first, T, std::move(after), sizes), sizes);
    default:
        return after;
    }
}
template <class S>
S operator_in_numbers<S>::ratio_of_weights(item const& n, detail::steps_view<S> const& T, index_type i) {
    if (n.from == n.to) return S(1);
    auto const weight = [&](sum_weight w) { // a missing neighbour counts as zero
        if (w == sum_weight::delta) return i < T.steps() ? T.step(i) : S(0);
        return i > 0 ? T.step(i - 1) : S(0);
    };
    return weight(n.from) / weight(n.to);
}

namespace detail {

/// The numbers c_k, from -reach.front to reach.back, on a scale without ends. `sizes` as in operator_in_numbers::row.
template <class S>
std::vector<S> row_on(hilger::detail::function_view<S(index_type)> step, operator_formula const& a, lost_points reach, bool sizes = false) {
    constexpr index_type here = 1000, endless = 1'000'000;
    auto numbers = operator_in_numbers<S>(a).row(steps_view<S>{step, endless}, here, sizes);
    std::vector<S> row;
    for (index_type k = -reach.front; k <= reach.back; ++k) row.push_back(numbers[here + k]); // 0 outside
    return row;
}
/// The row on a generic scale, in rationals; nothing when a factor is irrational.
std::optional<std::vector<Q>> exact_row_of(operator_formula const& a, bool uniform, lost_points reach);

} // namespace detail

} // namespace hilger::text
