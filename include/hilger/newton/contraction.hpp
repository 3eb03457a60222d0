// SPDX-License-Identifier: BSL-1.0
// When an iteration that contracts is done: where what is left is below rounding, or where only rounding errors are left, which do not
// shrink (Hairer, McLachlan, Razakarivony 2008). What is left after a correction is the rate times it, and the rate is the ratio of two
// corrections.
#pragma once

#include "hilger/scalar.hpp"

namespace hilger::detail {

enum class progress { going, done, lost };

template <class S>
class contraction {
public:
    /// `rounding` is the size of one rounding error of the iterate, and what is left is to be `small` times that.
    contraction(S rounding, S small) : rounding_(std::move(rounding)), small_(std::move(small)) {}

    /// After a correction of this size. Lost is an iteration that gains less than half of a digit (binary) a round, once it has settled.
    progress after(S const& size) {
        ++rounds_;
        if (not is_finite(size)) return progress::lost;
        if (size <= rounding_ * small_) return progress::done;
        if (rounds_ > 1) {
            if (size * (size / previous_) <= rounding_ * small_) return progress::done; // a quotient: squares of small sizes are zero
            if (not(S(2) * size < previous_)) {
                if (is_rounding(size)) return progress::done;
                if (rounds_ > 3) return progress::lost;
            }
        }
        previous_ = size;
        return progress::going;
    }

    /// Whether a correction of this size is one of the rounding errors that are left at the end.
    [[nodiscard]] bool is_rounding(S const& size) const { return size <= S(64) * rounding_; }

private:
    S rounding_, small_, previous_{0};
    int rounds_ = 0;
};

} // namespace hilger::detail
