// SPDX-License-Identifier: BSL-1.0
// A recording has the states that a walk has, every stride-th and the last, and loses none when a step fails.
#include <doctest/doctest.h>

#include "hilger/trajectory/recording.hpp"
#include "support/systems.hpp"

namespace recording_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("a recording has the states of the walk") {
    auto const path = embed(pendulum, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0);
    auto const run = record(path);
    CHECK_FALSE(run.stopped);
    REQUIRE(run.states.size() == 11);
    std::size_t i = 0;
    for (auto const& x : path) {
        CHECK(x.t == path.scale().point(static_cast<hilger::index_type>(i))); // steps of 0.1 added up are not 1
        CHECK(x == run.states[i++]);
    }
}

TEST_CASE("every stride-th state and always the last") {
    auto const path = embed(pendulum, mid_point).along(uniform(0.0, 0.5, 10), 1.0, 0.0);
    auto const times = [&](auto stride) {
        std::vector<double> result;
        for (auto const& x : record(path, stride).states) result.push_back(x.t);
        return result;
    };
    CHECK(times(4) == std::vector{0.0, 2.0, 4.0, 5.0});
    CHECK(times(5) == std::vector{0.0, 2.5, 5.0});
    CHECK(times(100) == std::vector{0.0, 5.0});
    CHECK(times(1e2) == times(100));
    CHECK(times(0.5 / 0.125) == times(4));
    CHECK_THROWS_WITH_AS((void)record(path, 0),
                         "a recording keeps every stride-th state, a whole number from 1, and its stride was given as 0",
                         error::invalid_parameter);
    CHECK_THROWS_AS((void)record(path, 0.3 / 0.1), error::invalid_parameter); // 2.9999999999999996
    CHECK_THROWS_AS((void)record(path, std::nan(""), keep_partial), error::invalid_parameter);
}

TEST_CASE("positions are the solution in C(T), momenta satisfy their definition, exactly") {
    auto const T = uniform(Q(0), Q(1, 5), 6);
    constexpr unknown q;
    auto const EL = variation(integral(oscillator(extend[q], Delta_o_plus[extend[q]]), half(T)));
    auto const run = record(embed(oscillator, mid_point).along(T, initial_velocity<Q>{Q(1), Q(1, 2)}));
    auto const x = solve(EL, T, {.q0 = Q(1), .v0 = Q(1, 2)});
    auto const positions = run.positions(), momenta = run.momenta();
    for (hilger::index_type i = 0; i <= 6; ++i) CHECK(positions[i] == x[i]);
    // p_{i+1} + p_i = 2 dL/dv at the node: Cresson-Safi (82)
    for (hilger::index_type i = 0; i < 6; ++i) {
        Q const middle = (x[i] + x[i + 1]) / 2, v = (x[i + 1] - x[i]) * 5;
        CHECK((momenta[i] + momenta[i + 1]) / 2 == v + middle / 3);
    }
    CHECK_THROWS_WITH_AS((void)record(embed(oscillator, mid_point).along(T, Q(1), Q(0)), 2).positions(),
                         "a function on T = {0, 1/5, 2/5, ..., 6/5} (7 points) needs 7 values, and was given 4", error::mismatch);
}

TEST_CASE("a recording is whole: where a step fails, its error is thrown") {
    auto const path = embed(cubic, mid_point).along(uniform(0.0, 0.1, 50), 1.0, 0.0);
    CHECK_THROWS_AS((void)record(path), error::no_convergence);
    CHECK_THROWS_AS((void)record(path, 7), error::no_convergence);
    try {
        (void)record(path, 1000);
        FAIL("the walk ends in a failed step");
    } catch (interrupted<double, double> const& end) {
        CHECK(end.last.t > 0);
    }
    CHECK_THROWS_AS((void)record(path, 0, keep_partial), error::invalid_parameter);
    // Of a walk that reaches its end there is no difference.
    auto const whole = embed(pendulum, mid_point).along(uniform(0.0, 0.1, 10), 1.0, 0.0);
    CHECK(record(whole).states == record(whole, keep_partial).states);
    CHECK_FALSE(record(whole, keep_partial).stopped);
}

TEST_CASE("where a step fails the states before it stay for whoever asks for them") {
    auto const path = embed(cubic, mid_point).along(uniform(0.0, 0.1, 50), 1.0, 0.0);
    auto const run = record(path, keep_partial);
    REQUIRE(run.stopped);
    CHECK(run.stopped->find("the step from t = ") == 0);
    CHECK(run.stopped->find("did not converge") != std::string::npos);
    std::vector<state<double, double>> walked;
    try {
        for (auto const& x : path) walked.push_back(x);
        FAIL("the walk ends in a failed step");
    } catch (interrupted<double, double> const& end) {
        CHECK(end.last == walked.back());
    }
    CHECK(run.states == walked);
    // The last good state is kept whatever the stride is.
    CHECK(record(path, 1000, keep_partial).states == std::vector{walked.front(), walked.back()});
    CHECK_THROWS_AS((void)run.positions(), error::mismatch);
}

TEST_CASE("what a Lagrangian throws itself loses no state either") {
    lagrangian const fenced{[](auto const& x, auto const& v) {
        if (x > 2) throw std::domain_error("beyond the fence");
        return v * v / 2 + 0 * x;
    }};
    auto const path = embed(fenced, mid_point).along(uniform(0.0, 0.5, 10), 0.0, 1.0);
    CHECK_THROWS_AS((void)record(path), std::domain_error);
    auto const run = record(path, keep_partial);
    REQUIRE(run.stopped);
    CHECK(*run.stopped == "beyond the fence");
    CHECK(run.states.size() == 5); // mid-points 0.25, ..., 1.75 are inside
    CHECK(run.states.back() == state<double, double>{2, 2, 1});
}

} // namespace recording_tests
