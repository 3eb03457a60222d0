// SPDX-License-Identifier: BSL-1.0
// A step whose increments are numbers may lead beyond the largest one: every scheme says so, and no state that is handed out is infinite.
#include <doctest/doctest.h>

#include <limits>

#include "hilger/hilger.hpp"

namespace overflow_of_sums_tests {

using namespace hilger;

template <class Flow, class V>
void stops_in_time(Flow const& flow, double h, V const& q, V const& p) {
    int finite = 0, others = 0;
    auto const walk = [&] {
        for (auto const& x : flow.along(uniform(0.0, h, 1000), q, p))
            ++(detail::all_finite(x.q) and detail::all_finite(x.p) ? finite : others);
    };
    CHECK_THROWS_AS(walk(), error::not_finite const&);
    CHECK(finite > 0);
    CHECK(others == 0);
}

template <class L, class V>
void all_stop(L const& lagrangian, double h, V const& q, V const& p) {
    stops_in_time(embed(lagrangian, mid_point), h, q, p);
    stops_in_time(embed(lagrangian, galerkin<2, gauss>), h, q, p);
    stops_in_time(embed(lagrangian, galerkin<3, gauss>, compensated), h, q, p);
    stops_in_time(embed(lagrangian, galerkin<3, lobatto>), h, q, p);
}

TEST_CASE("positions that leave the range of the scalar in uniform motion") {
    all_stop([](auto const&, auto const& v) { return v * v / 2; }, 1e300, 1.0, 1e6);
    all_stop([](auto const&, auto const& v) { return v.dot(v) / 2; }, 1e300, Eigen::Vector2d(1, 2), Eigen::Vector2d(1e6, -1e6));
}
TEST_CASE("positions that leave it in a fall") {
    all_stop([](auto const& q, auto const& v) { return v * v / 2 + q; }, 1.0, 1.79e308, 1e306);
}
TEST_CASE("momenta that leave it") {
    stops_in_time(embed([](auto const& q, auto const& v) { return v * v / 2 + 1e307 * q; }, galerkin<2, gauss>), 1.0, 0.0, 1.7e308);
}

TEST_CASE("momenta that leave it by what the last correction adds to the force") {
    auto const hill = [](auto const& q, auto const& v) { return v * v / 2 + q * q; };
    // By the velocity that the step begins with, p + h dL/dq is 1e306 below the largest number; by its own, more than that above.
    double const h = 0.5, q = 1e307, p = (std::numeric_limits<double>::max() - q - 1e306) / 1.25;
    CHECK_THROWS_AS(embed(hill, mid_point).step(state<double, double>{0.0, q, p}, h), error::not_finite const&);
    CHECK_THROWS_AS(embed(hill, mid_point, compensated).step(state<double, double>{0.0, q, p}, h), error::not_finite const&);
}

} // namespace overflow_of_sums_tests
