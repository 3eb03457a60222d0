// SPDX-License-Identifier: BSL-1.0
// Answers that another package for time scales, timescalecalculus for Python, gets wrong: each is here as a test, so that this one cannot.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/values.hpp"

namespace wrong_answers_elsewhere_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
/// Fine, then coarse, then a single point far away: what a scale with an interval and isolated points becomes on a computer.
auto const mixed = [] {
    std::vector<Q> points;
    for (int i = 0; i <= 10; ++i) points.push_back(Q(i, 10));
    points.insert(points.end(), {Q(2), Q(3), Q(10)});
    return time_scale<Q>(points);
}();
} // namespace

TEST_CASE("e_p(t, s) is wrong on every discrete scale: here it solves Delta_plus y = p y, y(s) = 1, forwards and backwards") {
    auto const check = [](auto const& T, auto const& formula) {
        auto const p = function_on(T, formula);
        for (auto const& s : T) {
            auto const y = function_on(T, [&](Q const& t) { return exponential(p, t, s); });
            CHECK(y(s) == 1);
            CHECK(values(Delta_plus[y]) == values(p * restrict_to(y, without_last(T))));
        }
    };
    check(uniform(Q(0), Q(1), 5), [](Q const&) { return Q(1); }); // e_1(t, 0) = 2^t on the integers
    check(uniform(Q(-1), Q(1, 4), 6), [](Q const& t) { return Q(t - 1); });
    check(powers(Q(2), 0, 5), [](Q const& t) { return Q(1 / t); });
    check(harmonic_numbers<Q>(5), [](Q const&) { return Q(3); });
    check(mixed, [](Q const& t) { return Q(t + Q(1, 3)); });
    auto const one = function_on(uniform(Q(0), Q(1), 5), [](Q const&) { return Q(1); });
    CHECK(exponential(one, 5, 0) == 32);
    CHECK(exponential(one, 0, 5) == Q(1, 32)); // t < s
    CHECK(exponential(one, 2, 4) == Q(1, 4));
    CHECK(exponential(function_on(powers(Q(2), 0, 5), [](Q const& t) { return Q(1 / t); }), 32, 1) == 32); // e_{1/t}(t, 1) = t on 2^N
}

TEST_CASE("sigma of a number that is not a point is returned silently: here it is an error") {
    for (Q const& t : {Q(-1), Q(1, 20), Q(3, 2), Q(5), Q(11)}) {
        CHECK_THROWS_AS((void)mixed.sigma(t), error::outside_domain);
        CHECK_THROWS_AS((void)mixed.rho(t), error::outside_domain);
        CHECK_THROWS_AS((void)mixed.mu(t), error::outside_domain);
        CHECK_THROWS_AS((void)mixed.nu(t), error::outside_domain);
    }
    CHECK_THROWS_AS((void)mixed.sigma(Q(10)), error::outside_domain); // and sigma(b) is not b
    CHECK_THROWS_AS((void)mixed.rho(Q(0)), error::outside_domain);
    CHECK_THROWS_AS((void)function_on(mixed, [](Q const& t) { return t; })(Q(3, 2)), error::outside_domain);
}

TEST_CASE("an integral with reversed bounds is returned as 0: here it changes its sign") {
    auto const f = function_on(mixed, [](Q const& t) { return Q(t + 1); });
    CHECK(integral(f, 1, 10) == 2 + 3 + 7 * 4); // mu(1) f(1) + mu(2) f(2) + mu(3) f(3)
    CHECK(integral(f, 10, 1) == -33);
    CHECK(nabla_integral(f, 10, 1) == -(3 + 4 + 7 * 11));
    CHECK(integral(f, 1, Q(1, 2)) == -integral(f, Q(1, 2), 1));
    CHECK(integral(f, 2, 2) == 0);
    for (auto const& s : mixed)
        for (auto const& t : mixed) {
            CHECK(integral(f, s, t) == -integral(f, t, s));
            CHECK(nabla_integral(f, s, t) == -nabla_integral(f, t, s));
        }
}

TEST_CASE("rho and nu are undefined on mixed scales: here they are what sigma and mu say") {
    CHECK(mixed.rho(Q(1)) == Q(9, 10));
    CHECK(mixed.rho(Q(2)) == 1); // back into the fine part
    CHECK(mixed.rho(Q(10)) == 3);
    CHECK(mixed.nu(Q(1, 10)) == Q(1, 10));
    CHECK(mixed.nu(Q(2)) == 1);
    CHECK(mixed.nu(Q(10)) == 7);
    for (auto const& t : without_first(mixed)) {
        CHECK(mixed.sigma(mixed.rho(t)) == t);
        CHECK(mixed.nu(t) == mixed.mu(mixed.rho(t)));
        CHECK(mixed.rho(t) + mixed.nu(t) == t);
    }
    for (auto const& t : without_last(mixed)) CHECK(mixed.rho(mixed.sigma(t)) == t);
}

TEST_CASE("the derivative at the last isolated point is made up: here it is undefined, T^kappa") {
    auto const f = function_on(mixed, [](Q const& t) { return Q(t * t); });
    CHECK(Delta_plus[f].scale() == without_last(mixed));
    CHECK(Delta_plus[f](Q(3)) == 13); // sigma(t) + t
    CHECK(Delta_plus[f](Q(1)) == 3);
    CHECK(Delta_plus[f](Q(9, 10)) == Q(19, 10));
    CHECK_THROWS_WITH_AS((void)Delta_plus[f](Q(10)), "10 is not a point of T^{+} = {0, 1/10, 1/5, ..., 3} (13 points)",
                         error::outside_domain);
    CHECK_THROWS_AS((void)Delta_minus[f](Q(0)), error::outside_domain);
    CHECK(Delta_minus[f](Q(10)) == 13); // the backward derivative is defined there
    CHECK_THROWS_AS((void)Delta_plus[Delta_plus[f]](Q(3)), error::outside_domain);
}

TEST_CASE("and the same in floating scalars, where points carry rounding") {
    auto const T = uniform(0.0, 0.1, 10);
    auto const one = function_on(T, [](double) { return 1.0; });
    CHECK(exponential(one, 1.0, 0.0) == doctest::Approx(std::pow(1.1, 10)).epsilon(1e-14));
    CHECK(exponential(one, 0.0, 1.0) == doctest::Approx(std::pow(1.1, -10)).epsilon(1e-14));
    CHECK(exponential(one, 0.3, 0.7) == doctest::Approx(std::pow(1.1, -4)).epsilon(1e-14));
    CHECK_THROWS_AS((void)T.sigma(0.35), error::outside_domain);
    CHECK(integral(one, 0.7, 0.3) == doctest::Approx(-0.4).epsilon(1e-14));
    CHECK_THROWS_AS((void)Delta_plus[one](1.0), error::outside_domain);
}

} // namespace wrong_answers_elsewhere_tests
