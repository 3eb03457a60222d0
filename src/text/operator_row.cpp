// SPDX-License-Identifier: BSL-1.0
// Equality of operators, as adjoint/normal_form.hpp decides it at compile time: by what both make of a generic function on a generic scale,
// with random steps. In rationals; where a factor is none, as sqrt(2), in 50 digits.
#include "text/operator_row.hpp"

#include <limits>

#include "hilger/adjoint/normal_form.hpp"
#include "hilger/error.hpp"

namespace hilger::text {

namespace {

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
template <class S>
std::vector<S> row_of(operator_formula const& a, bool uniform, lost_points reach, bool sizes = false) {
    return detail::row_on<S>(endless_scale<S>{uniform}, a, reach, sizes);
}
bool equal_rows(operator_formula const& a, operator_formula const& b, bool uniform, lost_points reach) {
    auto const x = row_of<float50>(a, uniform, reach), y = row_of<float50>(b, uniform, reach);
    auto const of_x = row_of<float50>(a, uniform, reach, true), of_y = row_of<float50>(b, uniform, reach, true);
    for (std::size_t k = 0; k < x.size(); ++k)
        if (abs(float50(x[k] - y[k])) > (of_x[k] + of_y[k]) * float50("1e-40")) return false;
    return true;
}

} // namespace

std::optional<std::vector<Q>> detail::exact_row_of(operator_formula const& a, bool uniform, lost_points reach) {
    try {
        return row_of<Q>(a, uniform, reach);
    } catch (error::unreadable const&) {
        return {};
    }
}
bool equal(operator_formula const& a, operator_formula const& b, bool uniform) {
    if (not(a.lost() == b.lost())) return false;
    auto const reach = a.lost();
    auto const x = detail::exact_row_of(a, uniform, reach), y = detail::exact_row_of(b, uniform, reach);
    return x and y ? *x == *y : equal_rows(a, b, uniform, reach);
}

} // namespace hilger::text
