// SPDX-License-Identifier: BSL-1.0
// Fractional damping as a mean over the step: of order two against the equation that they are named after, from x_0 != 0 and
// v_0 != 0 too; its equation holds step by step; and it has no limit of stability.
#include <doctest/doctest.h>

#include "orders.hpp"
#include "support/systems.hpp"

namespace fractional_mean_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

template <generating_function G = grunwald_letnikov, class Order, class E = decltype(mid_point)>
void is_of_order_two(Order beta, E const& how = mid_point) {
    CAPTURE(beta.template as<double>());
    auto const [q, p] = orders_of(embed(with_fractional_damping<G>(spring, c, beta), how), beta, initial_history::caputo);
    CHECK(std::abs(q - 2) < 0.02);
    CHECK(std::abs(p - 2) < 0.02);
}

} // namespace

TEST_CASE("the reference is right: no damping, damping of order 1, and the table's own equation") {
    auto const free = fractional_oscillator<float50>{0, float50(1) / 2, 1, 2, 3, 0}.at(1);
    CHECK(abs(free.u - (2 * cos(float50(1)) + 3 * sin(float50(1)))) < float50("1e-47"));
    CHECK(abs(free.v - (3 * cos(float50(1)) - 2 * sin(float50(1)))) < float50("1e-47"));
    for (bool const caputo : {true, false}) { // u'' + 2 u' + u = 0, where D^1 of a jump is a kick
        auto const x = fractional_oscillator<float50>{2, 1, 1, 1, 1, 0, caputo}.at(1);
        CHECK(abs(x.u - exp(float50(-1)) * (1 + (caputo ? 2 : 0))) < float50("1e-47"));
    }
    auto const half = fractional_oscillator<float100>{1, float100(1) / 2, 1, 0, 0, 1}.at(5);
    CHECK(abs(half.u - float100("0.668914627671081225055583688085984709143740615")) < float100("1e-44"));
}

TEST_CASE("order two from x_0 and v_0 not zero, with weights of order one and of order two, below and above 1") {
    is_of_order_two(fraction<1, 4>{});
    is_of_order_two(fraction<1, 2>{});
    is_of_order_two(fraction<3, 4>{});
    is_of_order_two(fraction<1>{});
    is_of_order_two(fraction<3, 2>{});
    is_of_order_two<bdf<2>>(fraction<1, 2>{});
    is_of_order_two<bdf<2>>(fraction<3, 2>{});
    is_of_order_two<trapezoid>(fraction<1, 2>{});
    is_of_order_two(fraction<1, 2>{}, galerkin<2, gauss>);
    is_of_order_two(fraction<3, 2>{}, galerkin<3, lobatto>);
}

TEST_CASE("of order 1 it is mid-point with friction, exactly") {
    // All is linear, and h^1 a rational number.
    Q const rho(2, 5), h(1, 7);
    auto const friction = [&](auto const& x, auto const& v) { return -rho * v + 0 * x; };
    auto const T = uniform(Q(0), h, 6);
    auto const expected = record(embed(with_force(oscillator, friction), mid_point).along(T, Q(2, 3), Q(-1, 4))).states;
    CHECK(record(embed(with_fractional_damping(oscillator, rho, fraction<1>{}), mid_point).along(T, Q(2, 3), Q(-1, 4))).states == expected);
}

TEST_CASE("the equation is the judge: mean damping from the sums, half of its impulse at each end") {
    double const h = 0.125, rho = 0.5, beta = 0.5, theta = (1 + beta) / 2, x0 = 1.0;
    auto const flow = embed(with_fractional_damping(pendulum, rho, fraction<1, 2>{}), mid_point);
    std::vector<double> x, p;
    for (auto const& at : flow.along(uniform(0.0, h, 60), x0, 0.5)) x.push_back(at.q), p.push_back(at.p);
    auto const w = first_weights<grunwald_letnikov>(beta, 61);
    auto const difference = [&](std::size_t k) {
        double sum = 0;
        for (std::size_t n = 0; n <= k; ++n) sum += w[n] * (x[k - n] - x0);
        return sum / std::pow(h, beta);
    };
    for (std::size_t k = 0; k + 1 < x.size(); ++k) {
        double const F = -rho * (theta * difference(k + 1) + (1 - theta) * difference(k));
        double const v = (x[k + 1] - x[k]) / h, f = -std::sin((x[k + 1] + x[k]) / 2);
        CHECK(std::abs(p[k] + h / 2 * (f + F) - v) < 64 * epsilon<double>() / h);
        CHECK(std::abs(p[k + 1] - h / 2 * (f + F) - v) < 64 * epsilon<double>() / h);
    }
}

TEST_CASE("there is no limit of stability: far beyond that of impulses the energy of the oscillator falls") {
    // rho h^(2 - beta) 2^beta / M = 4 is the limit of explicit impulses.
    auto const falls = [](auto damped, auto const& how, double p0, double factor = 1) {
        double const start = (1 + p0 * p0) / 2;
        double reached = 0, last = 0;
        for (auto const& x : embed(damped, how).along(uniform(0.0, 0.5, 400), 1.0, p0)) {
            last = (x.p * x.p + x.q * x.q) / 2;
            reached = std::max(reached, last);
        }
        CHECK(reached <= factor * start * (1 + 1e-6)); // with rounding in increments that are 1e-9 of positions
        CHECK(last < start);
    };
    for (double const beta : {0.1, 0.5, 0.9, 1.0}) {
        CAPTURE(beta);
        double const limit = 4 / (std::pow(0.5, 2 - beta) * std::pow(2, beta));
        for (double const times : {1.1, 1e3, 1e9}) {
            CAPTURE(times);
            falls(with_fractional_damping(spring, times * limit, beta), mid_point, 1.0);
        }
        falls(with_fractional_damping<bdf<2>>(spring, 1e3 * limit, beta), mid_point, beta < 1 ? 1.0 : 0.0);
        falls(with_fractional_damping<trapezoid>(spring, 1e3 * limit, beta), mid_point, 1.0);
    }
    falls(with_fractional_damping(spring, 1e4, fraction<1, 2>{}), galerkin<2, gauss>, 1.0);
    falls(with_fractional_damping<bdf<2>>(spring, 1e4, 1.99), mid_point, 0.0);
    // Order one, right and left, has the limit h^2 K / M < 4 of its own, and no other. What it keeps is p^2 + q^2 -+ h p q.
    for (double const rho : {1.0, 1e4}) {
        falls(with_fractional_damping(spring, rho, fraction<1, 2>{}), order_one_left, 1.0, 1.25 / 0.75);
        falls(with_fractional_damping(spring, rho, fraction<1, 2>{}), order_one, 1.0, 1.25 / 0.75);
    }
}

TEST_CASE("with points inside the steps it is one curve by forces and by the equation") {
    // q v is the derivative of q^2 / 2: the same motion, with momenta p + q, and not by forces alone
    auto const gauged = [](auto const& q, auto const& v) { return spring(q, v) + q * v; };
    auto const states = [](auto const& l, double p0) {
        return record(embed(with_fractional_damping(l, 2.0, fraction<1, 2>{}), galerkin<2, gauss>).along(uniform(0.0, 0.25, 20), 1.0, p0))
            .states;
    };
    auto const by_forces = states(spring, 0.5), by_equation = states(gauged, 1.5);
    for (std::size_t i = 0; i < by_forces.size(); ++i) {
        CHECK(std::abs(by_forces[i].q - by_equation[i].q) <= 256 * epsilon<double>());
        CHECK(std::abs(by_forces[i].p + by_forces[i].q - by_equation[i].p) <= 256 * epsilon<double>());
    }
}

} // namespace fractional_mean_tests
