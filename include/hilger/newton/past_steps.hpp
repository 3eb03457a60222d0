// SPDX-License-Identifier: BSL-1.0
// The solutions of the last steps of one length, increments or velocities, and their extrapolation by a polynomial to the next step.
#pragma once

#include <array>
#include <utility>

#include "hilger/history/component.hpp"
#include "hilger/inlining.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger::detail {

template <class Unknown, class S, int Most>
class past_steps {
public:
    explicit past_steps(Unknown const& like) { past_.fill(like); }
    /// The solution k steps before the last.
    [[nodiscard]] Unknown const& operator[](int k) const { return past_[place((newest_ + k) % Most)]; }
    void keep(Unknown const& solution) {
        newest_ = (newest_ + Most - 1) % Most;
        past_[place(newest_)] = solution;
    }
    /// Extrapolates the last `known` solutions, at least one.
    void guess(Unknown& next, long long known) const {
        auto const& past = *this;
        if (known >= Most)
            extrapolate(next, std::make_integer_sequence<int, Most - 1>{});
        else if (known >= 2)
            next = S(2) * past[0] - past[1];
        else
            next = past[0];
    }
    /// For checkpoints; `label` names a component.
    template <class Visit>
    void visit(char const* label, Visit& each) {
        each("newest", newest_);
        for (Unknown& x : past_) memory::visit_components(label, x, each);
    }

private:
    static constexpr std::size_t place(int j) { return static_cast<std::size_t>(j); }
    /// Two vectors at a time, from the oldest: as one expression each partial sum would be a type of its own.
    template <int... I>
    void extrapolate(Unknown& next, std::integer_sequence<int, I...>) const {
        auto const add_up = [this](Unknown& sum) HILGER_ALWAYS_INLINE {
            sum = S(extrapolation(Most, Most - 1)) * (*this)[Most - 1];
            ((sum = S(extrapolation(Most, Most - 2 - I)) * (*this)[Most - 2 - I] + sum), ...);
        };
        if constexpr (shape<Unknown>::size == Eigen::Dynamic)
            add_up(next);
        else { // in registers
            Unknown sum;
            add_up(sum);
            next = sum;
        }
    }
    std::array<Unknown, static_cast<std::size_t>(Most)> past_;
    int newest_ = 0;
};

} // namespace hilger::detail
