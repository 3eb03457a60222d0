// SPDX-License-Identifier: BSL-1.0
// Exact first and second derivatives of a generic function of two arguments x and y, scalars or Eigen vectors of fixed size d, by
// dual numbers. Gradients are columns like x; Hessian blocks are d x d, entry (j, k) = second derivative by component j of the
// first and k of the second named argument. For scalars all of them are scalars.
#pragma once

#include "hilger/mechanics/dual.hpp"

namespace hilger {

namespace detail {

template <class V>
struct shape { // scalars
    using scalar_type = V;
    using block = V;
    static constexpr int size = 1;
    template <class D>
    using with = D;
    static constexpr V const& component(V const& x, int) { return x; }
    template <class D>
    static constexpr D& component(D& x, int) {
        return x;
    }
    static constexpr V& entry(block& b, int, int) { return b; }
};
template <class S, int D>
struct shape<Eigen::Matrix<S, D, 1>> {
    static_assert(D != Eigen::Dynamic, "a state has a fixed dimension: use Eigen::Matrix<S, d, 1>");
    using scalar_type = S;
    using block = Eigen::Matrix<S, D, D>;
    static constexpr int size = D;
    template <class T>
    using with = Eigen::Matrix<T, D, 1>;
    template <class X>
    static decltype(auto) component(X& x, int k) {
        return x(k);
    }
    static S& entry(block& b, int j, int k) { return b(j, k); }
};

/// x with component k replaced by x_k + e_k, in dual numbers over Inner.
template <class Outer, class V>
auto seeded(V const& x) {
    using s = shape<V>;
    typename s::template with<Outer> y;
    for (int k = 0; k < s::size; ++k) s::component(y, k) = Outer::variable(s::component(x, k), k);
    return y;
}
/// x as constants of type Number.
template <class Number, class V>
auto lifted(V const& x) {
    using s = shape<V>;
    typename s::template with<Number> y;
    for (int k = 0; k < s::size; ++k) s::component(y, k) = Number(s::component(x, k));
    return y;
}
template <class V, class D>
V partials(D const& value) {
    using s = shape<V>;
    V g;
    for (int k = 0; k < s::size; ++k) s::component(g, k) = value.partial[static_cast<std::size_t>(k)];
    return g;
}

} // namespace detail

/// The scalar that a state is made of, and the matrices that act on it.
template <class V>
using scalar_of = typename detail::shape<V>::scalar_type;
template <class V>
using block_of = typename detail::shape<V>::block;

/// df/dx (x, y)
template <class F, class V, class W>
V gradient_first(F const& f, V const& x, W const& y) {
    using D = dual<scalar_of<V>, detail::shape<V>::size>;
    return detail::partials<V>(D(f(detail::seeded<D>(x), detail::lifted<D>(y))));
}
/// df/dy (x, y)
template <class F, class V, class W>
W gradient_second(F const& f, V const& x, W const& y) {
    using D = dual<scalar_of<W>, detail::shape<W>::size>;
    return detail::partials<W>(D(f(detail::lifted<D>(x), detail::seeded<D>(y))));
}

/// Everything a step of a variational integrator needs of f(x, y), in one evaluation.
template <class V>
struct mixed_derivatives {
    V first;           ///< df/dx
    V second;          ///< df/dy
    block_of<V> mixed; ///< d2f / dx dy
};
template <class F, class V>
mixed_derivatives<V> mixed_second(F const& f, V const& x, V const& y) {
    using s = detail::shape<V>;
    using S = scalar_of<V>;
    using I = dual<S, s::size>;
    using O = dual<I, s::size>;
    typename s::template with<O> xs, ys;
    for (int k = 0; k < s::size; ++k) {
        s::component(xs, k) = O(I::variable(s::component(x, k), k));
        s::component(ys, k) = O::variable(I(s::component(y, k)), k);
    }
    O const value = f(xs, ys);
    mixed_derivatives<V> d;
    for (int j = 0; j < s::size; ++j) {
        s::component(d.first, j) = value.value.partial[static_cast<std::size_t>(j)];
        s::component(d.second, j) = value.partial[static_cast<std::size_t>(j)].value;
        for (int k = 0; k < s::size; ++k)
            s::entry(d.mixed, j, k) = value.partial[static_cast<std::size_t>(k)].partial[static_cast<std::size_t>(j)];
    }
    return d;
}

/// df/dy and d2f/dy2 at (x, y).
template <class V>
struct second_derivatives {
    V gradient;
    block_of<V> hessian;
};
template <class F, class V>
second_derivatives<V> second_in_second(F const& f, V const& x, V const& y) {
    using s = detail::shape<V>;
    using I = dual<scalar_of<V>, s::size>;
    using O = dual<I, s::size>;
    typename s::template with<O> ys;
    for (int k = 0; k < s::size; ++k) s::component(ys, k) = O::variable(I::variable(s::component(y, k), k), k);
    O const value = f(detail::lifted<O>(detail::lifted<I>(x)), ys);
    second_derivatives<V> d;
    for (int j = 0; j < s::size; ++j) {
        s::component(d.gradient, j) = value.partial[static_cast<std::size_t>(j)].value;
        for (int k = 0; k < s::size; ++k)
            s::entry(d.hessian, j, k) = value.partial[static_cast<std::size_t>(k)].partial[static_cast<std::size_t>(j)];
    }
    return d;
}

} // namespace hilger
