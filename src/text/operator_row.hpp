// SPDX-License-Identifier: BSL-1.0
// Rows of numbers (A f)(t_i) = sum_k c_k f(t_{i+k}) on scales without ends.
#pragma once

#include <optional>
#include <vector>

#include "hilger/multiprecision.hpp"
#include "hilger/text/operator.hpp"

namespace hilger::text::detail {

/// A scale without ends whose steps are h.
template <class S>
struct equal_steps {
    using scalar_type = S;
    S h;
    static constexpr index_type steps() { return 1'000'000; }
    [[nodiscard]] S const& step(index_type) const { return h; }
};
/// The numbers c_k, from -reach.front to reach.back. `sizes` as in operator_in_numbers::row.
template <class S, class T>
std::vector<S> row_on(T const& scale, operator_formula const& a, lost_points reach, bool sizes = false) {
    constexpr index_type here = 1000;
    auto const numbers = operator_in_numbers<S>(a).row(scale, here, sizes);
    std::vector<S> row;
    for (index_type k = -reach.front; k <= reach.back; ++k) {
        auto const c = numbers.find(here + k);
        row.push_back(c == numbers.end() ? S(0) : c->second);
    }
    return row;
}
/// The same of a generic function on a generic scale, in rationals; nothing where a factor is none.
std::optional<std::vector<Q>> exact_row_of(operator_formula const& a, bool uniform, lost_points reach);

} // namespace hilger::text::detail
