// SPDX-License-Identifier: BSL-1.0
// The difference of order one of a sequence that is known by its increments d_n = x_n - x_{n-1}: omega(z)/omega(0) = (1 - z) p(z) / q(z),
// p(0) = q(0) = 1, so that
//   y_n = d_n + p_1 d_{n-1} + ... - q_1 y_{n-1} - ...
// No difference of positions is formed, whose rounding h^-order would enlarge: rounding here is relative to the increments.
#pragma once

#include <vector>

#include "hilger/history/component.hpp"
#include "hilger/operator/weights.hpp"

namespace hilger::detail {

template <generating_function G, class S, class V>
class whole_difference {
    using wide = typename wider<S>::type;
    static constexpr std::size_t P = std::tuple_size_v<decltype(G::template numerator<wide>())>;
    static constexpr std::size_t Q = std::tuple_size_v<decltype(G::template denominator<wide>())>;
    static_assert(P >= 2, "a generating function of derivatives vanishes at z = 1, and a constant does not");

public:
    explicit whole_difference(V const& like) : past_d_(P - 2, zero_like(like)), past_y_(Q - 1, zero_like(like)), y_(zero_like(like)) {
        auto const p = G::template numerator<wide>();
        auto const q = G::template denominator<wide>();
        wide sum(static_cast<int>(0));
        for (std::size_t i = 0; i < P; ++i) {
            sum = sum + p[i];
            if (i > 0 and i + 1 < P) p_.push_back(static_cast<S>(wide(sum / p[0])));
        }
        for (std::size_t j = 1; j < Q; ++j) q_.push_back(static_cast<S>(wide(q[j] / q[0])));
    }
    /// All increments before the first value are d.
    void begin(V const& d) {
        S sum_p(1), sum_q(1);
        for (S const& p : p_) sum_p = sum_p + p;
        for (S const& q : q_) sum_q = sum_q + q;
        for (V& x : past_d_) x = d;
        for (V& y : past_y_) y = d * S(sum_p / sum_q);
    }
    /// y_n if the increment is d.
    V const& at_next(V const& d) {
        y_ = d;
        for (std::size_t i = 0; i < p_.size(); ++i) y_ = y_ + past_d_[i] * p_[i];
        for (std::size_t j = 0; j < q_.size(); ++j) y_ = y_ - past_y_[j] * q_[j];
        return y_;
    }
    /// The last result of at_next.
    V const& value() const { return y_; }
    /// Appends the increment d, the argument of the last at_next.
    void push(V const& d) {
        shift(past_d_, d);
        shift(past_y_, y_);
    }
    /// Everything that later differences depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        for (V& d : past_d_) memory::visit_components("increment", d, each);
        for (V& y : past_y_) memory::visit_components("difference", y, each);
    }

private:
    static void shift(std::vector<V>& past, V const& x) {
        for (std::size_t i = past.size(); i-- > 1;) past[i] = past[i - 1];
        if (not past.empty()) past[0] = x;
    }
    std::vector<S> p_, q_;           // p_1, ..., q_1, ...
    std::vector<V> past_d_, past_y_; // d_{n-1}, ..., y_{n-1}, ...
    V y_;
};

} // namespace hilger::detail
