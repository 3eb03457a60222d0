// SPDX-License-Identifier: BSL-1.0
// Runs of Galerkin steps in double beside the same in 50 digits.
#include <doctest/doctest.h>

#include "resuming.hpp"

using namespace hilger;
using namespace hilger::testing;

namespace {

template <class S>
using plane = Eigen::Matrix<S, 2, 1>;
template <class S>
auto path_of(auto const& flow, S const& end, hilger::index steps, double q, double p) {
    return flow.along(uniform(interval<S>{0, end}, steps), plane<S>(S(q), S(0)), plane<S>(S(0), S(p)));
}
template <class Path>
auto last_of(Path const& path) {
    auto last = *path.begin();
    for (auto const& x : path) last = x;
    return last;
}
/// How far a run in double ends from the same run in 50 digits.
double rounding_in(auto const& flow, auto const& exact_flow, double end, hilger::index steps, double q, double p) {
    auto const a = last_of(path_of<double>(flow, end, steps, q, p));
    auto const b = last_of(path_of<float50>(exact_flow, end, steps, q, p));
    return static_cast<double>((a.q.template cast<float50>() - b.q).norm() + (a.p.template cast<float50>() - b.p).norm());
}
constexpr auto orbit = [](auto const& x, auto const& v) { return v.dot(v) / 2 + 1 / x.norm(); };
/// A charge in a magnetic field that grows, and a mass that depends on the position.
constexpr auto general = [](auto const& x, auto const& v) {
    return (1 + x(0) * x(0) / 4) * v.dot(v) / 2 + (x(0) * v(1) - x(1) * v(0)) * (1 + x.dot(x)) / 2 - x.dot(x) / 2;
};
auto const eight = embed(orbit, galerkin<8, gauss>);
auto const four = embed(general, galerkin<4, lobatto>);

} // namespace

// Fifty time units are eight revolutions. A rounding error of half an epsilon in p, which is at most 2, changes the energy by 2e-16; 400 of
// them add up to sqrt(400) of that like a random walk. The mean motion n = (2 |E|)^(3/2) = 1 changes by 3 times the error of the energy,
// the phase by 50 times that, the position by at most 2 and the momentum (by the force, 1/0.16) by 6 times the phase: 5e-12 at the very
// most, all of it at the pericentre. With compensated sums the state does not round, and what is left is a tenth of that.
TEST_CASE("what a Kepler orbit (e = 0.6) in double has of 50 digits is rounding") {
    CHECK(rounding_in(eight, eight, 50, 400, 0.4, 2) <= 1e-12);
    CHECK(rounding_in(embed(orbit, galerkin<8, gauss>, compensated), eight, 50, 400, 0.4, 2) <= 1e-13);
}
TEST_CASE("and the orbit is Kepler's, by his equation, to the error of the method") {
    auto const x = last_of(path_of<double>(eight, 50.0, 400, 0.4, 2));
    double E = 50;
    for (int i = 0; i < 200; ++i) E -= (E - 0.6 * std::sin(E) - 50) / (1 - 0.6 * std::cos(E));
    CHECK(std::abs(x.q(0) - (std::cos(E) - 0.6)) < 1e-12);
    CHECK(std::abs(x.q(1) - 0.8 * std::sin(E)) < 1e-12);
}
TEST_CASE("so it is of a Lagrangian that is not separable") { CHECK(rounding_in(four, four, 20, 100, 0.5, 1) <= 1e-13); }
TEST_CASE("and of steps so long that Newton is needed, always or at the pericentre") {
    CHECK(rounding_in(eight, eight, 13, 13, 0.4, 2) <= 1e-12);
    CHECK(rounding_in(four, four, 12, 8, 0.5, 1) <= 1e-12);
}
TEST_CASE("runs are resumed bit for bit, whichever way their steps are solved") {
    CHECK(differences(path_of<double>(eight, 13.0, 130, 0.4, 2), 61) == 0);
    CHECK(differences(path_of<double>(eight, 13.0, 13, 0.4, 2), 6) == 0);
    CHECK(differences(path_of<double>(four, 12.0, 60, 0.5, 1), 31) == 0);
    CHECK(differences(path_of<double>(four, 12.0, 8, 0.5, 1), 3) == 0);
}
