// SPDX-License-Identifier: BSL-1.0
// The shape of a state: a scalar, or an Eigen vector of fixed or dynamic size d; and the d x d matrices that act on it.
#pragma once

#include <array>

#include <Eigen/Core>

#include "hilger/error.hpp"
#include "hilger/scalar.hpp"

namespace hilger {

namespace detail {

template <class V>
struct shape { // scalars
    using scalar_type = V;
    using block = V;
    static constexpr int size = 1;
    static constexpr bool is_scalar = true;
    template <class D>
    using with = D;
    static constexpr int dimension(V const&) { return 1; }
    template <class X>
    static constexpr X& component(X& x, int) {
        return x;
    }
    template <class B>
    static constexpr B& entry(B& b, int, int) {
        return b;
    }
    static constexpr V zero(int) { return V(0); }
    static constexpr block zero_block(int) { return V(0); }
};
template <class S, int D, int O, int M>
struct shape<Eigen::Matrix<S, D, 1, O, M, 1>> {
    using scalar_type = S;
    using vector = Eigen::Matrix<S, D, 1, O, M, 1>;
    using block = Eigen::Matrix<S, D, D>;
    static constexpr int size = D; ///< Eigen::Dynamic when known at run time only
    static constexpr bool is_scalar = false;
    template <class T>
    using with = Eigen::Matrix<T, D, 1, O, M, 1>;
    static int dimension(vector const& x) { return static_cast<int>(x.size()); }
    template <class X>
    static decltype(auto) component(X& x, int k) {
        return x(k);
    }
    template <class B>
    static decltype(auto) entry(B& b, int j, int k) {
        return b(j, k);
    }
    static vector zero(int d) { return vector::Zero(d); }
    static block zero_block(int d) { return block::Zero(d, d); }
};

template <class V>
bool all_finite(V const& x) {
    for (int k = 0; k < shape<V>::dimension(x); ++k)
        if (not is_finite(shape<V>::component(x, k))) return false;
    return true;
}

/// The magnitudes of the components.
template <class V>
V sizes(V const& x) {
    if constexpr (requires { x.size(); })
        return x.cwiseAbs();
    else
        return magnitude(x);
}

/// @throws error::mismatch when two parts of a state have different lengths.
template <class V>
void require_same_dimension(V const& x, V const& y, char const* what) {
    if (shape<V>::dimension(x) != shape<V>::dimension(y))
        error::raise<error::mismatch>(what, " have one dimension, and these have ", shape<V>::dimension(x), " and ",
                                      shape<V>::dimension(y));
}

} // namespace detail

/// The scalar that a state is made of, and the matrices that act on it.
template <class V>
using scalar_of = typename detail::shape<V>::scalar_type;
template <class V>
using block_of = typename detail::shape<V>::block;

} // namespace hilger
