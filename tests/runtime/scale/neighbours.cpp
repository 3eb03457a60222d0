// SPDX-License-Identifier: BSL-1.0
// sigma, rho, mu and nu of points, on every kind of scale (Cresson-Safi, definition 3): sigma maps T^+ to T^-, rho maps T^- to T^+, and
// neither has a value where there is no next point.
#include <doctest/doctest.h>

#include <vector>

#include "support/values.hpp"

namespace scale_neighbours_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// sigma, rho, mu and nu against the list of points, which is all they depend on.
template <class Scale>
void check_neighbours(Scale const& scale) {
    using S = typename Scale::scalar_type;
    std::vector<S> const t(scale.begin(), scale.end());
    REQUIRE(t.size() >= 1);
    for (std::size_t i = 0; i + 1 < t.size(); ++i) {
        CHECK(scale.sigma(t[i]) == t[i + 1]);
        CHECK(scale.mu(t[i]) == t[i + 1] - t[i]);
        CHECK(scale.rho(t[i + 1]) == t[i]);
        CHECK(scale.nu(t[i + 1]) == t[i + 1] - t[i]);
        CHECK(scale.rho(scale.sigma(t[i])) == t[i]);
        CHECK(scale.nu(scale.sigma(t[i])) == scale.mu(t[i]));
    }
    CHECK_THROWS_AS((void)scale.sigma(t.back()), error::outside_domain);
    CHECK_THROWS_AS((void)scale.mu(t.back()), error::outside_domain);
    CHECK_THROWS_AS((void)scale.rho(t.front()), error::outside_domain);
    CHECK_THROWS_AS((void)scale.nu(t.front()), error::outside_domain);
}

template <class Scale>
void check_neighbours_on_all_that_comes_from(Scale const& T) {
    check_neighbours(T), check_neighbours(without_last(T)), check_neighbours(without_first(T)), check_neighbours(interior(T));
    check_neighbours(half(T)), check_neighbours(without_last(half(T))), check_neighbours(without_first(half(T)));
    check_neighbours(circ(T)), check_neighbours(interior(circ(T)));
    check_neighbours(at_lambda<1, 3>(T)), check_neighbours(at_lambda<0, 1>(T)), check_neighbours(circ<3, 4>(T));
    check_neighbours(at_lambda(T, Q(2, 7))), check_neighbours(circ(T, Q(2, 7))), check_neighbours(without_first(circ(T, Q(2, 7))));
}

} // namespace

TEST_CASE("sigma, rho, mu and nu are those of the list of points") {
    SUBCASE("on a uniform scale") { check_neighbours_on_all_that_comes_from(uniform(Q(-1, 3), Q(1, 7), 6)); }
    SUBCASE("on the smallest scale with inner points") { check_neighbours_on_all_that_comes_from(uniform(Q(0), Q(1), 2)); }
    SUBCASE("on given points") { check_neighbours_on_all_that_comes_from(steps_1_2_4()); }
    SUBCASE("on q^Z") { check_neighbours_on_all_that_comes_from(powers(Q(3, 2), -3, 3)); }
    SUBCASE("on the harmonic numbers") { check_neighbours_on_all_that_comes_from(harmonic_numbers<Q>(5)); }
    SUBCASE("on a fine part followed by a coarse one") {
        std::vector<Q> mixed;
        for (int i = 0; i < 5; ++i) mixed.push_back(Q(i, 1000));
        for (int i = 1; i < 5; ++i) mixed.push_back(Q(i));
        check_neighbours_on_all_that_comes_from(time_scale<Q>(mixed));
    }
    SUBCASE("on the points of a derived scale") { check_neighbours_on_all_that_comes_from(time_scale(circ(steps_1_2_4()))); }
}

TEST_CASE("the tables of a scale with the steps 1, 2, 4") {
    auto const T = steps_1_2_4();
    CHECK(T.sigma(Q(1)) == 3);
    CHECK(T.rho(Q(1)) == 0);
    CHECK(T.mu(Q(1)) == 2);
    CHECK(T.nu(Q(1)) == 1);
    CHECK(half(T).sigma(Q(2)) == 5);
    CHECK(half(T).mu(Q(2)) == 3); // (2 + 4) / 2, not the step of T at the same number
    CHECK(half(T).nu(Q(2)) == Q(3, 2));
    CHECK(circ(T).sigma(Q(3)) == 5);
    CHECK(circ(T).mu(Q(3)) == 2);
    CHECK(circ(T).nu(Q(3)) == 1);
    CHECK(at_lambda<1, 3>(T).mu(Q(5, 3)) == Q(8, 3)); // (2/3) 2 + (1/3) 4
    CHECK(circ<3, 4>(T).mu(Q(3)) == 3);
    CHECK(circ<3, 4>(T).mu(Q(6)) == 1);
    CHECK(at_lambda(T, Q(1, 3)).mu(Q(5, 3)) == Q(8, 3));
    CHECK(circ(T, Q(3, 4)).nu(Q(6)) == 3);
}

TEST_CASE("a part of a scale has the neighbours that lie in it") {
    auto const T = steps_1_2_4();
    CHECK(without_last(T).sigma(Q(1)) == 3);
    CHECK_THROWS_AS((void)without_last(T).sigma(Q(3)), error::outside_domain);
    CHECK_THROWS_AS((void)without_last(T).sigma(Q(7)), error::outside_domain);
    CHECK_THROWS_AS((void)without_first(T).rho(Q(1)), error::outside_domain);
    CHECK(without_first(T).rho(Q(3)) == 1);
}

TEST_CASE("in floating scalars the neighbour of a point is the scale's own point, not the argument moved by h") {
    auto const T = uniform(0.0, 0.1, 10);
    CHECK(T.sigma(0.3) == T.point(4));       // 0.3 is not 3 * 0.1, and is found
    CHECK(T.sigma(0.1 + 0.2) == T.point(4)); // 0.1 + 0.2 is 3 * 0.1, and is found too
    CHECK(T.rho(0.7) == T.point(6));         // 7 * 0.1 is 0.7000000000000001
    CHECK(T.mu(0.5) == 0.1);                 // h itself, not a difference of rounded points
    CHECK(T.nu(1) == 0.1);                   // an integer is a point too
    CHECK(T.sigma(0) == 0.1);
    CHECK(uniform(0.0f, 0.1f, 10).sigma(0.3) == 0.4f); // and so is a double on a scale of floats
    CHECK(circ(T).sigma(0.15) == 0.2);
    CHECK(half(T).sigma(0.15) == 0.25);
}

TEST_CASE("what has no next or previous point says so in one sentence") {
    auto const T = steps_1_2_4();
    CHECK_THROWS_WITH_AS((void)T.sigma(Q(7)), "sigma(7) does not exist: 7 is the last point of T = {0, 1, 3, 7} (4 points)",
                         error::outside_domain);
    CHECK_THROWS_WITH_AS((void)T.mu(Q(7)), "mu(7) does not exist: 7 is the last point of T = {0, 1, 3, 7} (4 points)",
                         error::outside_domain);
    CHECK_THROWS_WITH_AS((void)half(T).rho(Q(1, 2)), "rho(1/2) does not exist: 1/2 is the first point of T_half = {1/2, 2, 5} (3 points)",
                         error::outside_domain);
    CHECK_THROWS_WITH_AS((void)circ(T).nu(Q(0)), "nu(0) does not exist: 0 is the first point of T_o = {0, 1/2, 1, ..., 7} (7 points)",
                         error::outside_domain);
    CHECK_THROWS_WITH_AS((void)T.sigma(Q(2)), "2 is not a point of T = {0, 1, 3, 7} (4 points)", error::outside_domain);
    CHECK_THROWS_WITH_AS((void)without_last(T).sigma(Q(3)), "sigma(3) does not exist: 3 is the last point of T^{+} = {0, 1, 3} (3 points)",
                         error::outside_domain);
}

} // namespace scale_neighbours_tests
