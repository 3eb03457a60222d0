// SPDX-License-Identifier: BSL-1.0
// Diagnostics measure what they say: on data with known answers, and to the accuracy that the scalar allows.
#include <doctest/doctest.h>

#include "hilger/integrator/residual.hpp"
#include "hilger/trajectory/diagnostics.hpp"
#include "hilger/trajectory/recording.hpp"
#include "support/systems.hpp"

namespace diagnostics_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("drift of known data") {
    using point = state<Q, Q>;
    auto const e = [](auto const& x) { return x.q; };
    // Deviations from the means: t -3/2 -1/2 1/2 3/2, e -1 2 -3 2; products 3/2 - 1 - 3/2 + 3 = 2.
    auto const some = drift_along(std::vector<point>{{10, 4, 0}, {11, 7, 0}, {12, 2, 0}, {13, 7, 0}}, e);
    CHECK(some.largest == 3);
    CHECK(some.slope() == Q(2, 5));
    CHECK(some.time_square == 5);
    CHECK(some.error_square == 18);

    std::vector<state<double, double>> line, still;
    for (int i = 0; i < 100; ++i) {
        line.push_back({1e6 + i, 5 - 0.25 * i, 0});
        still.push_back({1.0 * i, 5, 0});
    }
    auto const straight = drift_along(line, e);
    CHECK(straight.largest == 0.25 * 99);
    CHECK(straight.slope() == doctest::Approx(-0.25).epsilon(1e-12));
    CHECK(straight.correlation() == doctest::Approx(-1).epsilon(1e-12));
    auto const none = drift_along(still, e);
    CHECK(none.largest == 0);
    CHECK(none.slope() == 0);
    CHECK(none.correlation() == 0);
}

TEST_CASE("energy, with the time in the Lagrangian too") {
    CHECK(energy(oscillator)(state<Q, Q>{0, 2, 5}) == Q(169, 18) + 2); // v^2/2 + x^2/2 with v = p - x/3
    auto const growing = [](auto const& t, auto const& x, auto const& v) { return v * v / 2 - t * x; };
    CHECK(energy(growing)(state<Q, Q>{7, 2, 5}) == Q(25, 2) + 14);
}

TEST_CASE("angular momentum is the momentum map of rotations, and is kept to rounding; translations are no symmetry") {
    auto const rotation = [](auto const& q) { return std::remove_cvref_t<decltype(q)>(-q(1), q(0)); };
    auto const translation = [](auto const& q) { return std::remove_cvref_t<decltype(q)>(1 + 0 * q(0), 0 * q(0)); };
    CHECK(momentum_map(rotation)(state<double, Eigen::Vector2d>{0, {2, 3}, {5, 7}}) == -1);
    auto const path = embed(kepler, mid_point).along(uniform(0.0, 0.02, 1000), Eigen::Vector2d(0.4, 0), Eigen::Vector2d(0, 2));
    CHECK(drift_along(path, momentum_map(rotation)).largest < 1000 * epsilon<double>());
    CHECK(drift_along(path, momentum_map(translation)).largest > 1);
}

TEST_CASE("the derivative of a step: exactly in the rationals, to epsilon^(4/5) elsewhere") {
    auto const flow = embed(oscillator, mid_point);
    auto const M = jacobian_of_step(flow, state<Q, Q>{0, 1, 2}, Q(1, 3));
    // In q and v = p - q/3 it is the Cayley transform of the harmonic oscillator, h/2 = 1/6: (35, 12; -12, 35)/37.
    CHECK(M(0, 0) == Q(31, 37));
    CHECK(M(0, 1) == Q(12, 37));
    CHECK(M(1, 0) == Q(-12, 37) + Q(31 - 35, 37) / 3);
    CHECK(M(1, 1) == Q(39, 37));
    CHECK(symplecticity_error(M) == 0);

    auto const bound = []<class S>(S const& epsilon) { return S(10 * pow(epsilon, S(4) / S(5))); };
    using std::pow;
    CHECK(symplecticity_error(jacobian_of_step(embed(pendulum, mid_point), state<float50, float50>{0, 1, float50(1) / 2},
                                               float50(1) / 10)) < bound(epsilon<float50>()));
    state<double, Eigen::Vector2d> const plane{0, {1, 0.1}, {0.1, 1}};
    CHECK(symplecticity_error(jacobian_of_step(embed(kepler, mid_point), plane, 0.1)) < 10 * std::pow(epsilon<double>(), 0.8));
    CHECK(symplecticity_error(jacobian_of_step(embed(kepler, order_one), plane, 0.1)) < 10 * std::pow(epsilon<double>(), 0.8));
}

TEST_CASE("what is not symplectic is seen") {
    Eigen::Matrix4d M = Eigen::Matrix4d::Identity();
    CHECK(symplecticity_error(M) == 0);
    M(0, 3) = M(1, 2) = 0.5; // a shear by a symmetric block
    CHECK(symplecticity_error(M) == 0);
    M(0, 3) = 0.75;
    CHECK(symplecticity_error(M) == 0.25);
    M(0, 3) = 0.5;
    M(2, 2) = 1.125;
    CHECK(symplecticity_error(M) == 0.125);
}

TEST_CASE("there and back") {
    state<float50, float50> const x{0, 1, float50(1) / 2};
    float50 const h = float50(1) / 10;
    auto const error = [&](auto const& method, auto const& adjoint) { return reversibility_error(method, adjoint, x, h); };
    CHECK(error(embed(pendulum, mid_point), embed(pendulum, mid_point)) < 8 * epsilon<float50>());
    CHECK(error(embed(pendulum, order_one), embed(pendulum, order_one_left)) < 8 * epsilon<float50>());
    CHECK(error(embed(pendulum, order_one), embed(pendulum, order_one)) > h * h / 10);
}

TEST_CASE("the residual of the equation along a recorded trajectory") {
    auto const residual = [](auto const& L, auto const& how, auto const& h) {
        constexpr unknown q;
        using S = std::remove_cvref_t<decltype(h)>;
        auto const T = uniform(S(0), h, 200);
        auto const EL = variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T)));
        return largest_residual(EL, record(embed(L, how).along(T, S(1), S(1) / S(2))).positions());
    };
    // |x| <= 2, and the equation divides by h^2.
    CHECK(residual(pendulum, mid_point, 0.1) < 16 * epsilon<double>() * 2 / 0.01);
    CHECK(residual(pendulum, mid_point, float50(1) / 10) < 16 * epsilon<float50>() * 2 * 100);
    CHECK(residual(pendulum, order_one, 0.1) > 1e-4); // that solves another equation
}

TEST_CASE("what is no number is not overlooked") {
    auto const e = [](auto const& x) { return x.q; };
    double const nan = std::numeric_limits<double>::quiet_NaN();
    using point = state<double, double>;
    CHECK(std::isnan(drift_along(std::vector<point>{{0, 1, 0}, {1, nan, 0}, {2, 5, 0}}, e).largest));
    Eigen::Matrix2d M;
    M << 1, nan, 0, 1;
    CHECK(std::isnan(symplecticity_error(M)));
}

TEST_CASE("the residual along a path is that of its equation, forces included") {
    auto const friction = [](auto const& t, auto const& q, auto const& v) { return -v / 3 + q * t; };
    auto const T = uniform(Q(0), Q(1, 5), 6);
    constexpr unknown q;
    auto const EL = variation(integral(oscillator(extend[q], Delta_o_plus[extend[q]]), half(T)));
    auto const path = embed(with_force(oscillator, friction), mid_point).along(T, Q(1), Q(1, 2));
    auto const x = record(path).positions();
    CHECK(largest_residual(path) == 0);
    CHECK(largest_residual(embed(with_force(oscillator, friction), mid_point), x) == 0);
    CHECK(largest_residual(EL, x, friction) == 0);
    CHECK(largest_residual(EL, x) > Q(1, 10)); // without its force it is another equation
    time_scale<Q> const given{Q(0), Q(1, 3), Q(1), Q(7, 5), Q(2), Q(9, 4)};
    CHECK(largest_residual(embed(with_force(oscillator, friction), theta<1, 3>).along(given, Q(1), Q(1, 2))) == 0);
    CHECK(largest_residual(embed(oscillator, order_one_left).along(without_last(given), Q(1), Q(1, 2))) == 0); // a part of a scale
}

} // namespace diagnostics_tests
