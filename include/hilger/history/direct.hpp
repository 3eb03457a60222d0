// SPDX-License-Identifier: BSL-1.0
// The history of a fractional difference, s_m = sum_{n=1..m} w_n x_{m-n}, by definition: all values and all weights are kept, and every sum
// is computed anew. Exact in exact scalars; m products at value m, so that N values cost N^2 / 2.
#pragma once

#include "hilger/history/component.hpp"
#include "hilger/history/sums.hpp"
#include "hilger/operator/weights.hpp"

namespace hilger {

/// The policy that sums over all values directly.
struct direct {};

template <class G, class V>
class direct_history {
    using s = detail::shape<V>;
    using S = scalar_of<V>;

public:
    direct_history(S const& alpha, V const& like)
        : alpha_(alpha), size_(s::dimension(like)), weights_(alpha), values_(static_cast<std::size_t>(size_)), past_(s::zero(size_)) {
        weights_.next(); // w_0, the present's
    }

    /// sum_{n>=1} w_n x_{m-n} after m values; without the leading weight and h^-alpha.
    V const& past() const { return past_; }
    /// O(m) products. @throws error::mismatch, error::not_finite
    void push(V const& x) {
        detail::memory::check_value(x, size_, count_);
        auto const m = static_cast<std::size_t>(count_) + 1;
        if (m > reversed_.size()) grow();
        reversed_[reversed_.size() - m] = weights_.next();
        for (int c = 0; c < size_; ++c) {
            auto& values = values_[static_cast<std::size_t>(c)];
            values[m - 1] = s::component(x, c);
            // Both tables are zero beyond their entries, so that whole packs may be summed.
            s::component(past_, c) = sums_.product_sum(values.data(), reversed_.data() + reversed_.size() - m, m);
        }
        ++count_;
    }
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        V const like = past_;
        detail::memory::visit_values(
            *this, like, [&](index_type n, int c) { return values_[static_cast<std::size_t>(c)][static_cast<std::size_t>(n)]; }, each);
    }
    index_type count() const { return count_; }
    void reset() { *this = direct_history(alpha_, past_); }
    std::size_t bytes() const { return (values_.size() + 1) * reversed_.size() * sizeof(S); }

private:
    void grow() {
        std::size_t const old = reversed_.size(), now = old == 0 ? 64 : 2 * old;
        detail::memory::line_vector<S> longer(now, S(0));
        std::copy(reversed_.begin(), reversed_.end(), longer.end() - static_cast<index_type>(old));
        reversed_ = std::move(longer);
        for (auto& values : values_) values.resize(now, S(0));
    }
    S alpha_;
    int size_;
    index_type count_ = 0;
    weight_sequence<G, S> weights_;
    detail::memory::line_vector<S> reversed_;            // ..., w_2, w_1 at its end
    std::vector<detail::memory::line_vector<S>> values_; // x_0, x_1, ... of each component
    V past_;
    detail::memory::sums<S> sums_;
};

/// The engine of a policy for the order alpha and values of the size of `like`. @throws error::invalid_parameter
template <generating_function G, class S, class V>
auto make_history(direct const&, S const& alpha, V const& like) {
    if constexpr (not detail::memory::same_scalar<S, V>)
        return detail::memory::scalars_differ<S, V>();
    else
        return direct_history<G, plain_t<V>>(alpha, like);
}

} // namespace hilger
