// SPDX-License-Identifier: BSL-1.0
// The last values of a history and what they contribute: sum_{n=1..length} w_n x_{m-n}.
#pragma once

#include "hilger/history/component.hpp"
#include "hilger/history/sums.hpp"

namespace hilger::detail {

/// Each value is kept twice, `length` apart, so that the last ones are contiguous wherever the newest is.
template <class S>
class recent_values {
public:
    /// `weights` are w_1, w_2, ...
    recent_values(std::vector<S> const& weights, index components) : length_(padded<S>(weights.empty() ? 1 : weights.size())) {
        reversed_.assign(length_, S(0));
        for (std::size_t n = 0; n < weights.size(); ++n) reversed_[length_ - 1 - n] = weights[n];
        values_.assign(2 * length_ * static_cast<std::size_t>(components), S(0));
    }
    /// Makes x_m the newest value of a component and returns the sum for m + 1. All components are pushed before advance().
    S push(S const& x, index component, sums<S> const& loops) {
        S* const values = begin(component);
        values[newest_] = x;
        values[newest_ + length_] = x;
        return loops.product_sum(reversed_.data(), values + newest_ + 1, length_);
    }
    /// x_{m+1-length}, before advance().
    S const& oldest(index component) { return begin(component)[newest_ + 1]; }
    void advance() { newest_ = newest_ + 1 == length_ ? 0 : newest_ + 1; }
    void reset() {
        newest_ = 0;
        values_.assign(values_.size(), S(0));
    }
    std::size_t bytes() const { return (reversed_.size() + values_.size()) * sizeof(S); }

private:
    S* begin(index component) { return values_.data() + 2 * length_ * static_cast<std::size_t>(component); }
    std::size_t length_, newest_ = 0;
    line_vector<S> reversed_, values_;
};

} // namespace hilger::detail
