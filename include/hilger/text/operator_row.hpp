// SPDX-License-Identifier: BSL-1.0
// What an operator that is known at run time only makes of a generic function on a generic scale, as adjoint/normal_form.hpp does at
// compile time: (A f)(t_i) = sum_k c_k f(t_{i+k}), with random steps beside t_i. In rationals this decides whether two operators are equal;
// where a factor is none, as sqrt(2), in 50 digits.
#pragma once

#include <limits>
#include <optional>

#include "hilger/adjoint/normal_form.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/text/operator_in_numbers.hpp"

namespace hilger::text {

namespace detail {

/// A scale without ends.
template <class S>
struct endless_scale {
    using scalar_type = S;
    bool uniform = false;
    static constexpr index_type steps() { return 1'000'000; }
    /// In numbers that round of the size of 1: beside long steps what is divided by them would be rounding.
    [[nodiscard]] S step(index_type i) const {
        S const some(static_cast<long long>(hilger::detail::random_element(uniform ? 7 : static_cast<std::uint64_t>(i) + 100).value()));
        return std::numeric_limits<S>::is_exact ? some : S(some / S(1LL << 60));
    }
};
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
template <class S>
std::vector<S> row_of(operator_formula const& a, bool uniform, lost_points reach, bool sizes = false) {
    return row_on<S>(endless_scale<S>{uniform}, a, reach, sizes);
}
/// The same in rationals; nothing where a factor is none. Here and below templates for one type each: who compiles many files instantiates
/// what has long arithmetic in one of them.
template <std::same_as<Q> Exact>
std::optional<std::vector<Exact>> exact_row_of(operator_formula const& a, bool uniform, lost_points reach) {
    try {
        return row_of<Exact>(a, uniform, reach);
    } catch (error::unreadable const&) {
        return {};
    }
}
template <std::same_as<float50> Long>
bool equal_rows(operator_formula const& a, operator_formula const& b, bool uniform, lost_points reach) {
    auto const x = row_of<Long>(a, uniform, reach), y = row_of<Long>(b, uniform, reach);
    auto const of_x = row_of<Long>(a, uniform, reach, true), of_y = row_of<Long>(b, uniform, reach, true);
    for (std::size_t k = 0; k < x.size(); ++k)
        if (abs(Long(x[k] - y[k])) > (of_x[k] + of_y[k]) * Long("1e-40")) return false;
    return true;
}

} // namespace detail

/// A and B make the same of every function on every scale, or on every uniform one, and lose the same points at the ends.
inline bool equal(operator_formula const& a, operator_formula const& b, bool uniform = false) {
    if (not(a.lost() == b.lost())) return false;
    auto const reach = a.lost();
    auto const x = detail::exact_row_of<Q>(a, uniform, reach), y = detail::exact_row_of<Q>(b, uniform, reach);
    return x and y ? *x == *y : detail::equal_rows<float50>(a, b, uniform, reach);
}
inline bool operator==(operator_formula const& a, operator_formula const& b) { return equal(a, b); }

} // namespace hilger::text
