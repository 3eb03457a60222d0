// SPDX-License-Identifier: BSL-1.0
// Derivatives of an action as S (54) defines them: from values of the action alone, without the library's derivatives. In the rationals
// they are exact, in 100 digits right to 1e-76.
#pragma once

#include <random>
#include <utility>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::papers {

template <class S>
using plane = Eigen::Matrix<S, 2, 1>;

/// ds/de at e = 0 from four values. The formula's error is e^4 s^(5) / 30: none for polynomials of degree 4, whatever e is. That of the
/// values is epsilon |s| / e, so that e = 1e-20 makes both 1e-80 times numbers of the size of s; 1e4 is left for those (1e-79
/// is the largest error seen).
template <class S>
struct difference;
template <>
struct difference<Q> {
    Q step{1}, error{0};
};
template <>
struct difference<float100> {
    float100 step{"1e-20"}, error{"1e-76"};
};
template <class S, class Curve>
S slope_at_zero(Curve const& s) {
    S const e = difference<S>{}.step;
    return S((8 * (s(e) - s(S(-e))) - (s(S(2 * e)) - s(S(-2 * e)))) / (12 * e));
}
template <class S>
bool vanishes(S const& x) {
    return magnitude(x) <= difference<S>{}.error;
}

/// Values in general position, the same in every run.
template <class V>
V some_value(std::mt19937& random) {
    V x = detail::shape<V>::zero(2);
    for (int c = 0; c < detail::shape<V>::dimension(x); ++c)
        detail::shape<V>::component(x, c) = scalar_of<V>(static_cast<int>(random() % 19) - 9) / 8;
    return x;
}
template <class V, class Scale>
auto some_function(Scale const& T, std::mt19937& random) {
    std::vector<V> x;
    for (index_type i = 0; i < T.size(); ++i) x.push_back(some_value<V>(random));
    return function_on(T, x);
}
/// Of the space of variations (53): zero at a and b.
template <class V, class Scale>
auto some_variation(Scale const& T, std::mt19937& random) {
    std::vector<V> x;
    for (index_type i = 0; i < T.size(); ++i) x.push_back(some_value<V>(random));
    x.front() = x.back() = zero_like(x.front());
    return function_on(T, x);
}
/// Component c of the value at t_k is 1, all others are 0.
template <class V, class Scale>
auto unit(Scale const& T, index_type k, int c = 0) {
    std::vector<V> x(static_cast<std::size_t>(T.size()), detail::shape<V>::zero(2));
    detail::shape<V>::component(x[static_cast<std::size_t>(k)], c) = scalar_of<V>(1);
    return function_on(T, x);
}

/// The positions and the momenta of a flow, as functions on T.
template <class Flow, class Scale, class V>
auto trajectory_of(Flow const& flow, Scale const& T, initial_velocity<V> const& from) {
    std::vector<V> q, p;
    for (auto const& at : flow.along(T, from)) {
        q.push_back(at.q);
        p.push_back(at.p);
    }
    return std::pair(function_on(T, q), function_on(T, p));
}

/// Both sides of theorem 2, (67), for some q and some w in V: the derivative of the action at q along w by its definition, and the sum of h
/// times the Euler-Lagrange residual times w.
template <class V>
struct pairing {
    scalar_of<V> derivative, of_residual;
};
template <class V, class Action>
pairing<V> pair_with_residual(Action const& action, std::mt19937& random) {
    using S = scalar_of<V>;
    auto const x = some_function<V>(action.T, random);
    auto const w = some_variation<V>(action.T, random);
    return {slope_at_zero<S>([&](S const& e) { return S(action(x + e * w)); }),
            weighted_sum<delta_weight>(dot(variation(action).residual(x), w))};
}
/// (64), corrected: the residual of Wendlandt and Marsden's equation at an inner point, with L_h(x, y) = h L((x + y)/2, (y - x)/h).
template <class L, class X>
auto wendlandt_marsden(L const& lagrangian, X const& x, index_type i) {
    auto const h = x.root().h();
    auto const L_h = [&](auto const& a, auto const& b) { return lagrangian.function((a + b) / decltype(h)(2), (b - a) / h) * h; };
    using V = std::remove_cvref_t<decltype(x[i])>;
    return V(gradient_first(L_h, x[i], x[i + 1]) + gradient_second(L_h, x[i - 1], x[i]));
}

/// Quadratic, so that steps are exact in the rationals; with a magnetic term, so that p is not v and L is not separable.
inline constexpr lagrangian magnetic{[](auto const& x, auto const& v) {
    return v.dot(v) / 2 + v(0) * v(1) / 5 + (x(0) * v(1) - 2 * x(1) * v(0)) / 3 - x(0) * x(0) / 2 - x(0) * x(1) / 4 - x(1) * x(1);
}};
/// Neither separable nor polynomial.
inline constexpr lagrangian bead{[](auto const& x, auto const& v) { return v * v * (1 + x * x) / 2 + v * x * x / 3 + 1 / (1 + x * x); }};

/// A polynomial in the plane, with a magnetic term: its derivatives are exact in the rationals, its steps are not.
inline constexpr lagrangian plane_cubic{
    [](auto const& x, auto const& v) { return v.dot(v) / 2 + x(0) * v(1) - x(1) * x(1) * v(0) / 3 - x.dot(x) * x(0) / 5; }};

} // namespace hilger::papers
