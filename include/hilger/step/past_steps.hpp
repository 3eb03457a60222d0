// SPDX-License-Identifier: BSL-1.0
// The increments of the last steps of one length, and the first guess that the polynomial through them makes for the next one.
#pragma once

#include <array>

#include "hilger/newton/stop.hpp"

namespace hilger::detail {

template <class Unknown, class S>
class past_steps {
    static constexpr int most = 8;

public:
    explicit past_steps(Unknown const& like) { past_.fill(like); }
    /// The increment of the step before the last `k`.
    [[nodiscard]] Unknown const& operator[](int k) const { return past_[place((newest_ + k) % most)]; }
    void keep(Unknown const& moved) {
        newest_ = (newest_ + most - 1) % most;
        past_[place(newest_)] = moved;
    }
    /// From the last `known` of them, at least one.
    void guess(Unknown& moved, long long known) const {
        auto const& past = *this;
        if (known >= most) {
            moved = past[0] * S(extrapolation(most, 0));
            for (int k = 1; k < most; ++k) moved = moved + past[k] * S(extrapolation(most, k));
        } else if (known >= 2)
            moved = past[0] * S(2) - past[1];
        else
            moved = past[0];
    }
    template <class Visit>
    void visit_newest(Visit& each) {
        each("newest", newest_);
    }
    template <class Visit>
    void visit(Visit& each) {
        for (Unknown& x : past_)
            for (int c = 0; c < shape<Unknown>::dimension(x); ++c) each("past", shape<Unknown>::component(x, c));
    }

private:
    static constexpr std::size_t place(int j) { return static_cast<std::size_t>(j); }
    std::array<Unknown, most> past_;
    int newest_ = 0;
};

} // namespace hilger::detail
