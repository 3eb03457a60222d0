// SPDX-License-Identifier: BSL-1.0
// Lagrangians in text in a transformed time dt = g(q) dtau: states and times are those of the library's own flows, and what has no constant
// energy is refused.
#include <cmath>

#include <doctest/doctest.h>

#include "engine/transformed_time.hpp"
#include "hilger/hilger.hpp"
#include "stated.hpp"
#include "support/systems.hpp"

namespace transformed_time_tests {

using namespace hilger;
using testing::stated;
using vector = Eigen::VectorXd;

namespace {

constexpr index_type steps = 40;
engine::points<double> const equal{0.25, 0.0625, steps, {}};
Eigen::Vector2d const q0(0.5, 0), p0(0, std::sqrt(3.0)); // of eccentricity 1/2 and E = -1/2

engine::problem transformed(engine::problem what, std::string const& g) {
    text::coordinate const q{"q", "v", what.lagrangian.formula().words().dimension()};
    engine::require_constant_energy(what);
    what.time_transformation.emplace(text::read(g, "g"), what.lagrangian.formula(), std::vector{q}, "g");
    return what;
}
engine::problem kepler_in(std::string const& g) { return transformed(stated("dot(v, v)/2 + 1/norm(q)", 2), g); }

template <class S>
std::vector<engine::state<S>> walked(engine::motion<S> const& motion, engine::initial<S> const& from) {
    std::vector<engine::state<S>> all;
    motion.walk(from, [&](S const& t, engine::vector<S> const& q, engine::vector<S> const& p) {
        all.push_back({t, q, p});
        return true;
    });
    return all;
}
/// Whether the states of a method are those of the library's flow, at its times.
template <class G, class Make>
void check_states(std::string const& g, G const& rate, char const* method, engine::points<double> const& T, Make const& make) {
    CAPTURE(method);
    auto const found = walked(*engine::make_motion<double>(kepler_in(g), method, T), {q0, engine::second_datum::velocity, p0});
    auto const path = make(transform_time(testing::kepler, rate, -0.5)).along(engine::any_scale<double>(T), q0, p0);
    auto const t = times_of(path);
    REQUIRE(found.size() == static_cast<std::size_t>(steps) + 1);
    std::size_t i = 0;
    for (auto const& x : path) {
        CHECK((found[i].q - x.q).norm() <= 1e-11);
        CHECK((found[i].p - x.p).norm() <= 1e-11);
        CHECK(std::abs(found[i].t - t[static_cast<index_type>(i)]) <= 1e-11);
        ++i;
    }
}
template <class Error>
void check_refused(std::string const& sentence, auto const& work) {
    CHECK_THROWS_WITH_AS(work(), sentence.c_str(), Error);
}

} // namespace

TEST_CASE("each method has the states of its flow, and the times by its own nodes") {
    for (auto const& T : {equal, testing::uneven(steps)}) {
        auto const check = [&](char const* method, auto const& make) { check_states("sundman(1)", sundman(1), method, T, make); };
        check("order-one", [](auto const& L) { return embed(L, order_one); });
        check("order-one-left", [](auto const& L) { return embed(L, order_one_left); });
        check("mid-point", [](auto const& L) { return embed(L, mid_point); });
        check("theta:0.3", [](auto const& L) { return embed(L, theta<3, 10>); });
        check("gauss-2", [](auto const& L) { return embed(L, galerkin<2, gauss>); });
        check("lobatto-3", [](auto const& L) { return embed(L, galerkin<3, lobatto>); });
        check("verlet", [](auto const& L) { return stoermer_verlet(L); });
        check("blanes-moan-4", [](auto const& L) { return compose_with_adjoint(blanes_moan<4>, embed(L, order_one)); });
    }
}

TEST_CASE("rates in text are those of C++") {
    auto const check = [](char const* text, auto const& rate) {
        check_states(text, rate, "mid-point", equal, [](auto const& L) { return embed(L, mid_point); });
    };
    check("sundman(1.5)", sundman(1.5));
    check("sundman(3/2, 1 + q[0]^2)", sundman(1.5, [](auto const& q) { return 1 + q(0) * q(0); }));
    check("inverse_potential", inverse_potential(testing::kepler));
    check("g + sum(i, 0, 1, q[i]^2)", [](auto const& q) { return 1 + q.dot(q); });
}

TEST_CASE("between the points, and for the energy, the motion is that of L in t") {
    auto const motion = engine::make_motion<double>(kepler_in("sundman(1)"), "gauss-4", equal);
    engine::initial<double> const from{q0, engine::second_datum::momentum, p0};
    auto const x = walked(*motion, from);
    CHECK(motion->times().back() == equal.start + steps * equal.step);
    double const start = equal.start, e = 0.5;
    for (std::size_t i = 0; i < x.size(); ++i) {
        double const E = 0.0625 * static_cast<double>(i); // the eccentric anomaly
        CHECK(std::abs(x[i].t - start - (E - e * std::sin(E))) <= 1e-11);
        CHECK(std::abs(motion->energy(x[i], x[i].p) + 0.5) <= 1e-12);
    }
    // half of a step in the eccentric anomaly
    double const E = 0.0625 * 10.5, t = start + E - e * std::sin(E);
    auto const middle = motion->between_states(x[10], x[11], t);
    CHECK(middle.t == t);
    CHECK((middle.q - Eigen::Vector2d(std::cos(E) - e, std::sqrt(1 - e * e) * std::sin(E))).norm() <= 1e-6);
    // the residual is that of the equation in tau
    std::vector<vector> q, p;
    for (auto const& one : x) q.push_back(one.q), p.push_back(one.p);
    CHECK(motion->residual(from, q, p, false) <= 50);
    q[20] *= 1 + 1e-9;
    CHECK(motion->residual(from, q, p, false) > 1000);
}

TEST_CASE("a cursor in parts is where a walk is, at its times") {
    auto const motion = engine::make_motion<double>(kepler_in("sundman(1)"), "mid-point", equal);
    auto const x = walked(*motion, {q0, engine::second_datum::velocity, p0});
    auto const at = motion->begin({q0, engine::second_datum::velocity, p0});
    for (index_type i = 0; i < steps; i += 7, at->advance(7)) {
        CHECK(at->number() == i);
        auto const here = at->state();
        auto const& there = x[static_cast<std::size_t>(i)];
        CHECK((here.t == there.t and here.q == there.q and here.p == there.p));
        if (i > 0) CHECK((at->velocity() - here.p).norm() <= 0.1 * here.p.norm()); // dq/dt, a mean of the step before
    }
    at->advance(1000);
    CHECK(at->state().t == x.back().t);
}

TEST_CASE("g = 1 is the plain time, to the bit; with g = 2 steps are twice as long in t") {
    auto const L = stated("v[0]^2*(1 + q[0]^2)/2 - q[0]^3", 1);
    engine::initial<double> const from{vector::Constant(1, 0.5), engine::second_datum::momentum, vector::Constant(1, 0.25)};
    for (char const* method : {"order-one", "mid-point", "verlet", "gauss-2"}) {
        auto const plain = walked(*engine::make_motion<double>(L, method, equal), from);
        auto const same = walked(*engine::make_motion<double>(transformed(L, "1"), method, equal), from);
        for (std::size_t i = 0; i < plain.size(); ++i) CHECK((plain[i].q == same[i].q and plain[i].p == same[i].p));
    }
    engine::initial<double> const moving{from.q0, engine::second_datum::velocity, vector::Constant(1, 0.2)}; // p = v (1 + q^2)
    auto const by_velocity = walked(*engine::make_motion<double>(transformed(L, "1"), "mid-point", equal), moving);
    CHECK(by_velocity.back().q.isApprox(walked(*engine::make_motion<double>(L, "mid-point", equal), from).back().q, 1e-13));

    auto const oscillator = stated("v[0]^2/2 - q[0]^2/2", 1);
    engine::initial<double> const one{vector::Constant(1, 1.0), engine::second_datum::velocity, vector::Constant(1, 1.0)};
    engine::points<double> const T{1, 0.125, 5, {}}, longer{1, 0.25, 5, {}};
    auto const twice = walked(*engine::make_motion<double>(transformed(oscillator, "2"), "mid-point", T), one);
    auto const plain = walked(*engine::make_motion<double>(oscillator, "mid-point", longer), one);
    double const rounding = 64 * epsilon<double>(); // the tests of Python have this in rationals, exactly
    for (std::size_t i = 0; i <= 5; ++i) {
        CHECK(twice[i].t == plain[i].t);
        CHECK(std::abs(twice[i].q(0) - plain[i].q(0)) + std::abs(twice[i].p(0) - plain[i].p(0)) <= rounding);
    }
}

TEST_CASE("what has no constant energy, or no positive rate, is refused in one sentence") {
    using error::invalid_parameter;
    std::string const rest = ", and a transformed time dt = g(q) dtau is for one Lagrangian L(q, v)";
    auto const oscillator = stated("v[0]^2/2 - q[0]^2/2", 1);
    auto damped = oscillator;
    damped.damping.push_back({0.2, 0.5});
    check_refused<invalid_parameter>("fractional damping remembers the past in t" + rest, [&] { (void)transformed(damped, "1"); });
    check_refused<invalid_parameter>("a force changes the energy" + rest,
                                     [&] { (void)transformed(stated("v[0]^2/2", 1, {"-v[0]"}), "1"); });
    check_refused<invalid_parameter>("the energy changes where a Lagrangian contains the time" + rest,
                                     [&] { (void)transformed(stated("v[0]^2/2 + t*q[0]", 1), "1"); });
    auto sum = oscillator;
    sum.besides.push_back({oscillator.lagrangian, "order-one"});
    check_refused<invalid_parameter>("a sum of actions has several embeddings" + rest, [&] { (void)transformed(sum, "1"); });
    check_refused<invalid_parameter>("the g of dt = g(q) dtau is a formula of the positions alone",
                                     [&] { (void)transformed(oscillator, "1 + v[0]^2"); });
    check_refused<error::unreadable>("g, line 1, column 1: 'r' has no meaning: there are g, k[], q[], t, v[]",
                                     [&] { (void)transformed(oscillator, "r^2"); });

    auto const walk = [&](std::string const& g, engine::second_datum what) {
        auto const motion = engine::make_motion<double>(transformed(oscillator, g), "mid-point", equal);
        (void)walked<double>(*motion, {vector::Constant(1, -0.5), what, vector::Constant(1, 0.25)});
    };
    using enum engine::second_datum;
    check_refused<invalid_parameter>("a transformed time goes on, dt/dtau = g(q) > 0, and at the start g is -0.5",
                                     [&] { walk("q[0]", velocity); });
    check_refused<invalid_parameter>("a transformed time goes on, dt/dtau = g(q) > 0, and at the start g is 0",
                                     [&] { walk("q[0] + 1/2", momentum); });
    check_refused<invalid_parameter>(
        "in a transformed time a motion starts from q0 and v0 or p0, which have its energy: two positions do not",
        [&] { walk("1", next_position); });
    auto const motion = engine::make_motion<double>(transformed(oscillator, "1"), "mid-point", equal);
    CHECK_THROWS_AS((void)motion->between(vector::Ones(1), vector::Ones(1)), invalid_parameter);
    CHECK_THROWS_AS((void)engine::make_motion<double>(transformed(oscillator, "1"), "two-sided:0.75", equal)
                        ->begin({vector::Ones(1), velocity, vector::Ones(1)}),
                    invalid_parameter);
    CHECK_THROWS_AS((void)engine::make_motion<double>(transformed(oscillator, "1"), "no-method", equal), invalid_parameter);
    hilger::initial_velocity<vector> const from{vector::Ones(1), vector::Ones(1)};
    CHECK_THROWS_AS((void)engine::solve_accurately(transformed(oscillator, "1"), {0, 1}, from, {1e-6}), invalid_parameter);
    hilger::boundary_values<vector> const ends{vector::Ones(1), vector::Ones(1)};
    CHECK_THROWS_AS((void)engine::solve_accurately(transformed(oscillator, "1"), {0, 1}, ends, {1e-6}), invalid_parameter);
}

} // namespace transformed_time_tests
