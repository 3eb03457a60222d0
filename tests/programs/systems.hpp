// SPDX-License-Identifier: BSL-1.0
// Systems of any number of degrees of freedom, as a user writes them: plain lambdas, with loops, branches and Eigen's functions.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "hilger/scalar.hpp"
#include "hilger/scale/time_scale.hpp"

namespace hilger::programs {

/// Steps that differ by a factor of ten.
inline time_scale<double> const uneven{0, 0.05, 0.1, 0.2, 0.22, 0.3, 0.5, 0.55, 0.6, 0.8, 0.9, 1.0, 1.2, 1.5};

inline constexpr auto pendulum = [](auto const& q, auto const& v) {
    using std::cos;
    return v * v / 2 + cos(q);
};
/// A row of masses that push each other and do not pull: a branch for each pair.
inline constexpr auto row_of_contacts = [](auto const& q, auto const& v) {
    auto L = v(0) * v(0) / 2 - q(0) * q(0) / 8;
    for (int k = 1; k < q.size(); ++k) {
        auto const r = q(k) - q(k - 1);
        L = L + v(k) * v(k) / 2 - q(k) * q(k) / 8;
        if (r < 0) L = L - 3 * r * r;
    }
    return L;
};
/// The mass depends on the position, and there is a term linear in v.
inline constexpr auto heavy_outside = [](auto const& q, auto const& v) {
    auto const mass = 1 + q.squaredNorm() / 4;
    return mass * v.squaredNorm() / 2 + (q(0) * v(1) - q(1) * v(0)) / 3 - q.dot(q) / 2;
};
/// Pulled along the first direction, in time.
inline constexpr auto pulled = [](auto const& t, auto const& q, auto const& v) {
    using std::sin;
    return v.dot(v) / 2 - q.dot(q) / 2 + q(0) * sin(2 * t);
};

/// A force that returns an expression of Eigen's, and one that returns a state.
inline constexpr auto drag = [](auto const& q, auto const& v) { return -v / 4 - q.dot(q) * v / 8; };
inline constexpr auto wind = [](auto const& t, auto const& q, auto const& v) {
    using std::cos;
    auto f = (-v / 4 + 0 * q).eval();
    f(0) = f(0) + cos(t);
    return f;
};

/// (1, 1/2, 1/3, ...) and (1/2, -1/4, 1/8, ...)
template <class V>
V place(int d = V::SizeAtCompileTime) {
    V q(d);
    for (int k = 0; k < d; ++k) q(k) = typename V::Scalar(1) / typename V::Scalar(k + 1);
    return q;
}
template <class V>
V push(int d = V::SizeAtCompileTime) {
    V p(d);
    typename V::Scalar x(1);
    for (int k = 0; k < d; ++k) p(k) = x = -x / typename V::Scalar(2);
    return p;
}

} // namespace hilger::programs
