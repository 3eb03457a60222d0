// SPDX-License-Identifier: BSL-1.0
// e_p(t, s) on a time scale: the product of 1 + mu p from s to t, in either direction.
#include <doctest/doctest.h>

#include <cmath>

#include "support/values.hpp"

namespace function_exponential_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
auto const T = steps_1_2_4();
auto const p = function_on(without_last(T), std::vector<Q>{1, Q(-3, 2), Q(1, 2)}); // 1 + mu p = 2, -2, 3
} // namespace

TEST_CASE("e_p(t, s) is the product of 1 + mu p from s to t, and its inverse backwards") {
    CHECK(exponential(p, 0, 0) == 1);
    CHECK(exponential(p, 1, 0) == 2);
    CHECK(exponential(p, 3, 0) == -4); // it may change sign: p is regressive, not positively so
    CHECK(exponential(p, 7, 0) == -12);
    CHECK(exponential(p, 7, 1) == -6);
    CHECK(exponential(p, 3, 3) == 1);
    CHECK(exponential(p, 7, 7) == 1);
    CHECK(exponential(p, 0, 7) == Q(-1, 12));
    CHECK(exponential(p, 1, 3) == Q(-1, 2));
}

TEST_CASE("it solves Delta_plus y = p y with y(s) = 1, for every s") {
    for (auto const& s : T) {
        auto const y = function_on(T, [&s](Q const& t) { return exponential(p, t, s); });
        CHECK(y(s) == 1);
        CHECK(values(Delta_plus[y]) == values(p * y));
    }
}

TEST_CASE("e_p(t, r) = e_p(t, s) e_p(s, r), and e_p(sigma(t), s) = (1 + mu p) e_p(t, s)") {
    for (auto const& t : T)
        for (auto const& s : T) {
            CHECK(exponential(p, t, s) * exponential(p, s, t) == 1);
            for (auto const& r : T) CHECK(exponential(p, t, r) == exponential(p, t, s) * exponential(p, s, r));
            if (t != T.max()) CHECK(exponential(p, T.sigma(t), s) == (1 + T.mu(t) * p(t)) * exponential(p, t, s));
        }
}

TEST_CASE("on hZ it is (1 + h p)^n, and it tends to the exponential") {
    auto const U = uniform(Q(0), Q(1, 3), 6);
    auto const two = function_on(U, [](Q const&) { return Q(2); });
    CHECK(exponential(two, Q(2), Q(0)) == Q(15'625, 729)); // (5/3)^6
    CHECK(exponential(two, Q(1), Q(2)) == Q(27, 125));
    auto const V = uniform(interval{0.0, 1.0}, 100'000);
    CHECK(std::abs(exponential(function_on(V, [](double) { return -1.0; }), 1.0, 0.0) - std::exp(-1.0)) < 2e-6);
    CHECK(std::abs(exponential(function_on(V, [](double) { return -1.0; }), 0.0, 1.0) - std::exp(1.0)) < 2e-5);
    auto const W = powers(Q(2), 0, 3); // on q^Z with q = 2: mu = t
    CHECK(exponential(function_on(W, [](Q const& t) { return Q(1 / t); }), Q(8), Q(1)) == 8);
}

TEST_CASE("where 1 + mu p vanishes p is not regressive, and that is said") {
    auto const bad = function_on(without_last(T), std::vector<Q>{1, Q(-1, 2), 1}); // mu = 2 at t = 1
    CHECK_THROWS_WITH_AS((void)exponential(bad, 7, 0), "e_p needs a regressive p, and 1 + mu p is zero at 1", error::invalid_parameter);
    CHECK_THROWS_AS((void)exponential(bad, 0, 3), error::invalid_parameter);
    CHECK(exponential(bad, 1, 0) == 2); // only what lies between s and t counts
    CHECK(exponential(bad, 7, 3) == 5);
}

TEST_CASE("s and t are points of T, and p is needed from one to the other") {
    CHECK_THROWS_WITH_AS((void)exponential(p, 2, 0), "2 is not a point of T = {0, 1, 3, 7} (4 points)", error::outside_domain);
    CHECK_THROWS_AS((void)exponential(p, 0, 9), error::outside_domain);
    auto const inner = restrict_to(function_on(T, std::vector<Q>{9, Q(1, 2), Q(1, 4), 9}), interior(T));
    CHECK(exponential(inner, 7, 1) == 4);
    CHECK_THROWS_AS((void)exponential(inner, 7, 0), error::outside_domain);
    auto const U = uniform(0.0, 0.1, 10);
    auto const one = function_on(U, [](double) { return 1.0; });
    CHECK(std::abs(exponential(one, 0.3, 0.0) - 1.331) < 1e-15);
    CHECK(std::abs(exponential(one, 1, 0.5) - 1.61051) < 1e-15); // an integer bound does not make the other one an integer
}

} // namespace function_exponential_tests
