// SPDX-License-Identifier: BSL-1.0
// Damping at Radau's nodes by name: on a T that may be graded it has as many steps and the same ends, on given points these; a checkpoint;
// what is refused.
#include <doctest/doctest.h>

#include <sstream>

#include "stated.hpp"

namespace engine_damped_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

engine::problem oscillator(std::string const& history = "exponentials") {
    auto what = stated("v[0]^2/2 - q[0]^2/2 + q[0]", 1);
    what.damping.push_back({float100(1), float100("0.5")});
    what.history = history;
    return what;
}
engine::points<double> equal_steps(index_type steps) { return {0, 15.0 / static_cast<double>(steps), steps, {}, 15.0, true}; }
engine::initial<double> const at_rest{engine::vector<double>::Zero(1), engine::second_datum::velocity, engine::vector<double>::Zero(1)};
double end_of(engine::made const& motion) {
    auto const walk = motion->begin(at_rest);
    walk->advance(1000);
    CHECK(walk->state().t == 15);
    return walk->state().q(0);
}
double const exact = 0.857933655594914561; // 45 digits in papers/galucio_deu_dubois_2008

} // namespace

TEST_CASE("on a T that is graded at its start the order is that of the method") {
    for (auto const& one : {std::pair{"radau-3", 2e-6}, std::pair{"radau-4", 3e-8}, std::pair{"radau-5", 1e-10}}) {
        std::string const method = one.first;
        double const error = one.second;
        CAPTURE(method);
        auto const motion = engine::damped(oscillator(), method, equal_steps(24));
        CHECK(motion->times().size() == 25);
        CHECK(motion->times().front() == 0);
        CHECK(motion->times().back() == 15);
        CHECK(std::abs(end_of(motion) - exact) <= error);
        CHECK(motion->times()[1] < 0.2);
        auto equal = equal_steps(24);
        equal.may_be_graded = false;
        CHECK(engine::damped(oscillator(), method, equal)->times()[1] == 0.625);
    }
    CHECK(engine::damped(oscillator(), "radau-3", equal_steps(1))->times() == std::vector<double>{0, 15});
    CHECK(engine::damped(oscillator(), "radau-3", equal_steps(2))->times() == std::vector<double>{0, 1.875, 15});
}

TEST_CASE("on given points, and from a checkpoint") {
    auto T = equal_steps(4);
    T.given = {0, 1, 2, 3.5, 15};
    auto const motion = engine::damped(oscillator("exponentials:1e-10"), "radau-3", T);
    CHECK(motion->times() == T.given);
    auto const whole = motion->begin(at_rest), later = motion->begin(at_rest);
    whole->advance(2);
    std::stringstream kept;
    REQUIRE(whole->save(kept));
    later->load(kept, "the text");
    whole->advance(2);
    later->advance(2);
    CHECK(later->state().q == whole->state().q);
    CHECK(later->state().p == whole->state().p);
}

TEST_CASE("what has no history of stages is refused") {
    for (char const* history : {"direct", "blocks"})
        CHECK_THROWS_WITH_AS((void)engine::damped(oscillator(history), "radau-5", equal_steps(8)),
                             ("the history of radau-5 is exponentials, and not " + std::string(history)).c_str(), error::invalid_parameter);
    CHECK(engine::damped(oscillator(), "radau-2", equal_steps(8)) == nullptr);
    auto T = equal_steps(2);
    T.given = {0, 2, 1};
    CHECK_THROWS_AS((void)engine::damped(oscillator(), "radau-3", T), error::invalid_scale);
}

} // namespace engine_damped_tests
