// SPDX-License-Identifier: BSL-1.0
// The vector of jets that a formula is called with: Eigen's, except for sums over all components. Those of Eigen are nested functions,
// which clang++ does not inline for jets: derivatives then go through memory, and a step takes up to eighteen times as long.
#pragma once

#include <Eigen/Geometry> // for q.cross(v), which Eigen/Core declares alone

#include "hilger/differentiation/jet/functions.hpp"
#include "hilger/inlining.hpp"

namespace hilger::detail {

template <class J, int N>
class jet_vector : public Eigen::Matrix<J, N, 1> {
    using base = Eigen::Matrix<J, N, 1>;
    /// The sum of term(0) ... term(N - 1) by halves, in Eigen's order.
    template <int Start, int Length, class Term>
    HILGER_ALWAYS_INLINE static auto sum_of(Term const& term) {
        if constexpr (Length == 1)
            return term(Start);
        else {
            constexpr int half = Length / 2;
            return sum_of<Start, half>(term) + sum_of<Start + half, Length - half>(term);
        }
    }

public:
    using base::base;
    using base::operator=;

    HILGER_ALWAYS_INLINE J sum() const {
        return sum_of<0, N>([&](int k) HILGER_ALWAYS_INLINE { return (*this)(k); });
    }
    HILGER_ALWAYS_INLINE J squaredNorm() const {
        return sum_of<0, N>([&](int k) HILGER_ALWAYS_INLINE { return (*this)(k) * (*this)(k); });
    }
    HILGER_ALWAYS_INLINE J norm() const { return sqrt(squaredNorm()); }
    template <class Y>
    HILGER_ALWAYS_INLINE auto dot(Eigen::MatrixBase<Y> const& y) const {
        if constexpr (std::same_as<Y, Eigen::Matrix<typename Y::Scalar, N, 1>>)
            return sum_of<0, N>([&](int k) HILGER_ALWAYS_INLINE { return (*this)(k)*y(k); });
        else
            return base::dot(y);
    }
};

} // namespace hilger::detail
