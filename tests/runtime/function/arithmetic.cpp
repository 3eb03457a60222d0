// SPDX-License-Identifier: BSL-1.0
// Pointwise arithmetic: lazy, on the common points, between functions on one scale only, and owning what it is made of.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <memory>

#include "support/values.hpp"

namespace function_arithmetic_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
auto const T = steps_1_2_4();
auto const f = function_on(T, std::vector<Q>{1, 2, 6, -2});
auto const g = function_on(T, [](Q const& t) { return Q(t + 1); }); // 1, 2, 4, 8
} // namespace

TEST_CASE("sums, products and quotients are formed point by point") {
    CHECK(values(f + g) == "T: 2, 4, 10, 6");
    CHECK(values(f - g) == "T: 0, 0, 2, -10");
    CHECK(values(f * g) == "T: 1, 4, 24, -16");
    CHECK(values(f / g) == "T: 1, 1, 3/2, -1/4");
    CHECK(values(-f) == "T: -1, -2, -6, 2");
    CHECK(values(dot(f, g)) == "T: 1, 4, 24, -16");
    CHECK(values(f - (g - f)) == "T: 1, 2, 8, -12");
    CHECK(values((f + g) * (f - g)) == values(f * f - g * g));
}

TEST_CASE("numbers and fractions multiply and divide") {
    CHECK(values(3 * f) == "T: 3, 6, 18, -6");
    CHECK(values(f * 3) == "T: 3, 6, 18, -6");
    CHECK(values(f / 4) == "T: 1/4, 1/2, 3/2, -1/2");
    CHECK(values(Q(1, 3) * f) == "T: 1/3, 2/3, 2, -2/3");
    CHECK(values(f / Q(1, 3)) == "T: 3, 6, 18, -6");
    CHECK(values(fraction<2, 3>{} * f) == "T: 2/3, 4/3, 4, -4/3");
    CHECK(values(f * fraction<-1, 2>{}) == "T: -1/2, -1, -3, 1");
    CHECK(values(f / fraction<1, 2>{}) == "T: 2, 4, 12, -4");
    auto const x = function_on(uniform(0.0, 0.5, 2), [](double t) { return t; });
    CHECK(values(x / 4) == "T: 0, 0.125, 0.25"); // not integer arithmetic
    CHECK(values(x * 0.5) == "T: 0, 0.25, 0.5");
}

TEST_CASE("the result lives where all operands do") {
    CHECK(values(Delta_plus[f] * g) == "T^{+}: 1, 4, -8");
    CHECK(values(Delta_plus[f] + Delta_minus[f]) == "T^{+-}: 3, 0");
    CHECK(values(rho[f] * sigma[f]) == "T^{+-}: 6, -4");
    CHECK(values(extend[f] * function_on(without_last(circ(T)), [](Q const& t) { return t; })) == "T_o^{+}: 0, 3/4, 2, 8, 18, 10");
    CHECK_THROWS_AS((void)(Delta_plus[f] * g)[3], error::outside_domain);
    CHECK_THROWS_AS((void)(Delta_plus[f] + Delta_minus[f])(Q(0)), error::outside_domain);
}

TEST_CASE("apply_pointwise takes any map of any number of functions") {
    CHECK(values(apply_pointwise([](Q const& x) { return Q(x * x); }, f)) == "T: 1, 4, 36, 4");
    CHECK(values(apply_pointwise([](Q const& x, Q const& y, Q const& z) { return Q(x + 10 * y + 100 * z); }, f, g, Delta_minus[f])) ==
          "T^{-}: 122, 246, -122");
    int const power = 3;
    CHECK(values(apply_pointwise([power](Q const& x) { return Q(power * x); }, f)) == "T: 3, 6, 18, -6");
}

TEST_CASE("functions on different scales of one type do not combine") {
    auto const other = function_on(time_scale<Q>{Q(0), Q(1), Q(3), Q(8)}, [](Q const& t) { return t; });
    CHECK_THROWS_WITH_AS(f + other,
                         "functions combine on one scale, and these live on T = {0, 1, 3, 7} (4 points) and on T = {0, 1, 3, 8} (4 points)",
                         error::mismatch);
    CHECK_THROWS_AS(f - other, error::mismatch);
    CHECK_THROWS_AS(f * other, error::mismatch);
    CHECK_THROWS_AS(f / other, error::mismatch);
    CHECK_THROWS_AS(dot(f, other), error::mismatch);
    CHECK_THROWS_AS(apply_pointwise([](Q const& x, Q const&, Q const&) { return x; }, f, g, other), error::mismatch);
    CHECK_THROWS_AS(extend[f] * extend[other], error::mismatch);
    CHECK_THROWS_AS(Delta_plus[f] * Delta_plus[other], error::mismatch);
    // The same points given twice make the same scale.
    CHECK(values(f + function_on(steps_1_2_4(), [](Q const& t) { return t; })) == "T: 1, 3, 9, 5");
    auto const a = function_on(uniform(0.0, 0.1, 10), [](double t) { return t; });
    CHECK_NOTHROW(a + function_on(uniform(0.0, 0.1, 10), [](double t) { return t; }));
    CHECK_THROWS_AS(a + function_on(uniform(0.0, 0.1, 11), [](double t) { return t; }), error::mismatch);
    CHECK_THROWS_AS(a + function_on(uniform(0.5, 0.1, 10), [](double t) { return t; }), error::mismatch);
}

TEST_CASE("nor do functions at different lambdas known at run time") {
    auto const identity_of = [](Q const& t) { return t; };
    auto const a = function_on(at_lambda(T, Q(1, 3)), identity_of), b = function_on(at_lambda(T, Q(1, 4)), identity_of);
    CHECK_THROWS_WITH_AS(a + b,
                         "functions combine on one scale, and these live on T_lambda = {1/3, 5/3, 13/3} (3 points) and on T_lambda = {1/4, "
                         "3/2, 4} (3 points)",
                         error::mismatch);
    CHECK_THROWS_AS(restrict_to(a, at_lambda(T, Q(1, 4))), error::mismatch);
    CHECK_THROWS_AS(integral(a, at_lambda(T, Q(1, 4))), error::mismatch);
    CHECK_THROWS_AS(integral(extend_at(Q(1, 3))[f], at_lambda(T, Q(1, 4))), error::mismatch);
    CHECK_THROWS_AS(extend_at(Q(1, 3))[f] * function_on(circ(T, Q(1, 4)), identity_of), error::mismatch);
    CHECK(values(extend_at(Q(1, 3))[f] - function_on(circ(T, Q(1, 3)), identity_of)) == "T_{o,lambda}: 1, 1, 1, 5/3, 3, -1, -9");
}

TEST_CASE("vectors add, scale and multiply by their Euclidean product") {
    auto const S = uniform(0.0, 1.0, 2);
    auto const u = function_on(S, [](double t) { return Eigen::Vector2d(t, 1.0); });
    auto const v = function_on(S, [](double t) { return Eigen::Vector2d(2.0, -t); });
    auto const x = function_on(S, [](double t) { return t; });
    CHECK((u + v)[2] == Eigen::Vector2d(4.0, -1.0));
    CHECK((u - 2 * v)[2] == Eigen::Vector2d(-2.0, 5.0));
    CHECK((-u / 2)[1] == Eigen::Vector2d(-0.5, -0.5));
    CHECK(dot(u, v)[2] == 2.0);
    CHECK((x * u)[2] == Eigen::Vector2d(4.0, 2.0)); // a scalar function times a vector function
    CHECK((u * x + v / (x + function_on(S, [](double) { return 1.0; })))[1] == Eigen::Vector2d(2.0, 0.5));
    CHECK((x * Eigen::Vector2d(1.0, 2.0))[2] == Eigen::Vector2d(2.0, 4.0));
    CHECK(((u + v) + (u + v))[2] == Eigen::Vector2d(8.0, -2.0));
    CHECK(apply_pointwise([](Eigen::Vector2d const& y) { return 2 * y; }, u + v)[2] == Eigen::Vector2d(8.0, -2.0));
}

TEST_CASE("an expression outlives what it was made of") {
    auto const make = [] {
        auto const S = std::make_unique<time_scale<Q>>(std::vector<Q>{0, 1, 3, 7});
        auto const a = std::make_unique<decltype(function_on(*S, std::vector<Q>()))>(*S, std::vector<Q>{1, 2, 6, -2});
        auto const b = function_on(*S, [k = std::make_shared<Q>(2)](Q const& t) { return Q(*k * t); });
        return Delta_plus[*a * b + 3 * *a] / sigma[b];
    };
    CHECK(values(make()) == "T^{+}: 7/2, 11/3, -11/7");
    auto const vectors = [] {
        auto const S = std::make_unique<time_scale<double>>(std::vector<double>{0, 1, 3});
        auto const a = function_on(*S, std::vector<Eigen::VectorXd>(3, Eigen::VectorXd::Ones(50)));
        return extend[a + a] * function_on(circ(*S), [](double t) { return t; });
    };
    CHECK(vectors()[3] == Eigen::VectorXd::Constant(50, 4.0));
    auto const iterate = [] { return tabulate(Delta_minus[f]); };
    Q sum(0);
    for (auto const& x : iterate()) sum += x;
    CHECK(sum == 1);
}

TEST_CASE("copies of a table share its values") {
    auto const copy = f;
    CHECK(&copy.get(0) == &f.get(0));
    auto const moved = [](auto x) { return x; }(f);
    CHECK(&moved.get(3) == &f.get(3));
    CHECK(&tabulate(f).get(0) != &f.get(0));
}

TEST_CASE("restrict_to forgets points and keeps values") {
    CHECK(values(restrict_to(f, without_last(T))) == "T^{+}: 1, 2, 6");
    CHECK(values(restrict_to(f, interior(T))) == "T^{+-}: 2, 6");
    CHECK(values(restrict_to(extend[f], interior(circ(T)))) == "T_o^{+-}: 3/2, 2, 4, 6, 2");
    CHECK(values(Delta_plus[restrict_to(f, without_first(T))]) == "T^{+-}: 2, -2");
    CHECK_THROWS_AS((void)restrict_to(f, interior(T))[0], error::outside_domain);
    CHECK_THROWS_WITH_AS(
        restrict_to(f, without_last(time_scale<Q>{Q(0), Q(1), Q(3), Q(8)})),
        "a function is used on its own scale: it lives on T = {0, 1, 3, 7} (4 points), and is needed on T^{+} = {0, 1, 3} (3 points)",
        error::mismatch);
}

} // namespace function_arithmetic_tests
