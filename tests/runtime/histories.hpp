// SPDX-License-Identifier: BSL-1.0
// What the tests of histories share: data, and the comparison of an engine with the sum as it is written.
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
        for (index i = 0; i < x.size(); ++i) x(i) = source.next<typename V::Scalar>();
        return x;
    } else
        return source.next<V>();
}
template <class V>
std::vector<V> random_values(index count) {
    noise source;
    std::vector<V> x;
    for (index i = 0; i < count; ++i) x.push_back(random_value<V>(source));
    return x;
}
/// sum_{n=1..m} w_n x_{m-n}, newest first, with nothing but + and *.
template <class S, class V>
V sum_as_written(std::vector<S> const& w, std::vector<V> const& x, index m) {
    V sum = x[0] * S(0);
    for (index n = 1; n <= m; ++n) sum = V(sum + x[static_cast<std::size_t>(m - n)] * w[static_cast<std::size_t>(n)]);
    return sum;
}

} // namespace hilger::testing
