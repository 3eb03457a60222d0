// SPDX-License-Identifier: BSL-1.0
// For how many steps a cheaper way is not tried again after it has failed: for one step, and after each further failure for twice as many.
// A motion that is stiff throughout pays for few trials, and one that is stiff for a while, as in an encounter, gets its cheap steps back.
#pragma once

#include <algorithm>

namespace hilger::detail {

class back_off {
public:
    [[nodiscard]] bool allows() const { return left_ == 0; }
    void has_worked() { next_ = 1; }
    void has_failed() {
        left_ = next_;
        next_ = std::min(2 * next_, 1024);
    }
    /// A step without the cheaper way.
    void passes() { --left_; }
    /// For checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("left", left_);
        each("next", next_);
    }

private:
    int left_ = 0, next_ = 1; ///< steps
};

} // namespace hilger::detail
