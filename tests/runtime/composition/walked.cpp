// SPDX-License-Identifier: BSL-1.0
// Compositions that are walked in steps of one length, which keep what they need in registers, are those that are stepped one by one.
#include <doctest/doctest.h>

#include "hilger/composition/composition.hpp"
#include "hilger/composition/methods.hpp"
#include "hilger/hilger.hpp"
#include "support/systems.hpp"

namespace walked_tests {

using namespace hilger;
using namespace hilger::testing;

/// The walk of f from (q, p), also where it goes on from a checkpoint in its middle, against a memory that advances by itself.
template <class Flow, class V>
void check_walk(Flow const& f, V const& q, V const& p) {
    auto const T = uniform(0.0, 0.125, 20); // t is exact
    typename Flow::template memory<double, V> memory(f, 0.125, q);
    state<double, V> x{0, q, p};
    auto const path = f.along(T, q, p);
    auto at = path.begin();
    auto const kept = [&] {
        auto middle = path.begin();
        for (int i = 0; i < 7; ++i) ++middle;
        return middle.checkpoint();
    }();
    auto const rest = path.resume(kept);
    auto again = rest.begin();
    for (int i = 0; i <= 20; ++i, ++at) {
        CHECK(*at == x);
        if (i >= 7) {
            CHECK(*again == x);
            ++again;
        }
        if (i < 20) memory.advance(f, x, 0.125);
    }
    CHECK(at == std::default_sentinel);
}

template <class L>
void check_all(L const& lagrangian, auto const& q, auto const& p) {
    check_walk(stoermer_verlet(lagrangian), q, p);
    check_walk(stoermer_verlet(lagrangian, compensated), q, p);
    check_walk(position_verlet(lagrangian), q, p);
    check_walk(compose(suzuki<4>, stoermer_verlet(lagrangian)), q, p); // too long to be written out
    check_walk(compose(halves, embed(lagrangian, order_one)), q, p);   // ends with a drift
}

TEST_CASE("a walk in equal steps makes the steps that a memory makes") {
    check_all(pendulum, 1.0, 0.5);
    lagrangian const plane{[](auto const& x, auto const& v) {
        return v.squaredNorm() / 2 + v(0) / 3 - x.squaredNorm() / 2 - x(0) * x(0) * x(1) + x(1) * x(1) * x(1) / 3;
    }};
    check_all(plane, Eigen::Vector2d(0, 0.1), Eigen::Vector2d(0.49, 0));
    lagrangian const four{[](auto const& x, auto const& v) { return v.dot(v) / 2 + v(1) * v(2) / 3 - x.squaredNorm() * x(3) / 7; }};
    check_all(four, Eigen::Vector4d(0, 0.1, 1, -1), Eigen::Vector4d(0.49, 0, 1, 2));
    check_all(plane, Eigen::VectorXd(Eigen::Vector2d(0, 0.1)), Eigen::VectorXd(Eigen::Vector2d(0.49, 0)));
    // Those that turn out to be stepped in turns: branches, the time, a mass that moves.
    check_all(lagrangian{[](auto const& x, auto const& v) { return v * v / 2 - abs(x); }}, 1.0, 0.5);
    check_all(lagrangian{[](auto const& t, auto const& x, auto const& v) { return v * v / 2 - (1 + t) * x * x / 2; }}, 1.0, 0.5);
    check_all(bead, 1.0, 0.5);
}

TEST_CASE("a walk that fails says from where, and its iterator stays there") {
    // At rest where the force is infinite, after steps of a particle that is free until then.
    lagrangian const wall{[](auto const& x, auto const& v) { return v * v / 2 + 1 / (x * x) / 1e300; }};
    auto const f = stoermer_verlet(wall);
    auto const path = f.along(uniform(0.0, 0.5, 10), 1.5, -1.0); // 1.5, 1, 0.5, 0
    auto at = path.begin();
    ++at, ++at;
    auto const before = *at;
    CHECK(before.q == 0.5);
    for (int once = 0; once < 2; ++once) try {
            ++at;
            FAIL("a force of 1/0 has to be reported");
        } catch (interrupted<double, double> const& stopped) {
            CHECK(stopped.last == before);
            CHECK(*at == before);
        }
    // Numbers whose sum alone is too large are numbers.
    double const large = std::numeric_limits<double>::max() / 1.5;
    for (auto const &x : stoermer_verlet(lagrangian{[](auto const&q, auto const&v) {
                             return v * v / 2 - 0 * q;
                         }}).along(uniform(0.0, 1e-300, 3), large, large)) {
        CHECK(x.q == large);
        CHECK(x.p == large);
    }
}

} // namespace walked_tests
