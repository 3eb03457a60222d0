// SPDX-License-Identifier: BSL-1.0
// Two-sided problems of the fractional embedding: exact solutions, closed forms, and what is refused.
#include <doctest/doctest.h>

#include "hilger/integrator/boundary.hpp"
#include "hilger/multiprecision.hpp"

using namespace hilger;

namespace {

constexpr auto dirichlet = [](auto const&, auto const& v) { return v * v / 2; };
constexpr auto oscillator = [](auto const& x, auto const& v) { return (x.dot(x) + v.dot(v)) / 2; };
constexpr auto attracted = [](auto const& x, auto const& v) { return (x * x + v * v) / 2; };
/// A mass that depends on the position, a gyroscopic term and a force that depends on the time.
constexpr auto general = [](auto const& t, auto const& x, auto const& v) {
    using std::cos, std::sin;
    return v.dot(v) * (2 + sin(x(0))) / 2 + v(0) * v(1) / 3 + x(0) * v(1) + cos(x(1)) * t + x.dot(x) * x.dot(x) / 4;
};

template <class S>
using plane = Eigen::Matrix<S, 2, 1>;

/// The largest coefficient of (EL_h^alpha) in front of a value, times that value: what its rounding is measured by.
template <class S, class X>
S rounding(X const& x, S const& alpha) {
    using std::pow;
    S largest(0);
    for (auto const& value : x) largest = std::max(largest, S(magnitude(value)));
    return S(8) * epsilon<S>() * S(static_cast<int>(std::bit_width(static_cast<std::size_t>(x.size())))) * largest *
           pow(x.root().h(), S(-2 * alpha));
}

} // namespace

TEST_CASE("L = v^2/2 is solved exactly: straight lines for alpha = 1, and rationals for h = 1 and any alpha") {
    auto const T = uniform(Q(-1, 3), Q(2, 7), 9);
    auto const line = solve_boundary(fractional_problem(dirichlet, Q(1)), T, Q(1, 2), Q(-3));
    for (hilger::index k = 0; k <= 9; ++k) CHECK(line.q[k] == Q(1, 2) + (Q(-3) - Q(1, 2)) * k / 9);
    CHECK(line.residual == 0);
    CHECK(line.iterations == 0);
    for (Q const& alpha : {Q(3, 4), Q(1, 2), Q(1, 5)})
        for (int N : {1, 2, 3, 12}) {
            auto const one = uniform(Q(0), Q(1), N);
            auto const x = solve_boundary(fractional_problem(dirichlet, alpha), one, Q(2, 3), Q(-5));
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
        auto const x = solve_boundary(fractional_problem(magnetic, alpha), uniform(Q(0), Q(1), 5), a, b);
        CHECK(x.residual == 0);
        CHECK(x.iterations == 1);
        CHECK(x.q[0] == a);
        CHECK(x.q[5] == b);
    }
}

TEST_CASE_TEMPLATE("the equation holds at every inner point, to rounding", S, float, double, long double, float50) {
    for (S const& alpha : {S(1), S(3) / 4, S(2) / 5}) {
        auto const T = uniform(interval{S(0), S(1)}, 100);
        auto const scalar = solve_boundary(fractional_problem(attracted, alpha), T, S(1), S(2));
        CHECK(scalar.residual <= rounding(scalar.q, alpha));
        auto const two = solve_boundary(fractional_problem(oscillator, alpha), T, plane<S>(S(1), S(0)), plane<S>(S(-1), S(2)));
        CHECK(two.residual <= rounding(two.q, alpha));
        auto const any = solve_boundary(fractional_problem(general, alpha), T, plane<S>(S(1), S(0)), plane<S>(S(-1), S(1)));
        CHECK(any.residual <= S(8) * rounding(any.q, alpha));
        CHECK(any.iterations <= 8);
        MESSAGE(static_cast<double>(alpha), ": ", static_cast<double>(scalar.residual / rounding(scalar.q, alpha)), " ",
                static_cast<double>(two.residual / rounding(two.q, alpha)), " ", static_cast<double>(any.residual / rounding(any.q, alpha)),
                " iterations ", two.iterations, " ", two.applications, "; ", any.iterations, " ", any.applications);
    }
}
