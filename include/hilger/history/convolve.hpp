// SPDX-License-Identifier: BSL-1.0
// All fractional differences of a finite sequence at once, sum_{n=0..k} w_n x_{k-n} for every k, by one transform long enough that
// nothing wraps around: every point is right, not only the last.
#pragma once

#include "hilger/history/component.hpp"
#include "hilger/history/fourier.hpp"
#include "hilger/operator/weights.hpp"

namespace hilger {

namespace detail {

inline std::size_t power_of_two_from(std::size_t n) {
    std::size_t power = 1;
    while (power < n) power *= 2;
    return power;
}

} // namespace detail

/// y_k = sum_{n=0..k} w_n x_{k-n}, without the leading weight and h^-alpha. O(N log N) products and an error of some epsilon of
/// sum |w_n| max |x|; exact scalars by the sum as it is written. @throws error::invalid_parameter, error::mismatch, error::not_finite
template <generating_function G, class S, class V>
std::vector<V> convolve(S const& alpha, std::vector<V> const& x) {
    static_assert(std::is_same_v<S, detail::component_t<V>>, "the order of a fractional difference and the values have the same scalar");
    if (x.empty()) return {};
    index const size = detail::components(x[0]);
    for (std::size_t k = 0; k < x.size(); ++k) detail::check_value(x[k], size, static_cast<index>(k));
    auto const w = first_weights<G, S>(alpha, static_cast<index>(x.size()));
    std::vector<V> y(x.size(), detail::zero_of_size(x[0]));
    if constexpr (std::numeric_limits<S>::is_exact) {
        for (std::size_t k = 0; k < x.size(); ++k)
            for (std::size_t n = 0; n <= k; ++n) y[k] = V(y[k] + x[k - n] * w[n]);
    } else {
        std::size_t const length = detail::power_of_two_from(x.size()); // modulo z^{2 length} + 1
        detail::fourier<S> transform;
        detail::spectrum<S> weights, values;
        weights.re.assign(length, S(0));
        weights.im.assign(length, S(0));
        S const scale = S(1) / S(static_cast<double>(length)); // a power of two
        for (std::size_t n = 0; n < w.size(); ++n) weights.re[n] = w[n] * scale;
        transform.forward(weights, length);
        for (index c = 0; c < size; ++c) {
            values.re.assign(length, S(0));
            values.im.assign(length, S(0));
            for (std::size_t k = 0; k < x.size(); ++k) values.re[k] = detail::component(x[k], c);
            transform.forward(values, length);
            transform.multiply(values, weights, length);
            transform.backward(values, length);
            for (std::size_t k = 0; k < x.size(); ++k) detail::component(y[k], c) = values.re[k];
        }
    }
    return y;
}

} // namespace hilger
