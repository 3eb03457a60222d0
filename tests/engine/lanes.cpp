// SPDX-License-Identifier: BSL-1.0
// Members of an ensemble in the lanes of the processor's registers: they solve their equation, agree with the flow that takes them alone,
// and do not know of each other to the last bit.
#include <doctest/doctest.h>

#include "members.hpp"

namespace lanes_tests {

using namespace hilger;
using namespace testing::members;
using engine::lanes;
using testing::kept_here;
using testing::stated;
using testing::there_is_a_c_compiler;

namespace {

/// Each lane against the same problem alone: positions and momenta to the rounding of the steps between, and the equation of it. From small
/// numbers of this size, of which `at_rest(m, start)` may take some away.
template <class AtRest>
void check_lanes(engine::problem const& what, std::string const& method, engine::points<double> const& T, double size, double growth,
                 AtRest const& at_rest) {
    CAPTURE(method);
    int const d = what.lagrangian.formula().words().dimension();
    CAPTURE(d);
    auto const code = lanes::of(what, method, T);
    REQUIRE(bool(code != nullptr));
    auto from = starts(d, size);
    for (std::size_t m = 0; m < from.size(); ++m) at_rest(m, from[m]);
    auto const together = walked(*code, from, steps);
    auto alone = engine::embedded_in_one_step(what, method, T);
    if (not alone) alone = engine::composed(what, method, T);
    double const bound = growth * static_cast<double>(steps) * epsilon<double>();
    for (std::size_t m = 0; m < from.size(); ++m) {
        engine::initial<double> const start{from[m].q, engine::second_datum::velocity, from[m].v};
        std::size_t i = 0;
        double worst = 0, largest = 0;
        alone->walk(start, [&](double, vector const& q, vector const& p) {
            worst = std::max({worst, (q - together[m].q[i]).cwiseAbs().maxCoeff(), (p - together[m].p[i]).cwiseAbs().maxCoeff()});
            largest = std::max({largest, q.cwiseAbs().maxCoeff(), p.cwiseAbs().maxCoeff()});
            ++i;
            return true;
        });
        CHECK(i == static_cast<std::size_t>(steps) + 1);
        CHECK(worst <= bound * largest);
        CHECK(largest > size / 4);
        CHECK(alone->residual(start, together[m].q, together[m].p, false) <= 64 * (method == "kahan-li-8" ? 17 : 1)); // parts of a step
    }
}

void check_lanes(engine::problem const& what, std::string const& method, engine::points<double> const& T, double size, double growth = 16) {
    check_lanes(what, method, T, size, growth, [](std::size_t, lanes::start&) {});
}

std::string const all_methods[] = {"order-one", "order-one-left", "mid-point", "verlet", "kahan-li-8"};

} // namespace

TEST_CASE("every method, from one coordinate to six, on equal and other steps") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    for (auto const& method : all_methods) {
        auto const pendulum = stated("v[0]^2/2 - (1 - cos(q[0]))", 1);
        if (method != "kahan-li-8") check_lanes(pendulum, method, equal, 1);
        if (method != "kahan-li-8") check_lanes(pendulum, method, uneven(), 1);
        check_lanes(stated("dot(v, v)/2 - dot(q, q)/2 - q[0]^2*q[1] + q[1]^3/3", 2), method, equal, 0.25);
    }
    for (int d = 3; d <= lanes::most_coordinates; ++d)
        check_lanes(stated("dot(v, v)*(3 + cos(q[0]))/2 + v[0]*v[" + std::to_string(d - 1) + "]*q[1]/4 - sum(i, 0, " +
                               std::to_string(d - 1) + ", q[i]^2/(1 + i) + exp(-q[i])/8)",
                           d),
                    "mid-point", equal, 0.5, 64);
}

TEST_CASE("masses with zeros on the diagonal, the time, forces, functions of all kinds") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    for (auto const& method : {"mid-point", "order-one", "order-one-left"}) {
        check_lanes(stated("v[0]*v[1] + v[2]*v[1]/2 + v[2]^2/8 - q[0]^2/2 - q[1]^2/2 - q[2]^2", 3), method, equal, 0.5, 64);
        check_lanes(stated("dot(v, v)/2 - dot(q, q)/2", 2, {"-v[0]/8 - v[1]^3/16", "-v[1]*(1 + q[0]^2)/8 + cos(t)/4"}), method, equal, 0.5);
        check_lanes(
            stated("v[0]^2/2 - q[0]^2 - sqrt(1 + q[0]^2) - tanh(q[0])/8 - cosh(q[0])/16 + sinh(q[0])/32 - atan(q[0])/8 - tan(q[0]/4) - "
                   "(2 + q[0])^2.5/64 - expm1(q[0]/8) - cbrt(2 + q[0])/16 - erf(q[0])/64 - asinh(q[0])/64",
                   1),
            method, equal, 0.5);
        check_lanes(stated("v[0]^2/2 - 9.81*q[0]", 1), method, equal, 0.5);
    }
    // momenta and masses share a function, twice each
    for (auto const& method : {"mid-point", "order-one"})
        check_lanes(stated("v[0]^2 + v[1]^2/2 + v[0]*v[1]*cos(q[0] - q[1]) + 2*cos(q[0]) + cos(q[1])", 2), method, equal, 0.25, 64);
    auto const in_time = stated("v[0]^2/2 - q[0]^2/2*(1 + t/4) + q[0]*sin(t)", 1, {"-v[0]*t/8"});
    for (auto const& method : all_methods) check_lanes(in_time, method, uneven(), 0.5);
}

TEST_CASE("lanes start from rest with a drag, and where a norm is 0") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const dragged = stated("dot(v, v)/2 - dot(q, q)/2 - norm(q)*dot(q, q)", 2, {"-0.3*norm(v)*v[0]", "-0.3*norm(v)*v[1]"});
    for (std::string const method : {"mid-point", "order-one", "order-one-left"})
        check_lanes(dragged, method, equal, 0.5, 16, [](std::size_t m, lanes::start& x) { (m % 2 == 0 ? x.q : x.v).setZero(); });
}

TEST_CASE("small components beside large ones keep their digits") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const what = stated("v[0]^2/2 + v[1]^2*(1 + q[1]^2*1e16)/2 - q[0]^4/4 - q[1]^2/2 - q[1]^4*1e16/4", 2);
    auto const code = lanes::of(what, "mid-point", equal);
    REQUIRE(bool(code != nullptr));
    auto from = starts(2, 1);
    for (auto& x : from) x.q(1) *= 1e-8, x.v(1) *= 1e-8;
    auto const together = walked(*code, from, steps);
    auto const alone = engine::embedded_in_one_step(what, "mid-point", equal);
    for (std::size_t m = 0; m < from.size(); ++m) {
        std::size_t i = 0;
        double worst = 0;
        alone->walk({from[m].q, engine::second_datum::velocity, from[m].v}, [&](double, vector const& q, vector const&) {
            worst = std::max(worst, std::abs(q(1) - together[m].q[i++](1)));
            return true;
        });
        CHECK(worst <= 16 * static_cast<double>(steps) * epsilon<double>() * 1e-8);
    }
}

TEST_CASE("of several velocities that solve a step it is the one that the flow takes alone") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    // a bead on the parabola q^2: the equations of its steps are of second and third degree in the velocity
    auto const bead = stated("(1 + 4*q[0]^2)*v[0]^2/2 - 9.81*q[0]^2", 1);
    for (std::string const method : {"order-one", "order-one-left", "mid-point", "verlet"})
        for (double const h : {0.05, 0.1}) {
            CAPTURE(method);
            CAPTURE(h);
            engine::points<double> const T{0, h, steps, {}};
            auto const code = lanes::of(bead, method, T);
            REQUIRE(bool(code != nullptr));
            auto alone = engine::embedded_in_one_step(bead, method, T);
            if (not alone) alone = engine::composed(bead, method, T);
            std::size_t elsewhere = 0, steps_made = 0;
            std::vector<lanes::start> from;
            for (int m = 0; m < 800; ++m) from.push_back({1.5 * some(1, m, 1), 2 * some(1, 3 * m + 1, 1), {}, {}});
            auto const together = walked(*code, from, steps);
            for (std::size_t m = 0; m < from.size(); ++m) {
                auto const& q = together[m].q;
                auto const& is_well = together[m].is_well;
                std::size_t i = 0;
                try {
                    alone->walk({from[m].q, engine::second_datum::velocity, from[m].v}, [&](double, vector const& x, vector const&) {
                        // rounding grows; another root is a leap
                        bool const leaps = is_well[i] and std::abs(x(0) - q[i](0)) > 1e-6;
                        elsewhere += leaps ? 1 : 0;
                        return is_well[i++] and not leaps;
                    });
                } catch (error::exception const&) { // there is none that is near
                    elsewhere += is_well[i] ? 1 : 0;
                }
                steps_made += i;
            }
            CHECK(elsewhere == 0);
            CHECK(steps_made > 5000);
        }
}

TEST_CASE("what would take the compiler minutes is nothing for lanes") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    CHECK(bool(lanes::of(stated("v[0]^2/2 - sum(i, 1, 20, cos(i*q[0])/i^2)", 1), "mid-point", equal) != nullptr));
    CHECK(bool(lanes::of(stated("v[0]^2/2 - sum(i, 1, 2000, cos(i*q[0])/i^2)", 1), "mid-point", equal) == nullptr));
}

TEST_CASE("lanes do not know of each other, and who fails loses nobody else") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const what = stated("v[0]^2/2 + 10*q[0]^3/3 - cos(q[0])", 1);
    engine::points<double> const T{0, 0.125, 5, {}};
    auto const code = lanes::of(what, "mid-point", T);
    REQUIRE(bool(code != nullptr));
    lanes::start const well{vector::Constant(1, -0.5), vector::Constant(1, 0.5), {}, {}},
        lost{vector::Constant(1, 40), vector::Constant(1, 0), {}, {}};
    std::vector<lanes::start> const same(static_cast<std::size_t>(code->width()), well);
    lanes::group among_the_same(*code, same);
    among_the_same.walk(4);
    REQUIRE(among_the_same.is_well(0));
    for (int place = 0; place < code->width(); ++place) {
        auto others = std::vector<lanes::start>(static_cast<std::size_t>(code->width()), lost);
        others[static_cast<std::size_t>(place)] = well;
        lanes::group group(*code, others);
        group.walk(1);
        group.walk(3);
        for (int m = 0; m < code->width(); ++m) CHECK(group.is_well(m) == (m == place));
        CHECK(group.q(place, 0) == among_the_same.q(0, 0));
        CHECK(group.p(place, 0) == among_the_same.p(0, 0));
    }
    auto momenta = same;
    momenta[0].p = vector::Constant(1, 0.5);
    lanes::group other_start(*code, momenta);
    other_start.walk(4);
    CHECK(other_start.q(0, 0) == among_the_same.q(0, 0));
}

TEST_CASE("who has no mass is lost at the beginning, though the equation of a step is regular") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    for (std::string const method : {"mid-point", "theta:0.25"}) {
        auto const code = lanes::of(stated("q[0]^2*v[0]^2/2 - q[0]^2/2 - q[0]", 1), method, {0, 1, 3, {}});
        REQUIRE(bool(code != nullptr));
        std::vector<lanes::start> from(8, {vector::Constant(1, 1), vector::Constant(1, 0), {}, {}});
        from[1].q(0) = 0;
        auto const all = walked(*code, from, 0);
        for (std::size_t m = 0; m < from.size(); ++m) CHECK(all[m].is_well[0] == (m != 1));
    }
}

TEST_CASE("a mass that vanishes on the way is lost there, and so is what is beyond all numbers") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const for_a_while = lanes::of(stated("v[0]^2*(2 - t)/2", 1), "order-one", {0, 1, 4, {}});
    REQUIRE(bool(for_a_while != nullptr));
    for (auto const& member : walked(*for_a_while, starts(1, 1), 4)) {
        CHECK(member.is_well[1]);
        CHECK(not member.is_well[4]);
    }

    auto const code = lanes::of(stated("v[0]^2*q[0]/2", 1), "order-one", {0, 1, 3, {}});
    REQUIRE(bool(code != nullptr));
    std::vector<lanes::start> from(2, {vector::Constant(1, 1), vector::Constant(1, 0), {}, {}});
    from[1].q(0) = 0;
    auto const with_and_without = walked(*code, from, 1);
    CHECK(with_and_without[0].is_well[1]);
    CHECK(not with_and_without[1].is_well[1]);

    auto const free = lanes::of(stated("v[0]^2/2", 1), "order-one", {0, 1, 3, {}});
    REQUIRE(bool(free != nullptr));
    from[1].q(0) = from[1].v(0) = 1e308;
    auto const one_beyond = walked(*free, from, 1);
    CHECK(one_beyond[0].is_well[1]);
    CHECK(not one_beyond[1].is_well[1]);

    auto const flat = lanes::of(stated("(v[0]/10 + 3*v[1]/10)^2/2 - q[0]", 2), "mid-point", {0, 1, 3, {}});
    REQUIRE(bool(flat != nullptr));
    for (auto const& member : walked(*flat, starts(2, 1), 1)) CHECK(not member.is_well[1]);
}

TEST_CASE("what lanes are not for") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const none = [](engine::problem const& what, std::string const& method) { return lanes::of(what, method, equal) == nullptr; };
    auto const oscillator = stated("v[0]^2/2 - q[0]^2/2", 1);
    CHECK(not none(oscillator, "mid-point"));
    CHECK(none(oscillator, "gauss-2"));
    auto damped = oscillator;
    damped.damping.push_back({0.5, 0.5});
    CHECK(none(damped, "mid-point"));
    for (std::string const branch :
         {"abs(q[0])", "max(q[0], 0)", "if(q[0] < 0, q[0]^2, q[0]^4)", "log(2 - q[0])", "log1p(q[0])", "acos(q[0])"})
        CHECK_MESSAGE(none(stated("v[0]^2/2 - " + branch, 1), "mid-point"), branch);
    CHECK(none(stated("dot(v, v)/2 - dot(q, q)/2", lanes::most_coordinates + 1), "mid-point"));
    engine::set_machine_code(engine::machine_code::off);
    CHECK(none(oscillator, "mid-point"));
}

} // namespace lanes_tests
