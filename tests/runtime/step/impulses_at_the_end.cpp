// SPDX-License-Identifier: BSL-1.0
// Where the position of dL/dq is the end of the step, its impulse is read once the velocity is known, however Newton's iteration ended: by
// small corrections, or by a residual that is rounding already, as where a momentum has a large part that is no velocity.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace impulses_at_the_end_tests {

using namespace hilger;

namespace {

constexpr double B = 1.3, E = 1e-3;
/// A charge in a magnetic field B across the plane and an electric one E along q_0; what is beside it falls.
constexpr auto charge = [](auto const& q, auto const& v) {
    auto sum = v.squaredNorm() / 2 + B / 2 * (q(0) * v(1) - q(1) * v(0)) + E * q(0);
    for (int k = 2; k < q.size(); ++k) sum = sum + E * q(k);
    return sum;
};
/// Falls too, with q^2 v = d/dt q^3/3 beside it, which changes the momentum and nothing else.
constexpr auto falling = [](auto const& q, auto const& v) { return v * v / 2 + q * q * v + E * q; };

template <class State>
auto force_on(State const& q, State const& v) {
    return gradient_first(charge, q, v);
}
double force_on(double q, double v) { return gradient_first(falling, q, v); }

double size_of(double x) { return std::abs(x); }
template <class State>
double size_of(State const& x) {
    return x.cwiseAbs().maxCoeff();
}

/// p_{i+1} - p_i = h dL/dq(q_{i+1}, v_i), v_i = (q_{i+1} - q_i)/h, to what rounding q and p does to it.
template <class Embedding, class L, class State>
void gives_each_impulse(Embedding const& how, L const& of_charge, State const& at) {
    CAPTURE(how.name);
    double const h = 1e-4;
    auto const T = uniform(0.0, h, 50);
    State const p0 = gradient_second(of_charge, at, State(at - at));
    auto const starts_at_rest = [&](auto const& walk) {
        double most = 0;
        State q = at, p = p0;
        for (auto const& x : walk) {
            if (x.t > 0) {
                State const v = (x.q - q) / h;
                most = std::max(most, size_of(State(x.p - p - h * force_on(x.q, v))));
            }
            q = x.q;
            p = x.p;
        }
        CHECK(most <= 8 * std::numeric_limits<double>::epsilon() * (size_of(at) + size_of(p0)));
    };
    starts_at_rest(embed(of_charge, how).along(T, at, p0));
    starts_at_rest(embed(of_charge, how, compensated).along(T, at, p0));
}

} // namespace

TEST_CASE("an impulse at the end of a step is not lost where the momentum is mostly no velocity") {
    gives_each_impulse(order_one_left, falling, 0.7);
    gives_each_impulse(order_one_left, charge, Eigen::Vector2d(0.7, 0.4));
    gives_each_impulse(order_one_left, charge, Eigen::Vector3d(0.7, 0.4, 0.3));
    gives_each_impulse(order_one_left, charge, Eigen::Vector4d(0.7, 0.4, 0.3, 0.2));
}

TEST_CASE("a charge that starts from rest drifts") {
    // x - x_0 = E/B^2 (1 - cos B t), to what order one leaves: E t^2/2 times h/t
    double const h = 1e-4;
    auto const T = uniform(0.0, h, 50);
    Eigen::Vector2d const q(0.7, 0.4), p = gradient_second(charge, q, Eigen::Vector2d(0, 0));
    double const t = 50 * h, far = E / (B * B) * (1 - std::cos(B * t));
    Eigen::Vector2d end = q;
    for (auto const& x : embed(charge, order_one_left).along(T, q, p)) end = x.q;
    CHECK(std::abs(end(0) - q(0) - far) <= far * 1.5 * h / t);
    CHECK(std::abs(end(1) - q(1)) <= far * B * t);
}

} // namespace impulses_at_the_end_tests
