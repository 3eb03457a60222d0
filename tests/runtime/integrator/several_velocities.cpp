// SPDX-License-Identifier: BSL-1.0
// Lagrangians that are not convex in v: several velocities have one momentum, and a motion begins with the one that it was given. Where
// there is no mass at rest, or L is not defined there, v = 0 is no place to begin from either.
#include <doctest/doctest.h>

#include "hilger/composition/methods.hpp"
#include "hilger/hilger.hpp"
#include "support/systems.hpp"

namespace several_velocities_tests {

using namespace hilger;
using namespace hilger::testing;

/// Of one type, for what is compiled for each.
auto polynomial(double a4, double a3, double a2) {
    return lagrangian{[=](auto const& q, auto const& v) { return v * v * (a2 + v * (a3 + v * a4)) - q * q / 2; }};
}
/// p = v^2/2: +v and -v have one momentum.
auto const cubic = polynomial(0, 1.0 / 6, 0);
/// p = v^3/3 - v: three velocities (Shapere and Wilczek, Classical time crystals, Physical Review Letters 109, 2012).
auto const crystal = polynomial(1.0 / 12, 0, -0.5);
auto const quartic = polynomial(0.25, 0, 0);
auto const nearly_massless = polynomial(0.25, 0, 0.5e-8);
lagrangian const with_log{[](auto const& q, auto const& v) { return v * log(v) - q * q / 2; }};
/// The same for each component of vectors.
template <class L>
auto each_of(lagrangian<L> const& one) {
    return lagrangian{[one](auto const& q, auto const& v) {
        auto sum = one.function(q(0), v(0));
        for (hilger::index_type k = 1; k < q.size(); ++k) sum = sum + one.function(q(k), v(k));
        return sum;
    }};
}

constexpr double h = 1.0 / 256;

/// That the first step of f has the velocity v0 up to what its acceleration, below 4, changes in a step.
template <class Flow, class V>
void check_flow(Flow const& f, V const& q0, V const& v0) {
    auto const path = f.along(uniform(0.0, h, 4), initial_velocity<V>{q0, v0});
    auto const run = record(path);
    CHECK(magnitude(V((run.states[1].q - q0) / h - v0)) <= 4 * h);
    // and goes on with it
    CHECK(magnitude(V((run.states[4].q - run.states[3].q) / h - v0)) <= 16 * h);
    if constexpr (requires { largest_residual(path); }) CHECK(largest_residual(path) <= 64 * epsilon<double>() / (h * h));
    auto const slope = [&](auto const& inside) { return V((inside(h / 1024).q - q0) / (h / 1024)); };
    CHECK(magnitude(V(slope(dense_output(path)) - v0)) <= 4 * h);
    if constexpr (not detail::has_history<Flow>) CHECK(magnitude(V(slope(dense_output(f.mechanics(), run.states)) - v0)) <= 4 * h);
}
template <class L, class V>
void check_all(L const& lagrangian, V const& q0, V const& v0) {
    check_flow(embed(lagrangian, order_one), q0, v0);
    check_flow(embed(lagrangian, order_one_left), q0, v0);
    check_flow(embed(lagrangian, mid_point), q0, v0);
    check_flow(embed(lagrangian, mid_point, compensated), q0, v0);
    check_flow(embed(lagrangian, theta<1, 3>), q0, v0);
    check_flow(embed(lagrangian, galerkin<2, gauss>), q0, v0);
    check_flow(embed(lagrangian, galerkin<3, lobatto>), q0, v0);
    check_flow(stoermer_verlet(lagrangian), q0, v0);
    check_flow(compose(kahan_li<8>, embed(lagrangian, mid_point)), q0, v0);
    check_flow(symmetrized(symmetrized(embed(lagrangian, order_one))), q0, v0);
    check_flow(adjoint(embed(lagrangian, theta<1, 3>)), q0, v0);
    check_flow(embed(with_force(lagrangian, [](auto const& q, auto const&) { return -q / 8; }), mid_point), q0, v0);
}

TEST_CASE("a motion begins with the velocity that it was given, and goes on with it") {
    for (double const v0 : {0.9, -0.9}) check_all(cubic, 0.3, v0);
    for (double const v0 : {1.5, -1.5, 0.5}) check_all(crystal, 0.3, v0);
    check_all(quartic, 0.3, -0.9);
    check_all(with_log, 0.3, 0.9);
    check_all(nearly_massless, 0.3, 0.9);
}

TEST_CASE("in vectors of any size") {
    check_all(each_of(cubic), Eigen::Vector2d(0.3, 0.2), Eigen::Vector2d(-0.9, 0.8));
    Eigen::VectorXd const q0 = Eigen::VectorXd::LinSpaced(5, 0.1, 0.3), v0 = Eigen::VectorXd::LinSpaced(5, -1.5, -1.3);
    check_all(each_of(crystal), q0, v0);
    check_all(each_of(with_log), q0, Eigen::VectorXd(-v0));
}

TEST_CASE("two positions, the front door, an accuracy, a memory") {
    auto const T = uniform(0.0, h, 8);
    auto const f = embed(cubic, mid_point);
    auto const run = record(f.along(T, initial_velocity{0.3, -0.9}));
    auto const again = record(f.along(T, initial_positions{run.states[0].q, run.states[1].q}));
    CHECK(std::abs(again.states[8].q - run.states[8].q) <= 256 * epsilon<double>() / h);

    constexpr unknown q;
    constexpr auto q_o = extend[q];
    auto const EL = variation(integral(cubic(q_o, Delta_o_plus[q_o]), half(T)));
    CHECK(std::abs(solve(EL, T, {.q0 = 0.3, .v0 = -0.9})[8] - run.states[8].q) <= 256 * epsilon<double>() / h);
    // v dv = -q dt: v^3 / 3 + q^2 / 2 is constant
    auto const exact = solve(cubic, interval{0.0, 0.1}, {.q0 = 0.3, .v0 = -0.9}, accuracy{1e-10});
    CHECK(std::abs(exact.end.q - 0.21151812818454024) <= 1e-9);
    double const v_end = -std::sqrt(2 * exact.end.p);
    CHECK(std::abs(v_end * v_end * v_end / 3 + exact.end.q * exact.end.q / 2 - (-0.9 * 0.9 * 0.9 / 3 + 0.3 * 0.3 / 2)) <= 1e-9);
    // The energy of a state is that of one velocity or the other.
    auto const H = energy(cubic);
    CHECK(H(run.states[0]) == doctest::Approx(0.9 * 0.9 * 0.9 / 3 + 0.3 * 0.3 / 2).epsilon(1e-12));
    CHECK(H(run.states[0], -1.0) == doctest::Approx(-0.9 * 0.9 * 0.9 / 3 + 0.3 * 0.3 / 2).epsilon(1e-12));

    check_flow(embed(with_fractional_damping(cubic, 0.2, fraction<1, 2>{}), mid_point), 0.3, -0.9);
}

TEST_CASE("a drift is that of the energy along the walk") {
    for (double const v0 : {2.0, -2.0}) {
        auto const path = embed(crystal, mid_point).along(uniform(0.0, h, 50), {.q0 = 0.0, .v0 = v0});
        CHECK(drift_along(path, energy(crystal)).largest <= h * h);
        // and goes on with it from a checkpoint
        auto const all = record(path).states;
        auto at = path.begin();
        for (int i = 0; i < 20; ++i) ++at;
        CHECK(record(path.resume(at.checkpoint())).states.back() == all.back());
    }
}

TEST_CASE("a velocity that no momentum tells from its neighbours is refused, and no other one is taken") {
    auto const check = [](auto const& f, double q0, double v0) {
        CHECK_THROWS_AS((void)record(f.along(uniform(0.0, h, 2), initial_velocity{q0, v0})), error::singular);
    };
    lagrangian const massless{[](auto const& q, auto const& v) { return q * q / 2 + 0 * v; }};
    auto const check_all = [&](auto const& L, double q0, double v0) {
        check(embed(L, order_one), q0, v0);
        check(embed(L, mid_point), q0, v0);
        check(embed(L, galerkin<2, gauss>), q0, v0);
        check(stoermer_verlet(L), q0, v0);
        check(compose(kahan_li<8>, embed(L, mid_point)), q0, v0);
    };
    check_all(massless, 1.0, 0.0);
    check_all(crystal, 0.3, 1.0); // p = v^3/3 - v has its minimum there
}

TEST_CASE("a motion that ends before its interval does is not looked for in ever shorter steps") {
    // From q = 0.3, v = 0.2 it comes to v = 0, where its acceleration -q / v is without bound.
    try {
        (void)solve(cubic, interval{0.0, 0.1}, {.q0 = 0.3, .v0 = 0.2}, accuracy{1e-8});
        FAIL("there is no solution");
    } catch (error::no_convergence const& why) {
        CHECK(std::string(why.what()).find("the step from t = 0.06") != std::string::npos);
    }
}

} // namespace several_velocities_tests
