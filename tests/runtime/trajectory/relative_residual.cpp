// SPDX-License-Identifier: BSL-1.0
// The residual in units of the rounding of its own terms: alike for all steps, units and scalars along solutions, and huge beside them.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace relative_residual_tests {

using namespace hilger;

namespace {

constexpr lagrangian pendulum{[](auto const& x, auto const& v) { return v * v / 2 + cos(x); }};

/// That of 200 steps, and of the same with one position off by a part of 10^-6.
template <class S, class How>
void is_alike(How const& how, S const& h) {
    auto const T = uniform(S(0), h, 200);
    auto const EL = equation_of(embed(pendulum, how), T);
    auto const x = solve(EL, T, {.q0 = S(1), .v0 = S(1) / 2});
    double const good = static_cast<double>(relative_residual(EL, x));
    CAPTURE(h);
    CHECK(good <= 16);
    CHECK(good > 0);
    std::vector<value_of<decltype(x)>> off(x.begin(), x.end());
    off[off.size() / 2] += S(1) / 1000000;
    auto const bad = relative_residual(EL, function_on(x.scale(), off));
    CHECK(static_cast<double>(bad * epsilon<S>()) >= 1e-8);
}

} // namespace

TEST_CASE("it is a few epsilons for any step, in double and in 50 digits, and sees what is wrong") {
    for (double const h : {0.1, 1e-3, 1e-6}) {
        is_alike<double>(order_one, h);
        is_alike<double>(mid_point, h);
        is_alike<double>(galerkin<3, lobatto>, h);
        is_alike<float50>(mid_point, float50(h));
    }
}

TEST_CASE("terms that are large and cancel round as large ones") {
    constexpr lagrangian gauged{[](auto const& x, auto const& v) { return v * v / 2 + cos(x) + 1e6 * v; }}; // the same motions
    auto const T = uniform(0.0, 0.1, 200);
    auto const EL = equation_of(embed(gauged, mid_point), T);
    auto const x = solve(EL, T, {.q0 = 1.0, .v0 = 0.5});
    CHECK(relative_residual(EL, x) <= 16);
}

TEST_CASE("so do dampings that are large and cancel, and parts of compositions are judged as steps are") {
    for (double const h : {0.1, 1e-3, 1e-6}) {
        CAPTURE(h);
        auto const T = uniform(0.0, h, 100);
        for (double const rho : {0.2, 1e6})
            for (double const order : {0.5, 1.0, 1.5}) {
                CAPTURE(order);
                auto const damped = embed(with_fractional_damping(pendulum, {{rho, order}, {-rho, order}}), mid_point);
                CHECK(relative_residual(damped.along(T, 1.0, 0.5)) <= 64);
            }
        CHECK(relative_residual(embed(with_fractional_damping(pendulum, 0.2, 0.5), mid_point).along(T, 1.0, 0.5)) <= 64);
        CHECK(relative_residual(stoermer_verlet(pendulum).along(T, 1.0, 0.5)) <= 64);
    }
}

} // namespace relative_residual_tests
