// SPDX-License-Identifier: BSL-1.0
// The exact history in O(N log^2 N), for any number of values (Hairer, Lubich, Schlichte 1985): whenever 2^k divides the count m of values,
// and 2^{k+1} does not, the last 2^k of them are convolved with w_1, ..., w_{2^{k+1} - 1}, which is their whole contribution to the next
// 2^k sums. Every pair of a value and a later sum occurs once, at the highest bit in which their numbers differ.
#pragma once

#include <algorithm>

#include "hilger/fourier/transform.hpp"
#include "hilger/history/direct.hpp"

namespace hilger {

/// The policy that sums over all values in blocks; exact scalars are summed directly. The error is some epsilon of the norms of weights and
/// values, not of the sum: one much smaller than the largest before it, as in the tail after an impulse, has fewer correct digits than the
/// direct sum.
struct blocks {};

template <class G, class V>
class blocks_history {
    using s = detail::shape<V>;
    using S = scalar_of<V>;

public:
    blocks_history(S const& alpha, V const& like)
        : size_(s::dimension(like)), sequence_(alpha), parts_(static_cast<std::size_t>(size_)), past_(s::zero(size_)) {
        weights_up_to(shortest);
        reversed_.assign(2 * shortest, S(0));
        for (std::size_t n = 1; n < shortest; ++n) reversed_[shortest - n] = weights_[n];
    }

    /// sum_{n>=1} w_n x_{m-n} after m values; without the leading weight and h^-alpha. Computed at the first call, so that the last value
    /// of a run costs nothing.
    V const& past() {
        if (not ready_) make_past();
        return past_;
    }
    /// @throws error::mismatch, error::not_finite
    void push(V const& x) {
        detail::memory::check_value(x, size_, count_);
        if (not ready_) make_past(); // a block contributes to later sums even when its own was not asked for
        auto const m = static_cast<std::size_t>(count_);
        for (std::size_t c = 0; c < parts_.size(); ++c) {
            auto& values = parts_[c].values;
            if (m == values.size()) values.resize(std::max(shortest, 2 * m), S(0));
            values[m] = s::component(x, static_cast<int>(c));
        }
        ++count_;
        ready_ = false;
    }
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        V const like = past_;
        detail::memory::visit_values(
            *this, like, [&](index_type n, int c) { return parts_[static_cast<std::size_t>(c)].values[static_cast<std::size_t>(n)]; },
            each);
    }
    index_type count() const { return count_; }
    void reset() {
        for (auto& p : parts_) p = {};
        past_ = s::zero(size_);
        count_ = 0;
        ready_ = true;
    }
    std::size_t bytes() const {
        std::size_t numbers = weights_.size() + reversed_.size() + 2 * work_.re.size();
        for (auto const& spectrum : spectra_) numbers += 2 * spectrum.re.size();
        for (auto const& p : parts_) numbers += p.values.size() + p.ahead.size();
        return numbers * sizeof(S);
    }

private:
    /// Within this many values sums are direct.
    static constexpr std::size_t shortest = 32;
    static_assert(shortest % detail::memory::padding<S> == 0);

    struct part {                                     // of one component
        detail::memory::line_vector<S> values, ahead; ///< x_m, and the contribution of finished blocks to the sum m
    };

    void make_past() {
        auto const m = static_cast<std::size_t>(count_), inside = m % shortest;
        if (inside == 0) convolve_block(m);
        for (std::size_t c = 0; c < parts_.size(); ++c) {
            auto const& p = parts_[c];
            // Behind w_1 the table is zero: whole packs are summed.
            S const sum = sums_.product_sum(p.values.data() + (m - inside), reversed_.data() + (shortest - inside),
                                            detail::memory::padded<S>(inside));
            s::component(past_, static_cast<int>(c)) = m < p.ahead.size() ? S(p.ahead[m] + sum) : sum;
        }
        ready_ = true;
    }
    void convolve_block(std::size_t m) {
        std::size_t length = shortest, level = 0;
        for (; m % (2 * length) == 0; length *= 2) ++level;
        transform_.reserve(length);
        if (level >= spectra_.size()) spectra_.resize(level + 1);
        auto& weights = spectra_[level];
        if (weights.re.empty()) { // modulo z^{2 length} + 1
            weights_up_to(2 * length);
            S const scale = S(1) / S(static_cast<double>(length)); // a power of two
            for (std::size_t n = 0; n < length; ++n) {
                // w_0 has no part in the sums, and its rounding would show: the others may be as small as the order beside it.
                weights.re.push_back(n == 0 ? S(0) : S(weights_[n] * scale));
                weights.im.push_back(weights_[n + length] * scale);
            }
            transform_.forward(weights, length);
        }
        for (auto& p : parts_) {
            work_.re.assign(p.values.begin() + static_cast<index_type>(m - length), p.values.begin() + static_cast<index_type>(m));
            work_.im.assign(length, S(0));
            transform_.forward(work_, length);
            transform_.multiply(work_, weights, length);
            transform_.backward(work_, length);
            if (p.ahead.size() < m + length) p.ahead.resize(2 * m, S(0)); // m >= length
            for (std::size_t i = 0; i < length; ++i) p.ahead[m + i] = p.ahead[m + i] + work_.im[i];
        }
    }
    void weights_up_to(std::size_t count) {
        while (weights_.size() < count) weights_.push_back(sequence_.next());
    }

    int size_;
    index_type count_ = 0;
    weight_sequence<G, S> sequence_;
    std::vector<S> weights_;
    detail::memory::line_vector<S> reversed_;
    std::vector<part> parts_;
    std::vector<detail::memory::spectrum<S>> spectra_; // of the weights, for blocks of 32, 64, ...
    detail::memory::spectrum<S> work_;
    V past_;
    bool ready_ = true;
    detail::memory::fourier<S> transform_;
    detail::memory::sums<S> sums_;
};

/// @throws error::invalid_parameter for an order that is not finite.
template <generating_function G, class S, class V>
auto make_history(blocks const&, S const& alpha, V const& like) {
    if constexpr (not detail::memory::same_scalar<S, V>)
        return detail::memory::scalars_differ<S, V>();
    else if constexpr (std::numeric_limits<S>::is_exact)
        return direct_history<G, plain_t<V>>(alpha, like);
    else
        return blocks_history<G, plain_t<V>>(alpha, like);
}

} // namespace hilger
