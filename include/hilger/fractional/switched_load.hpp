// SPDX-License-Identifier: BSL-1.0
// The load of a structure at a point of T where it jumps in a step beside it: the mean of f over both steps weighted with a hat function,
// which keeps the impulse and the place of the jump, and so the order two of Newmark's scheme. At a jump on the point it is the mean of
// both sides. For the continuous part of f it is f at the point. The jumps of f are its switching_times(a, b), as formulas in text have
// them.
#pragma once

#include <algorithm>
#include <vector>

#include "hilger/scalar.hpp"

namespace hilger::detail {

/// Along one trajectory with steps h.
template <class S>
class switched_load {
public:
    explicit switched_load(S const& h) : h_(h), ahead_(S(1024) * h) {}
    /// `load` = f at t; at the first point, which has no step before it, the mean over the one behind.
    template <class Load, class V>
    void read(Load const& f, S const& t, bool is_first, V& load) {
        load = f(t);
        if constexpr (requires { f.switching_times(t, t); }) {
            if (S(t - h_) < from_ or to_ < S(t + h_)) look_ahead(f, t);
            S const unit = S(64) * epsilon<S>() * std::max(magnitude(t), h_);
            for (auto at = std::upper_bound(times_.begin(), times_.end(), S(t - h_)); at != times_.end() and *at < S(t + h_); ++at) {
                V const before = f(S(*at - unit)), behind = f(S(*at + unit)), jump = behind - before;
                bool const is_here = magnitude(S(*at - t)) <= unit;
                if (is_here) load = load + (before - V(f(t))); // of one side or the other
                S const away = is_here ? S(0) : S((*at - t) / h_), rest = S(1) - magnitude(away), half = rest * rest / S(2);
                S const share = not is_first ? (away < S(0) ? S(-half) : half) : away < S(0) ? S(0) : S(S(2) * half);
                load = load + jump * share;
            }
        }
    }

private:
    template <class Load>
    void look_ahead(Load const& f, S const& t) {
        from_ = t - h_;
        to_ = t + ahead_;
        ahead_ = S(2) * ahead_; // in all as often as numbers of steps have digits
        times_ = f.switching_times(S(from_ - h_), to_);
    }
    S h_, ahead_, from_{1}, to_{0}; // nothing yet
    std::vector<S> times_;
};

} // namespace hilger::detail
