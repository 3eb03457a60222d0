// SPDX-License-Identifier: BSL-1.0
// Short memory: the last values only, sum_{n=1..min(m, length)} w_n x_{m-n}, and a bound on what is cut off.
#pragma once

#include <algorithm>
#include <cmath>

#include "hilger/history/direct.hpp"
#include "hilger/history/modes.hpp"
#include "hilger/history/recent.hpp"

namespace hilger {

/// The last `length` values.
struct window {
    index_type length;
    static constexpr bool keeps_everything = false;
};

template <class G, class V>
class window_history {
    using S = detail::memory::component_t<V>;

public:
    window_history(window const& policy, S const& alpha, V const& like)
        : window_history(alpha, policy.length, weights(alpha, policy.length), like) {}

    /// sum_{n=1..length} w_n x_{m-n} after m values; without the leading weight and h^-alpha.
    V const& past() const { return past_; }
    /// @throws error::mismatch, error::not_finite
    void push(V const& x) {
        detail::memory::check_value(x, size_, count_);
        for (index_type c = 0; c < size_; ++c) {
            auto const i = static_cast<std::size_t>(c);
            detail::memory::component(past_, c) = recent_.first() * detail::memory::component(x, c) + ahead_[i];
            ahead_[i] = recent_.push(detail::memory::component(x, c), c, sums_);
        }
        recent_.advance();
        ++count_;
    }
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("values", count_);
        recent_.visit(each);
        for (S& x : ahead_) each("ahead", x);
        detail::memory::visit_components("past", past_, each);
    }
    index_type count() const { return count_; }
    void reset() {
        recent_.reset();
        ahead_.assign(ahead_.size(), S(0));
        past_ = detail::memory::zero_of_size(past_);
        count_ = 0;
    }
    /// At least sum_{n > length} |w_n| max |x|, whatever the number of values, and equal to it but for rounding where the weights beyond
    /// the window have one sign. For Gruenwald-Letnikov and length >= alpha > 0 it is |(1 - alpha)(1 - alpha/2)...(1 - alpha/length)| times
    /// the magnitude. @throws error::invalid_parameter for alpha < 0, where the sum does not end
    S error_estimate(S const& magnitude) const requires strongly_damped<G> {
        if (alpha_ < S(0)) error::raise<error::invalid_parameter>("what a window cuts off has no bound for the order ", alpha_, " < 0");
        auto const absolute = [](S const& x) { return x < S(0) ? S(-x) : x; };
        S bound(0);
        if constexpr (parasitic_root<G>::modulus == 0) { // w_0 + ... + w_n is the n-th weight of the order alpha - 1
            index_type n = 1;
            S sum = S(1);
            for (; n <= length_ or S(static_cast<int>(n)) < alpha_; ++n) {
                S const before = sum;
                sum = sum * (S(1) - alpha_ / S(static_cast<int>(n)));
                if (n > length_) bound = bound + absolute(S(sum - before)); // |w_n| whose sign is not yet that of the rest
            }
            bound = bound + absolute(sum);
        } else { // all weights sum up to omega(1)^alpha = 0; from `settled` on they have one sign
            auto const settled = std::max(length_, static_cast<index_type>(40 / -std::log(parasitic_root<G>::modulus)));
            auto const w = first_weights<G, S>(alpha_, settled + 1);
            S sum(0);
            for (index_type n = 0; n <= settled; ++n) {
                sum = sum + w[static_cast<std::size_t>(n)];
                if (n > length_) bound = bound + absolute(w[static_cast<std::size_t>(n)]);
            }
            bound = bound + absolute(sum) + S(8) * epsilon<S>();
        }
        return bound * magnitude;
    }
    std::size_t bytes() const { return recent_.bytes() + ahead_.size() * sizeof(S); }
    static std::string name() { return "window"; }

private:
    static std::vector<S> weights(S const& alpha, index_type length) {
        if (length < 0) error::raise<error::invalid_parameter>("a window has a length of 0 or more, not ", length);
        auto w = first_weights<G, S>(alpha, length + 1);
        w.erase(w.begin());
        return w;
    }
    window_history(S const& alpha, index_type length, std::vector<S> const& w, V const& like)
        : alpha_(alpha), length_(length), size_(detail::memory::components(like)), recent_(w, size_),
          ahead_(static_cast<std::size_t>(size_), S(0)), past_(detail::memory::zero_of_size(like)) {}

    S alpha_;
    index_type length_, size_, count_ = 0;
    detail::memory::recent_values<S> recent_;
    std::vector<S> ahead_;
    V past_;
    detail::memory::sums<S> sums_;
};

/// @throws error::invalid_parameter for a negative length.
template <generating_function G, class S, class V>
auto make_history(window const& policy, S const& alpha, V const& like) {
    if constexpr (not detail::memory::same_scalar<S, V>)
        return detail::memory::scalars_differ<S, V>();
    else
        return window_history<G, plain_t<V>>(policy, alpha, like);
}

} // namespace hilger
