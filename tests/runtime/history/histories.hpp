// SPDX-License-Identifier: BSL-1.0
// What the tests of histories share: data, and the sum as it is written.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "hilger/history/history.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::testing {

/// Numbers between -1 and 1 with few digits, the same in every scalar.
class noise {
public:
    template <class S>
    S next() {
        state_ = state_ * 1664525U + 1013904223U;
        return S(static_cast<int>(state_ >> 16) - 32768) / S(32768);
    }

private:
    unsigned state_ = 1;
};

template <class V>
V random_value(noise& source) {
    if constexpr (requires { typename V::Scalar; }) {
        V x = V::Zero(3);
        for (index_type i = 0; i < x.size(); ++i) x(i) = source.next<typename V::Scalar>();
        return x;
    } else
        return source.next<V>();
}
template <class V>
std::vector<V> random_values(index_type count) {
    noise source;
    std::vector<V> x;
    for (index_type i = 0; i < count; ++i) x.push_back(random_value<V>(source));
    return x;
}
/// Where sums are made to compare with: no rounding of theirs is seen in S.
template <class S>
struct wider_scalar {
    using type = S;
};
template <>
struct wider_scalar<float> {
    using type = double;
};
template <>
struct wider_scalar<double> {
    using type = long double;
};

/// sum_{n=1..m} w_n x_{m-n} for m = 1, ..., N by nothing but + and *, component after component, rounded to S once.
template <class G, class V>
std::vector<V> sums_as_written(scalar_of<V> const& alpha, std::vector<V> const& x) {
    using S = scalar_of<V>;
    using W = typename wider_scalar<S>::type;
    auto const w = first_weights<G, S>(alpha, static_cast<index_type>(x.size()) + 1);
    std::vector<V> sums(x.size(), x[0]);
    std::vector<W> values(x.size()), weights(w.begin(), w.end());
    W const *const a = weights.data(), *const b = values.data(); // where nothing is optimised, a call less for each
    for (int c = 0; c < detail::shape<V>::dimension(x[0]); ++c) {
        for (std::size_t k = 0; k < x.size(); ++k) values[k] = W(detail::shape<V>::component(x[k], c));
        for (std::size_t m = 1; m <= x.size(); ++m) {
            W sum(0);
            for (std::size_t n = 1; n <= m; ++n) sum = sum + a[n] * b[m - n];
            detail::shape<V>::component(sums[m - 1], c) = static_cast<S>(sum);
        }
    }
    return sums;
}

} // namespace hilger::testing
