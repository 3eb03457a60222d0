// SPDX-License-Identifier: BSL-1.0
// One trajectory in steps that are machine code as a whole: the points of T, the states of the engine to rounding, the equation to
// rounding, and nothing where the engine has to say something.
#include <doctest/doctest.h>

#include "engine/ensemble/whole_steps.hpp"
#include "stated.hpp"
#include "support/systems.hpp"

namespace whole_steps_tests {

using namespace hilger;
using engine::second_datum;
using testing::kept_here;
using testing::stated;
using testing::there_is_a_c_compiler;
using vector = Eigen::VectorXd;

namespace {

constexpr index_type steps = 5000; // more than are made at once
engine::points<double> const equal{0.25, 0.0625, steps, {}};
engine::points<double> uneven() { return testing::uneven(steps); }
std::shared_ptr<engine::motion<double> const> alone(engine::problem const& what, std::string const& method,
                                                    engine::points<double> const& T) {
    auto made = engine::embedded_in_one_step(what, method, T);
    return made ? std::move(made) : engine::composed(what, method, T);
}
auto walked(
    engine::problem const& what, std::string const& method, engine::points<double> const& T, engine::initial<double> const& from,
    std::function<bool(index_type)> const& goes_on = [](index_type) { return true; }) {
    return engine::walk_in_whole_steps(
        what, method, T, from, [&] { return engine::walker_of(alone(what, method, T)); }, goes_on);
}

/// Against the engine, at every point. Rounding grows linearly along motions that are regular.
void agrees(engine::problem const& what, std::string const& method, engine::points<double> const& T, engine::initial<double> const& from) {
    CAPTURE(method);
    auto const d = static_cast<std::size_t>(from.q0.size());
    auto const whole = walked(what, method, T, from);
    REQUIRE(whole.has_value());
    auto const motion = alone(what, method, T);
    CHECK(whole->t == motion->times());
    CHECK_FALSE(whole->interrupted);
    REQUIRE(whole->q.size() == d * whole->t.size());
    REQUIRE(whole->p.size() == whole->q.size());
    std::size_t i = 0;
    double largest = 0;
    bool all_near = true;
    std::vector<vector> positions, momenta;
    motion->walk(from, [&](double, vector const& q, vector const& p) {
        Eigen::Map<vector const> const x(whole->q.data() + d * i, q.size()), y(whole->p.data() + d * i, p.size());
        largest = std::max({largest, q.cwiseAbs().maxCoeff(), p.cwiseAbs().maxCoeff()});
        double const off = std::max((x - q).cwiseAbs().maxCoeff(), (y - p).cwiseAbs().maxCoeff());
        all_near = all_near and off <= 16 * static_cast<double>(i + 1) * epsilon<double>() * largest;
        positions.emplace_back(x);
        momenta.emplace_back(y);
        ++i;
        return true;
    });
    CHECK(i == whole->t.size());
    CHECK(all_near);
    CHECK(motion->residual(from, positions, momenta, false) <=
          64 * (method == "kahan-li-8" ? 17 : 1)); // parts of a step, each of which rounds
}

} // namespace

TEST_CASE("kahan-li-8 is made of Verlet, as in files") {
    auto const stated_bead = stated("v[0]^2*(1 + q[0]^2)/2 - q[0]^2/2", 1);
    engine::points<double> const long_steps{0.25, 0.4, 50, {}}; // in short ones the mid-point leads to the same digits
    auto const motion = alone(stated_bead, "kahan-li-8", long_steps);
    auto const expected = hilger::compose(hilger::kahan_li<8>, hilger::stoermer_verlet(hilger::testing::bead))
                              .along(hilger::uniform(long_steps.start, long_steps.step, long_steps.steps), 0.5, 0.25);
    auto at = expected.begin();
    double const rounding = 17 * 64 * epsilon<double>() * static_cast<double>(long_steps.steps);
    double worst = 0;
    motion->walk({vector::Constant(1, 0.5), second_datum::momentum, vector::Constant(1, 0.25)},
                 [&](double, vector const& q, vector const& p) {
                     worst = std::max({worst, std::abs(q(0) - at->q), std::abs(p(0) - at->p)});
                     ++at;
                     return true;
                 });
    CHECK(at == std::default_sentinel);
    CHECK(worst <= rounding);
}
TEST_CASE("every method, from velocities, momenta and second positions, on equal and other steps") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const pendulum = stated("v[0]^2/2 - (1 - cos(q[0]))", 1);
    auto const plane = stated("dot(v, v)/2 - dot(q, q)/2 - q[0]^2*q[1] + q[1]^3/3", 2);
    engine::initial<double> const swinging{vector::Constant(1, 0.5), second_datum::velocity, vector::Constant(1, 0.25)};
    engine::initial<double> const going_round{Eigen::Vector2d(0.1, -0.05), second_datum::velocity, Eigen::Vector2d(0.05, 0.1)};
    for (std::string const method : {"order-one", "order-one-left", "mid-point", "verlet", "kahan-li-8"}) {
        agrees(pendulum, method, equal, swinging);
        agrees(plane, method, equal, going_round);
        if (method != "kahan-li-8") agrees(pendulum, method, uneven(), swinging);
    }
    agrees(plane, "verlet", equal, {going_round.q0, second_datum::momentum, going_round.other});
    agrees(pendulum, "mid-point", equal, {swinging.q0, second_datum::next_position, vector::Constant(1, 0.515)});
    agrees(stated("dot(v, v)/2 - sum(i, 0, 5, (1 + i)*q[i]^2/2)", 6, {"cos(t)/8", "0", "0", "0", "0", "sin(t/4)/16"}), "mid-point", equal,
           {vector::LinSpaced(6, 0, 0.5), second_datum::velocity, vector::LinSpaced(6, 0.25, 0)});
}

TEST_CASE("masses of q, with zeros on the diagonal, forces that couple some coordinates, all functions") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const from = [](int d) {
        return engine::initial<double>{vector::LinSpaced(d, 0.25, 0.5), second_datum::velocity, vector::LinSpaced(d, 0.125, -0.25)};
    };
    auto const bead = stated("(1 + q[0]^2/4)*v[0]^2/2 - q[0]^2/2", 1);
    auto const indefinite = stated("v[0]*v[1] + v[2]*v[1]/2 + v[2]^2/8 - q[0]*q[1] - q[2]^2/8 - q[1]*q[2]/2", 3);
    // rows 0 and 1 of the slopes have columns 0 and 1, row 2 has 0 and 2 and the largest pivot: row 1 gets what it has not
    auto const coupled = stated("dot(v, v)/2 - dot(q, q)/2", 3, {"-v[0]/2 - 8*v[1]", "8*v[0] - v[1]/2", "64*v[0] - v[2]"});
    auto const functions = stated("v[0]^2/2 - q[0]^2 - sqrt(1 + q[0]^2) - tanh(q[0])/8 - cosh(q[0])/16 + sinh(q[0])/32 - atan(q[0])/8 - "
                                  "tan(q[0]/4) - (2 + q[0])^2.5/64 - expm1(q[0]/8) - cbrt(2 + q[0])/16 - erf(q[0])/64 - asinh(q[0])/64 - "
                                  "norm(q)^3 - exp(-q[0])",
                                  1);
    for (std::string const method : {"order-one", "order-one-left", "mid-point", "verlet"}) {
        agrees(bead, method, equal, from(1));
        agrees(functions, method, equal, from(1));
        if (method != "verlet") agrees(indefinite, method, equal, from(3));
        if (method == "mid-point") agrees(coupled, method, equal, from(3));
    }
}

TEST_CASE("an embedding of which each length of step has its own lambda is that of this length, and none of several") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const pendulum = stated("v[0]^2/2 - (1 - cos(q[0]))", 1);
    std::string const mid_point_of_equal = "integral(L(q + Delta_plus[q]/32, Delta_plus[q]))"; // h = 1/16
    engine::initial<double> const from{vector::Constant(1, 0.5), second_datum::velocity, vector::Constant(1, 0.25)};
    auto const own = walked(pendulum, mid_point_of_equal, equal, from), expected = walked(pendulum, "mid-point", equal, from);
    REQUIRE(own.has_value());
    REQUIRE(expected.has_value());
    double worst = 0;
    for (std::size_t k = 0; k < own->q.size(); ++k) worst = std::max(worst, std::abs(own->q[k] - expected->q[k]));
    CHECK(worst <= 16 * static_cast<double>(steps) * epsilon<double>());
    CHECK_FALSE(walked(pendulum, mid_point_of_equal, uneven(), from).has_value());
    CHECK(bool(engine::lanes::of(pendulum, mid_point_of_equal, equal) != nullptr));
    CHECK(bool(engine::lanes::of(pendulum, mid_point_of_equal, uneven()) == nullptr));
}

TEST_CASE("who stops it gets the points before, and is told how many there are") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const oscillator = stated("v[0]^2/2 - q[0]^2/2", 1);
    engine::initial<double> const from{vector::Constant(1, 1), second_datum::velocity, vector::Constant(1, 0)};
    auto const whole = walked(oscillator, "mid-point", equal, from);
    REQUIRE(whole.has_value());
    index_type told = 0;
    auto const part = walked(oscillator, "mid-point", equal, from, [&](index_type done) {
        told = done;
        return false;
    });
    REQUIRE(part.has_value());
    CHECK(part->interrupted);
    CHECK(0 < told);
    CHECK(told < steps);
    REQUIRE(part->t.size() == static_cast<std::size_t>(told) + 1);
    CHECK(part->q == std::vector(whole->q.begin(), whole->q.begin() + told + 1));
    CHECK(part->p == std::vector(whole->p.begin(), whole->p.begin() + told + 1));
}

TEST_CASE("nothing where the engine has to say why, or has more to do") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    vector const one = vector::Constant(1, 1);
    engine::initial<double> const from{one, second_datum::velocity, one};
    auto const is_walked = [&](engine::problem const& what, char const* method) { return walked(what, method, equal, from).has_value(); };
    CHECK(is_walked(stated("v[0]^2/2 - q[0]^2/2", 1), "mid-point"));
    CHECK_FALSE(is_walked(stated("v[0]^2/2 - q[0]^2/2", 1), "gauss-4"));
    CHECK_FALSE(is_walked(stated("v[0]^2/2 + 10*q[0]^3/3", 1), "mid-point"));                     // runs away
    CHECK_FALSE(is_walked(stated("v[0]^2/2 + 1/(q[0] - 1)", 1), "order-one"));                    // begins at a pole
    CHECK_FALSE(is_walked(stated("v[0]^2/2 - abs(q[0])", 1), "mid-point"));                       // branches
    CHECK_FALSE(is_walked(stated("v[0]^2/2 - q[0]^2/2", 2), "mid-point"));                        // two coordinates, and one is given
    CHECK_FALSE(is_walked(stated("v[0] - q[0]^2/2", 1), "order-one"));                            // no mass
    CHECK_FALSE(is_walked(stated("-q[0]^2/2", 1), "mid-point"));                                  // and none that the step asks for
    CHECK_FALSE(is_walked(stated("v[0]^2/2 - sum(i, 1, 300, cos(i*q[0])/i^2)", 1), "mid-point")); // takes the compiler too long
    engine::problem damped = stated("v[0]^2/2 - q[0]^2/2", 1);
    damped.damping.push_back({0.2, 0.5});
    CHECK_FALSE(is_walked(damped, "mid-point"));
    engine::set_machine_code(engine::machine_code::off);
    CHECK_FALSE(is_walked(stated("v[0]^2/2 - q[0]^2/2", 1), "mid-point"));
}

} // namespace whole_steps_tests
