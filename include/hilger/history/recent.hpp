// SPDX-License-Identifier: BSL-1.0
// The last values of a history and their contribution sum_{n=1..length} w_n x_{m-n}.
#pragma once

#include "hilger/history/component.hpp"
#include "hilger/history/sums.hpp"

namespace hilger::detail::memory {

/// A new value adds one product to the next sum; all else was summed when the value before it came. So a scheme waits for that product
/// only, and the processor sums the rest while the next value is computed. Each value is stored twice, `length` apart, so that the last
/// ones are contiguous wherever the newest is. The newest few are read one by one: a pack with a number just written would wait for the
/// cache.
template <class S>
class recent_values {
public:
    /// `weights` are w_1, w_2, ...
    recent_values(std::vector<S> const& weights, index_type components)
        : length_(static_cast<std::size_t>(room(static_cast<index_type>(weights.size()))) - 1),
          first_(weights.empty() ? S(0) : weights[0]) {
        reversed_.assign(length_, S(0));
        for (std::size_t n = 1; n < weights.size(); ++n) reversed_[length_ - n] = weights[n];
        values_.assign(2 * length_ * static_cast<std::size_t>(components), S(0));
    }
    /// w_1
    S const& first() const { return first_; }
    /// The number of weights that are stored, whole packs behind the first few, where `weights` are asked for.
    static index_type room(index_type weights) {
        index_type const near = static_cast<index_type>(one_by_one) + 1;
        return near + (weights <= near ? 0 : static_cast<index_type>(padded<S>(static_cast<std::size_t>(weights - near))));
    }
    /// The oldest value, which the next one replaces.
    S const& oldest(index_type component) { return begin(component)[newest_]; }
    /// Makes x_m the newest value of a component and returns sum_{n=2..} w_n x_{m+2-n}. All components are pushed before advance().
    S push(S const& x, index_type component, sums<S> const& loops) {
        S* const values = begin(component);
        values[newest_] = x;
        values[newest_ + length_] = x;
        std::size_t const old = length_ - one_by_one;
        S const *const window = values + newest_ + 1, *const w = reversed_.data();
        constexpr std::size_t half = one_by_one / 2; // apart, so that no compiler makes packs of neighbours
        S older = w[old] * window[old], newer = w[old + half] * window[old + half];
        for (std::size_t i = old + 1; i < old + half; ++i) {
            older = older + w[i] * window[i];
            newer = newer + w[i + half] * window[i + half];
        }
        return old == 0 ? S(older + newer) : S(older + newer + loops.product_sum(w, window, old));
    }
    void advance() { newest_ = newest_ + 1 == length_ ? 0 : newest_ + 1; }
    void reset() {
        newest_ = 0;
        values_.assign(values_.size(), S(0));
    }
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("newest", newest_);
        if (newest_ >= length_) error::raise<error::unreadable>("the newest of ", length_, " values is not the one with number ", newest_);
        for (std::size_t part = 0; part < values_.size(); part += 2 * length_)
            for (std::size_t i = part; i < part + length_; ++i) {
                each("value", values_[i]);
                values_[i + length_] = values_[i];
            }
    }
    std::size_t bytes() const { return (reversed_.size() + values_.size()) * sizeof(S); }

private:
    S* begin(index_type component) { return values_.data() + 2 * length_ * static_cast<std::size_t>(component); }
    static constexpr std::size_t one_by_one = 8;
    std::size_t length_, newest_ = 0;
    S first_;
    line_vector<S> reversed_, values_;
};

} // namespace hilger::detail::memory
