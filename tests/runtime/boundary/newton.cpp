// SPDX-License-Identifier: BSL-1.0
// Two-sided problems that Newton's method solves: the equation holds to rounding, in any scalar, in few iterations, and failures say so.
#include <doctest/doctest.h>

#include "hilger/boundary/solve.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/newton/stop.hpp"
#include "support/two_sided.hpp"

namespace boundary_newton_tests {

using namespace hilger;
using testing::two_sided;

namespace {

template <class S>
using plane = Eigen::Matrix<S, 2, 1>;

/// One type for several Lagrangians keeps the compile time down: the harmonic oscillator; and a mass that depends on the position, a
/// gyroscopic term, a force that depends on the time.
struct planar {
    bool harmonic;
    auto operator()(auto const& t, auto const& x, auto const& v) const {
        using std::cos, std::sin;
        int const other = harmonic ? 0 : 1;
        return v.dot(v) * (1 + other * (1 + sin(x(0)))) / 2 + (1 - other) * x.dot(x) / 2 +
               other * (v(0) * v(1) / 3 + x(0) * v(1) + cos(x(1)) * t + x.dot(x) * x.dot(x) / 4);
    }
};
/// v^2/2 + a x^2/2 + b x^4/4
struct straight {
    int a = 0, b = 0;
    auto operator()(auto const& x, auto const& v) const { return v * v / 2 + a * x * x / 2 + b * x * x * x * x / 4; }
};

template <class F>
auto largest(F const& f) {
    auto result = magnitude(f[f.first()]);
    for (auto const& value : f) result = std::max(result, decltype(result)(magnitude(value)));
    return result;
}
/// The coefficients of Delta_+^alpha Delta_-^alpha add up to at most 4 h^(-2 alpha), and transforms of N values add up log N roundings.
template <class S, class X>
S rounding(X const& x, S const& alpha) {
    using std::pow;
    return S(4) * epsilon<S>() * S(static_cast<int>(std::bit_width(static_cast<std::size_t>(x.size())))) * largest(x) *
           pow(x.root().h(), S(-2 * alpha));
}

} // namespace

TEST_CASE_TEMPLATE("the equation holds at every inner point, to rounding, in a number of iterations that depends on the digits", S, float,
                   double, float50) {
    for (S const& alpha : {S(1), S(3) / 4, S(2) / 5}) {
        auto const T = uniform(interval{S(0), S(1)}, 60);
        plane<S> const from(S(1), S(0)), to(S(-1), S(1));
        for (bool harmonic : {true, false}) {
            auto const x = solve(two_sided(planar{harmonic}, alpha, T), T, boundary_values{from, to}, boundary_options{});
            CHECK(x.residual <= (harmonic ? 1 : 4) * rounding(x.q, alpha)); // the mass is at most 3 + 1/3
            CHECK(x.q[0] == from);
            CHECK(x.q[60] == to);
            CHECK(x.iterations <= (harmonic ? 2 : 7));
        }
    }
}

TEST_CASE("the work does not depend on N: the same iterations for more steps") {
    auto const applications = [](int N) {
        auto const T = uniform(interval{0.0, 1.0}, N);
        boundary_values const ends{plane<double>(1, 0), plane<double>(-1, 1)};
        return solve(two_sided(planar{true}, 0.75, T), T, ends, boundary_options{}).applications;
    };
    int const few = applications(200), many = applications(20000);
    CHECK(few > 0);
    CHECK(many <= few + 2);
    CHECK(many <= 16);
}

TEST_CASE("alpha = 1 is the classical problem: x'' = x and x'' = -x on six periods, where the derivative is indefinite") {
    for (int sign : {1, -1}) {
        double const length = sign == 1 ? 2 : 40;
        int const N = 400;
        auto const T = uniform(interval{0.0, length}, N);
        auto const x = solve(two_sided(straight{sign}, 1.0, T), T, boundary_values{0.5, 1}, boundary_options{});
        // x_{k+1} - 2 x_k + x_{k-1} = sign h^2 x_k is solved by powers of z, z + 1/z = 2 + sign h^2.
        double const step = sign == 1 ? std::acosh(1 + T.h() * T.h() / 2) : std::acos(1 - T.h() * T.h() / 2);
        auto const wave = [&](double s) { return sign == 1 ? std::sinh(s * step) : std::sin(s * step); };
        for (int k = 0; k <= N; ++k)
            CHECK(std::abs(x.q[k] - (0.5 * wave(N - k) + wave(k)) / wave(N)) <= 1e4 * epsilon<double>() * largest(x.q));
    }
}

TEST_CASE("near resonance, where the condition of the problem magnifies rounding: x(t_N) is held without leaving the equation") {
    // For alpha = 0.3, N = 40 it is about 2000.
    for (double const alpha : {0.3, 0.4, 0.5})
        for (int N : {20, 40, 100})
            for (int k : {5, 7, 20}) {
                auto const T = uniform(interval{0.0, 1.0}, N);
                auto const x = solve(two_sided(straight{-k}, alpha, T), T, boundary_values{0.3, 1}, boundary_options{});
                CHECK(x.residual <= (1 + k) * rounding(x.q, alpha));
                CHECK(x.q[N] == 1);
            }
}

/// A kink in the potential, or a momentum that is bounded: whole steps of Newton's method leave these problems for good.
struct steep {
    bool kink;
    auto operator()(auto const& x, auto const& v) const {
        using std::sqrt;
        int const k = kink ? 1 : 0;
        return k * (v * v / 2 + 10 * sqrt(1 + 100 * x * x) + 10 * x) + (1 - k) * (sqrt(1 + v * v) + 5 * x * x);
    }
};

TEST_CASE("steps are shortened where whole ones would not converge") {
    for (double const alpha : {1.0, 0.75})
        for (bool kink : {true, false}) {
            auto const T = uniform(interval{0.0, 1.0}, 50);
            auto const x = solve(two_sided(steep{kink}, alpha, T), T, boundary_values{0, 1}, boundary_options{});
            CHECK(x.iterations > 3);
            CHECK(x.residual <= 10 * rounding(x.q, alpha)); // the force is ten times its argument
        }
}

TEST_CASE("where Newton's path ends at a singular derivative another one leads to a solution") {
    auto const stiff = [](auto const& x, auto const& v) { return v * v / 2 + v * v * v * v / 4 - x * x; };
    struct of {
        double alpha, h;
        int steps;
        double first, last;
    };
    for (of const& each : {of{0.3, 0.2, 10, 0.0326, -0.3074}, of{0.3, 0.2, 20, 0.103, 0.579}, of{0.75, 0.2, 40, -1.918, -2.776},
                           of{1, 0.2, 40, -1.167, -2.289}}) {
        auto const T = uniform(0.0, each.h, each.steps);
        auto const x = solve(two_sided(stiff, each.alpha, T), T, boundary_values{each.first, each.last}, boundary_options{});
        double const v = largest(x.q) * 2 * std::pow(each.h, -each.alpha);
        CHECK(x.residual <= (1 + 3 * v * v) * rounding(x.q, each.alpha));
        CHECK(x.q[0] == each.first);
        CHECK(x.q[each.steps] == each.last);
    }
}

TEST_CASE("a problem without a solution ends in an error that has the last iterate and its residual") {
    // x'' = -100 - 60 x^2 with x(0) = x(1) = 0 has no solution: the force is too strong to come back from.
    auto const runaway = [](auto const& x, auto const& v) { return v * v / 2 - 100 * x - 20 * x * x * x; };
    auto const T = uniform(interval{0.0, 1.0}, 50);
    try {
        auto const x = solve(two_sided(runaway, 1.0, T), T, boundary_values{0, 0}, boundary_options{});
        FAIL("solved with the residual ", x.residual);
    } catch (newton_failure<std::vector<double>> const& failure) {
        CHECK(failure.iterate.size() == 51);
        CHECK(failure.iterate.back() == 0);
        REQUIRE(failure.residual.size() == 49);
        double worst = 0;
        for (double r : failure.residual) worst = std::max(worst, std::abs(r));
        CHECK(worst > 1);
        auto const EL = two_sided(runaway, 1.0, T);
        CHECK(detail::convolved_residual(EL.action(), failure.iterate) == failure.residual);
        auto const again = EL.residual(function_on(T, failure.iterate));
        for (hilger::index_type k = 1; k < 50; ++k) // sums in another order, of terms of the size of x / h^2
            CHECK(std::abs(again[k] - failure.residual[static_cast<std::size_t>(k) - 1]) <=
                  64 * epsilon<double>() * 2500 * (1 + largest(function_on(T, failure.iterate))));
    }
    auto const exact = uniform(Q(0), Q(1), 4);
    CHECK_THROWS_AS((void)solve(two_sided(straight{0, 1}, Q(1), exact), exact, boundary_values{1, 2}), error::no_convergence);
    CHECK_THROWS_AS((void)solve(two_sided(straight{1, 3}, 0.75, T), T, boundary_values{0, 1}, boundary_options{.most_iterations = 1}),
                    error::no_convergence);
}

TEST_CASE("degenerate and broken Lagrangians are named") {
    auto const T = uniform(interval{0.0, 1.0}, 20);
    auto const no_velocity = [](auto const& x, auto const& v) { return x * x + 0 * v; };
    CHECK_THROWS_AS((void)solve(two_sided(no_velocity, 0.75, T), T, boundary_values{0, 1}), error::singular);
    auto const broken = [](auto const& x, auto const& v) {
        using std::sqrt;
        return v * v / 2 + sqrt(x - 2);
    };
    CHECK_THROWS_AS((void)solve(two_sided(broken, 0.75, T), T, boundary_values{0, 1}), error::not_finite);
    Eigen::VectorXd const two = Eigen::VectorXd::Ones(2), three = Eigen::VectorXd::Ones(3);
    auto const any = [](auto const&, auto const& v) { return v.dot(v) / 2; };
    CHECK_THROWS_WITH_AS((void)solve(two_sided(any, 0.75, T), T, boundary_values{two, three}),
                         "the boundary values have one dimension, and these have 2 and 3", error::mismatch);
    auto const x = solve(two_sided(any, 0.75, T), T, boundary_values{three, Eigen::VectorXd(2 * three)}, boundary_options{});
    CHECK(x.q[7].size() == 3);
    CHECK(x.iterations == 0);
}

} // namespace boundary_newton_tests
