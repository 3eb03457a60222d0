// SPDX-License-Identifier: BSL-1.0
// Resuming has the bits of not stopping for every kind of state, scalar and scale.
#include "resuming.hpp"

namespace checkpoint_kinds_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("runs of vectors of any length, in float, long double and the rationals are resumed bit for bit") {
    auto const T = uniform(0.0, 0.02, 300);
    Eigen::Vector2d const q(0.4, 0), p(0, 2);
    CHECK(differences(embed(kepler, mid_point, compensated).along(T, q, p), 100) == 0);
    CHECK(differences(embed(kepler, mid_point).along(T, Eigen::VectorXd(q), Eigen::VectorXd(p)), 100) == 0);
    CHECK(differences(embed(kepler, mid_point, compensated).along(T, Eigen::VectorXd(q), Eigen::VectorXd(p)), 100) == 0);
    CHECK(differences(pendulum_path<float>(embed(pendulum, mid_point, compensated), 100), 40) == 0);
    CHECK(differences(pendulum_path<long double>(embed(pendulum, mid_point, compensated), 100), 40) == 0);
    CHECK(differences(pendulum_path<Q>(embed(oscillator, mid_point), 12), 5) == 0);
}

TEST_CASE("structured systems, by iteration and by Newton") {
    auto const row = mechanical(1.0, chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(9, 0, 1), p = Eigen::VectorXd::Zero(9);
    CHECK(differences(embed(row, mid_point).along(uniform(0.0, 0.1, 60), q, p), 25) == 0);
    CHECK(differences(embed(row, mid_point, compensated).along(uniform(0.0, 1.0, 60), q, p), 25) == 0);
}

TEST_CASE("on steps of different lengths, at the start and at the end") {
    time_scale<double> const T{0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0, 1.1};
    auto const path = embed(pendulum, mid_point, compensated).along(T, 1.0, 0.0);
    for (hilger::index_type i = 0; i <= 8; ++i) CHECK(differences(path, i) == 0);
}

TEST_CASE("a walk goes on with the problem of its own trajectory, or says that the checkpoint is another's") {
    auto const spring = [](double m, double k) { return [m, k](auto const& x, auto const& v) { return m * v * v / 2 - k * x * x / 2; }; };
    auto const springs = [](double m, double k) { return mechanical(m, [k](auto const& x) { return k * x.dot(x) / 2; }); };
    auto const T = uniform(0.0, 0.125, 10);
    auto const middle = [](auto const& path) {
        auto at = path.begin();
        while (at.number() < 5) ++at;
        return at.checkpoint();
    };
    /// From the state that `path` has reached there.
    auto const begun_there = [&](auto const& path, auto const& own) {
        auto const at = middle(path).at;
        return record(own.method().along(uniform(at.t, 0.125, 5), at.q, at.p)).states.back();
    };
    auto const near = [](auto const& x, auto const& y) { return (x.q - y.q).norm() + (x.p - y.p).norm() <= 64 * epsilon<double>(); };
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(6, 0, 1), p = Eigen::VectorXd::Zero(6);
    auto const light = embed(springs(1, 1), mid_point).along(T, q, p), heavy = embed(springs(4, 4), mid_point).along(T, q, p);
    CHECK(near(record(heavy.resume(middle(light))).states.back(), begun_there(light, heavy)));
    // The force at the last point is the other's.
    auto const soft = stoermer_verlet(spring(1, 1)).along(T, 1.0, 0.0), hard = stoermer_verlet(spring(1, 4)).along(T, 1.0, 0.0);
    CHECK_THROWS_AS((void)hard.resume(middle(soft)), error::mismatch);
    CHECK_NOTHROW((void)soft.resume(middle(soft)));
    // A history of positions, and another coefficient.
    auto const damped = [&](double rho) {
        return embed(with_fractional_damping(spring(1, 1), rho, 0.5, direct{}), mid_point).along(T, 1.0, 0.0);
    };
    auto const weak = damped(0.1), strong = damped(0.9);
    CHECK(record(weak.resume(middle(weak))).states.back().q == record(weak).states.back().q);
    CHECK_THROWS_AS((void)strong.resume(middle(weak)), error::mismatch);
}

} // namespace checkpoint_kinds_tests
