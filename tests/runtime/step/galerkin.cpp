// SPDX-License-Identifier: BSL-1.0
// Runs of Galerkin steps in double beside the same in 50 digits.
#include <doctest/doctest.h>

#include "runs_in_the_plane.hpp"

namespace galerkin_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto orbit = [](auto const& x, auto const& v) { return v.dot(v) / 2 + 1 / x.norm(); };
auto const eight = embed(orbit, galerkin<8, gauss>);

} // namespace

// Fifty time units are eight revolutions. A rounding error of half an epsilon in p, which is at most 2, changes the energy by 2e-16; 400 of
// them add up to sqrt(400) of that like a random walk. The mean motion n = (2 |E|)^(3/2) = 1 changes by 3 times the error of the energy,
// the phase by 50 times that, the position by at most 2 and the momentum (by the force, 1/0.16) by 6 times the phase: 5e-12 at the very
// most, all of it at the pericentre.
TEST_CASE("what a Kepler orbit (e = 0.6) in double has of 50 digits is rounding") {
    CHECK(rounding_in(eight, eight, 50, 400, 0.4, 2) <= 1e-12);
}
TEST_CASE("and the orbit is Kepler's, by his equation, to the error of the method") {
    auto const x = last_of(path_of<double>(eight, 50.0, 400, 0.4, 2));
    double E = 50;
    for (int i = 0; i < 200; ++i) E -= (E - 0.6 * std::sin(E) - 50) / (1 - 0.6 * std::cos(E));
    CHECK(std::abs(x.q(0) - (std::cos(E) - 0.6)) < 1e-12);
    CHECK(std::abs(x.q(1) - 0.8 * std::sin(E)) < 1e-12);
}
TEST_CASE("and of steps so long that Newton is needed at the pericentre") { CHECK(rounding_in(eight, eight, 13, 13, 0.4, 2) <= 1e-12); }
TEST_CASE("runs are resumed bit for bit, whichever way their steps are solved") {
    CHECK(differences(path_of<double>(eight, 13.0, 130, 0.4, 2), 61) == 0);
    CHECK(differences(path_of<double>(eight, 13.0, 13, 0.4, 2), 6) == 0);
}

} // namespace galerkin_tests
