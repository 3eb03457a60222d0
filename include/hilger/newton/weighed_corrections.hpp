// SPDX-License-Identifier: BSL-1.0
// How large each component of a correction may be, in units of what decides about it: the component itself, or where it goes through zero,
// what the residual is the sum of. Components may be of very different sizes.
#pragma once

#include <limits>

#include "hilger/shape.hpp"

namespace hilger::detail {

template <class Unknown, class S, class Vector>
class weighed_corrections {
    using u = shape<Unknown>;

public:
    explicit weighed_corrections(Vector const& zero) : weight_(zero), per_weight_(zero) {}

    /// Where `moved` is about the solution: put_sizes(x) makes x the size of what the residual is the sum of, and `factorized` solves.
    template <class PutSizes, class Matrix>
    void weigh(Unknown const& moved, PutSizes const& put_sizes, Matrix& factorized) {
        per_weight_.setZero();
        put_sizes(weight_);
        factorized.solve(weight_);
        S most(0);
        for (int c = 0; c < count(); ++c) {
            S const size = magnitude(u::component(moved, c)), other = magnitude(S(weight_(c)));
            weight_(c) = size < other ? other : size;
            if (most < weight_(c)) most = weight_(c);
        }
        // what stands still has no size, and may move by the rounding of the others
        S const least = epsilon<S>() * most;
        for (int c = 0; c < count(); ++c)
            if (S const w = weight_(c) < least ? least : S(weight_(c)); S(0) < w) per_weight_(c) = S(1) / w;
    }
    [[nodiscard]] S size_of(Vector const& correction) const {
        return count() == 0 ? S(0) : S(correction.cwiseProduct(per_weight_).cwiseAbs().maxCoeff());
    }
    /// Whether Newton's next correction would be rounding: convergence is quadratic where this one is small beside what it corrects.
    [[nodiscard]] bool is_last(Vector const& correction, Unknown const& moved, S const& small) const {
        for (int c = 0; c < count(); ++c) {
            S const size = magnitude(S(correction(c)));
            if (size <= (std::numeric_limits<S>::min)()) continue; // numbers below it have lost their digits; of exact ones it is 0
            if (not(size <= small * magnitude(u::component(moved, c))) and not(size <= S(8) * epsilon<S>() * weight_(c))) return false;
        }
        return true;
    }

private:
    [[nodiscard]] int count() const { return static_cast<int>(weight_.size()); }
    Vector weight_, per_weight_;
};

} // namespace hilger::detail
