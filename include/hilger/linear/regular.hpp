// SPDX-License-Identifier: BSL-1.0
// A matrix counts as singular if its pivots have no digit left.
#pragma once

#include "hilger/inlining.hpp"
#include "hilger/scalar.hpp"

namespace hilger::detail {

/// Whether elimination has left a digit of a diagonal entry. A row that is small as a whole is not singular.
template <class S>
HILGER_ALWAYS_INLINE inline bool is_pivot(S const& pivot, S const& entry, index_type d) {
    using std::abs;
    return S(static_cast<int>(d)) * epsilon<S>() * abs(entry) < abs(pivot);
}

/// Neither zero nor beyond the largest number: r / inf is 0, and would pass for a solution.
template <class S>
HILGER_ALWAYS_INLINE inline bool is_divisor(S const& k) {
    return not(k == S(0)) and is_finite(k);
}

/// Whether no pivot is at the rounding level of the largest: else no digit of a solution is right.
template <class LU>
bool is_regular(LU const& lu) {
    using S = typename LU::Scalar;
    auto const pivots = lu.matrixLU().diagonal().cwiseAbs();
    return pivots.maxCoeff() * S(static_cast<int>(pivots.size())) * epsilon<S>() < pivots.minCoeff();
}
} // namespace hilger::detail
