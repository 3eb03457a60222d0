// SPDX-License-Identifier: BSL-1.0
// The lambda-antiderivative F(t) = int_a^t f Delta_lambda, C(T_lambda) -> C(T) (Cresson-Safi, definition 7), its adjoint, the integral from
// t to b, and definite integrals between any two points of T, in either order.
#pragma once

#include "hilger/error_free.hpp"
#include "hilger/operator/transfer.hpp"

namespace hilger {

namespace detail {

/// A sum of values that are linear in a floating scalar, with the error of two additions however many there are: the rounding errors are
/// summed beside it (Neumaier 1974, without comparisons). Exact values are simply added.
template <class V, class S>
class running_sum {
    static constexpr bool rounds = std::numeric_limits<S>::is_specialized and not std::numeric_limits<S>::is_exact;

public:
    constexpr explicit running_sum(V const& zero) : sum_(zero), rest_(zero) {}
    constexpr void add(V const& y) {
        if constexpr (rounds) {
            V rest = y;
            two_sum(sum_, rest, sum_, rest);
            rest_ = rest_ + rest;
        } else
            sum_ = sum_ + y;
    }
    /// An infinite sum stays infinite.
    constexpr V value() const {
        if constexpr (rounds)
            return is_finite(rest_) ? V(sum_ + rest_) : sum_;
        else
            return sum_;
    }

private:
    V sum_, rest_;
};

} // namespace detail

/// int_a^t f Delta_lambda for t in T. A value is a sum over the points before it, formed at each access; tabulate(antiderivative[f]) forms
/// each from the one before it.
template <class Lambda>
struct antiderivative_at : linear_operator<antiderivative_at<Lambda>> {
    using from = between<Lambda>;
    using to = nodes;
    using from_weight = step_weight;
    using to_weight = nabla_weight;
    [[no_unique_address]] Lambda lambda{};
    static constexpr reach reads = reach::causal(-0.5).at<nodes>();
    static constexpr auto name() { return fixed_text("antiderivative"); }
    template <int F, int B>
    constexpr auto image(domain<from, F, B> const&) const {
        if constexpr (F > 0)
            does_not_compile<"antiderivative starts at the first point, and this function lives on " + domain<from, F, B>::name()>{};
        return domain<nodes, 0, B>{};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        detail::running_sum<value_of<F>, typename F::root_type::scalar_type> total(zero_of(f));
        for (index_type k = 0; k < i; ++k) total.add(evaluated(f.get(k) * f.root().step(k)));
        return total.value();
    }
    template <class F, class Use>
    constexpr void evaluate_all(F const& f, Use const& use) const {
        detail::running_sum<value_of<F>, typename F::root_type::scalar_type> total(zero_of(f));
        index_type const last = image(f.domain()).last(f.root());
        for (index_type k = 0; k <= last; ++k) {
            if (k > 0) total.add(evaluated(f.get(k - 1) * f.root().step(k - 1)));
            use(total.value());
        }
    }
    constexpr auto adjoint() const;
};

/// int_t^b g nabla on T_lambda: the sum of g over the points after t_{i,lambda} where g is defined.
template <class Lambda>
struct tail_integral_at : linear_operator<tail_integral_at<Lambda>> {
    using from = nodes;
    using to = between<Lambda>;
    using from_weight = nabla_weight;
    using to_weight = step_weight;
    [[no_unique_address]] Lambda lambda{};
    static constexpr reach reads = reach::anticausal(-0.5).at<to>();
    static constexpr auto name() { return fixed_text("tail_integral"); }
    template <int F, int B>
    constexpr auto image(domain<nodes, F, B> const&) const {
        return domain<to, std::max(F - 1, 0), std::max(B - 1, 0)>{{lambda}};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        index_type const last = f.domain().last(f.root());
        detail::running_sum<value_of<F>, typename F::root_type::scalar_type> total(zero_of(f));
        for (index_type k = i + 1; k <= last; ++k) total.add(evaluated(f.get(k) * f.root().step(k - 1)));
        return total.value();
    }
    constexpr auto adjoint() const { return antiderivative_at<Lambda>{{}, lambda}; }
};

template <class Lambda>
constexpr auto antiderivative_at<Lambda>::adjoint() const {
    return tail_integral_at<Lambda>{{}, lambda};
}

/// int_a^t f Delta_half, from T_half to T.
inline constexpr antiderivative_at<fraction<1, 2>> antiderivative_h{};
/// int_a^t f Delta, from T^+ to T, and int_a^t f nabla, from T^- to T.
inline constexpr auto antiderivative = antiderivative_at<fraction<0>>{} * projection<fraction<0>, true>{};
inline constexpr auto antiderivative_nabla = antiderivative_at<fraction<0>>{} * projection<fraction<0>, true>{} * sigma;

} // namespace hilger
