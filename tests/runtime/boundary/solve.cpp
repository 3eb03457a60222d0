// SPDX-License-Identifier: BSL-1.0
// Two-sided problems of the fractional embedding: exact solutions, limits h -> 0, and what is refused.
#include <doctest/doctest.h>

#include "hilger/boundary/solve.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/two_sided.hpp"

namespace boundary_tests {

using namespace hilger;
using testing::two_sided;

namespace {

constexpr auto dirichlet = [](auto const&, auto const& v) { return v * v / 2; };
template <class S>
using plane = Eigen::Matrix<S, 2, 1>;

/// Q at t = 1/2 for L = v^2/2 on [0, 1] with Q_N = 1.
float50 at_middle(float50 const& alpha, int N, int first) {
    auto const T = uniform(interval{float50(0), float50(1)}, N);
    return solve(two_sided(dirichlet, alpha, T), T, boundary_values{first, 1})[N / 2];
}

} // namespace

TEST_CASE("L = v^2/2 is solved exactly: straight lines for alpha = 1, and rationals for h = 1 and any alpha") {
    auto const T = uniform(Q(-1, 3), Q(2, 7), 9);
    auto const line = solve(two_sided(dirichlet, Q(1), T), T, boundary_values{Q(1, 2), Q(-3)}, boundary_options{});
    for (hilger::index_type k = 0; k <= 9; ++k) CHECK(line.q[k] == Q(1, 2) + (Q(-3) - Q(1, 2)) * k / 9);
    CHECK(line.residual == 0);
    CHECK(line.iterations == 0);
    for (Q const& alpha : {Q(3, 4), Q(1, 2), Q(1, 5)})
        for (int N : {1, 2, 3, 12}) {
            auto const one = uniform(Q(0), Q(1), N);
            auto const x = solve(two_sided(dirichlet, alpha, one), one, boundary_values{Q(2, 3), Q(-5)}, boundary_options{});
            CHECK(x.q[0] == Q(2, 3));
            CHECK(x.q[N] == -5);
            CHECK(x.residual == 0);
        }
}

TEST_CASE("quadratic Lagrangians are solved exactly in the rationals") {
    auto const magnetic = [](auto const& t, auto const& x, auto const& v) {
        return v.dot(v) / 2 + v(0) * v(1) / 5 + (x(0) * v(1) - 2 * x(1) * v(0)) / 3 - x(0) * x(0) / 2 - t * x(1) + v(0) * t;
    };
    plane<Q> const a{Q(1), Q(1, 2)}, b{Q(-2), Q(3)};
    for (Q const& alpha : {Q(1), Q(2, 3)}) {
        auto const T = uniform(Q(0), Q(1), 5);
        auto const x = solve(two_sided(magnetic, alpha, T), T, boundary_values{a, b}, boundary_options{});
        CHECK(x.residual == 0);
        CHECK(x.iterations == 1);
        CHECK(x.q[0] == a);
        CHECK(x.q[5] == b);
    }
}

TEST_CASE("the solution for L = v^2/2 is a quotient of sums, at every point and for both ways to convolve") {
    for (double const alpha : {0.25, 0.5, 0.75, 1.0})
        for (int N : {1, 2, 40, 47, 48, 49, 300}) {
            auto const T = uniform(interval{-1.0, 2.0}, N);
            auto const x = solve(two_sided(dirichlet, alpha, T), T, boundary_values{0.5, 3}, boundary_options{});
            auto const beta = first_weights<grunwald_letnikov>(-alpha, N + 1);
            auto const sum = [&](int k) {
                double total = 0;
                for (int j = 1; j <= k; ++j) total += beta[static_cast<std::size_t>(k - j)] * beta[static_cast<std::size_t>(N - j)];
                return total;
            };
            double const c = (3 - 0.5 * beta.back()) / sum(N);
            for (int k = 0; k <= N; ++k)
                CHECK(std::abs(x.q[k] - (0.5 * beta[static_cast<std::size_t>(k)] + c * sum(k))) <= 64 * epsilon<double>() * 3);
            CHECK(x.q[0] == 0.5);
            CHECK(x.q[N] == 3);
            CHECK(x.iterations == 0);
        }
}

TEST_CASE("a time-dependent mass takes one correction, and components do not mix") {
    auto const T = uniform(interval{0.0, 1.0}, 200);
    auto const weighted = [](auto const& t, auto const&, auto const& v) { return (v(0) * v(0) * (1 + t) + v(1) * v(1)) / 2; };
    auto const x = solve(two_sided(weighted, 0.75, T), T, boundary_values{plane<double>(0, 0), plane<double>(1, 1)}, boundary_options{});
    auto const alone = solve(two_sided(dirichlet, 0.75, T), T, boundary_values{0, 1}, boundary_options{});
    CHECK(x.iterations == 1);
    CHECK(x.applications == 0);
    double largest = 0;
    for (int k = 0; k <= 200; ++k) {
        CHECK(std::abs(x.q[k](1) - alone.q[k]) <= 64 * epsilon<double>());
        largest = std::max(largest, std::abs(x.q[k](0) - alone.q[k]));
    }
    CHECK(largest > 1e-3);
}

TEST_CASE("the weights of any generating function: exact for L = v^2/2, and the residual by the operators else") {
    auto const unit = uniform(Q(0), Q(1), 9);
    constexpr unknown q;
    auto const trapezoidal = variation(nabla_integral(lagrangian{dirichlet}(q, minus_alpha<trapezoid, 1, 1>[q]), unit));
    auto const line = solve(trapezoidal, unit, {.q0 = 1, .qN = -2});
    for (Q const& r : trapezoidal.residual(line)) CHECK(r == 0);
    CHECK(line[0] == 1);
    CHECK(line[9] == -2);
    CHECK(line[5] != Q(1) - Q(5) / 3); // unlike Delta_minus, whose first value does not differ from the others

    constexpr lagrangian quartic{[](auto const& x, auto const& v) { return v * v / 2 + x * x * x * x / 4 + x * v / 3; }};
    auto const T = uniform(0.0, 0.125, 40);
    auto const holds = [&](auto const& EL, double alpha) {
        auto const x = solve(EL, T, {.q0 = 0.25, .qN = 1.0}, boundary_options{});
        double worst = 0;
        for (double const r : EL.residual(x.q)) worst = std::max(worst, std::abs(r));
        CHECK(worst <= 256 * epsilon<double>() * std::pow(T.h(), -2 * alpha));
        CHECK(x.residual <= 256 * epsilon<double>() * std::pow(T.h(), -2 * alpha));
        CHECK(x.q[40] == 1);
        return x.q[20];
    };
    double const by_bdf = holds(variation(nabla_integral(quartic(q, minus_alpha<bdf<2>, 3, 4>[q]), T)), 0.75);
    double const by_trapezoid = holds(variation(nabla_integral(quartic(q, minus_alpha<trapezoid, 1, 2>[q]), T)), 0.5);
    double const by_delta = holds(variation(nabla_integral(quartic(q, Delta_minus_alpha<3, 4>[q]), T)), 0.75);
    CHECK(std::abs(by_bdf - by_delta) > 1e-3);
    CHECK(std::abs(by_trapezoid - by_delta) > 1e-3);
}

TEST_CASE("the residual asks for the derivatives of L a few times at each point, though each of its own reads all of them") {
    auto const T = uniform(interval{0.0, 1.0}, 40);
    int asked = 0;
    auto const counted = [&asked](auto const& x, auto const& v) {
        ++asked;
        return v * v / 2 - x * x * x / 3;
    };
    auto const residual = two_sided(counted, 0.75, T).residual(function_on(T, [](double t) { return t * t; }));
    double sum = 0;
    for (double const r : residual) sum += r;
    CHECK(std::isfinite(sum));
    CHECK(asked > 0);
    CHECK(asked <= 4 * 40);
}

TEST_CASE("an equation is solved on the scale that is given, as local ones are") {
    auto const T = uniform(0.0, 0.125, 8), other = uniform(0.0, 0.25, 5);
    auto const x = solve(two_sided(dirichlet, 0.75, T), other, {.q0 = 1, .qN = -1});
    auto const y = solve(two_sided(dirichlet, 0.75, other), other, {.q0 = 1, .qN = -1});
    CHECK(x.root() == other);
    for (hilger::index_type k = 0; k <= 5; ++k) CHECK(x[k] == y[k]);
}

TEST_CASE("below alpha = 1/2 the solutions of L = v^2/2 tend to 0 inside, like h^(1 - 2 alpha)") {
    for (float50 const& alpha : {float50(3) / 10, float50(1) / 10}) {
        auto const middle = [&](int N) { return at_middle(alpha, N, 0); };
        CHECK(std::abs(testing::order_of(middle(512), middle(1024)) - static_cast<double>(1 - 2 * alpha)) <= 0.02);
    }
}

TEST_CASE("for alpha < 1 a first value that is not 0 is forgotten, like h^(1 - alpha)") {
    for (float50 const& alpha : {float50(3) / 4, float50(9) / 10}) {
        auto const difference = [&](int N) { return float50(at_middle(alpha, N, 2) - at_middle(alpha, N, 0)); };
        CHECK(std::abs(testing::order_of(difference(512), difference(1024)) - static_cast<double>(1 - alpha)) <= 0.02);
    }
}

TEST_CASE("what is no boundary value problem is refused") {
    auto const T = uniform(interval{0.0, 1.0}, 10);
    for (double const alpha : {0.0, -0.5, 1.25, std::numeric_limits<double>::quiet_NaN()})
        CHECK_THROWS_AS((void)solve(two_sided(dirichlet, alpha, T), T, boundary_values{0, 1}), error::invalid_parameter);
    double const none = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS((void)solve(two_sided(dirichlet, 0.75, T), T, boundary_values{none, 1}), error::not_finite);
    CHECK_THROWS_AS((void)solve(two_sided(dirichlet, 0.75, T), T, boundary_values{0, -none}), error::not_finite);
    auto const exact = uniform(Q(0), Q(1, 2), 3);
    CHECK_THROWS_WITH_AS((void)solve(two_sided(dirichlet, Q(1, 2), exact), exact, boundary_values{0, 1}),
                         "in an exact scalar a fractional difference of order 1/2 takes steps of length 1, and this one is 1/2",
                         error::invalid_parameter);
    auto const integrals = testing::two_sided(dirichlet, fraction<-1, 2>{}, uniform(0.0, 0.1, 10));
    CHECK_THROWS_WITH_AS((void)solve(integrals, uniform(0.0, 0.1, 10), {.q0 = 0.0, .qN = 1.0}),
                         "the order of the difference of a two-sided problem lies in ]0, 1], and this one is -0.5",
                         error::invalid_parameter);
}

} // namespace boundary_tests
