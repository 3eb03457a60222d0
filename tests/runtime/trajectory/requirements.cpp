// SPDX-License-Identifier: BSL-1.0
// Only what a scene requires is computed: what a step of each method asks of one degree of freedom. Beside each test stands what would
// break it.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "runtime/allocations.hpp"
#include "support/requirements.hpp"
#include "support/systems.hpp"

namespace requirements_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

auto const T = uniform(0.0, 0.05, 40);

template <class Path>
requirements needs(Path const& path) {
    return requirements_of(path); // no_allocation.cpp counts allocations
}
/// Whatever the method: steps keep equally much.
void check_constant(requirements const& r) { CHECK(r.growth_in_bytes == 0); }
/// One force, no second derivative, and so no round; nothing is divided by.
void check_explicit(requirements const& r) {
    check_constant(r);
    CHECK(r.sines == 1);
    CHECK(r.cosines == 0);
    CHECK(r.functions == 1);
    CHECK(r.divisions == 0);
}

} // namespace

TEST_CASE("order one of a separable Lagrangian: one force, and seven operations beside it") {
    // Broken by Newton where v enters quadratically, by a second evaluation, by a factorization of the mass.
    requirements const right = needs(embed(pendulum, order_one).along(T, 1.0, 0.5));
    check_explicit(right);        // the Lagrangian's value, and its cosine, are not made
    CHECK(right.arithmetic == 7); // p - h sin q, q + h v; (q - q) + (p - p) says whether they are finite
    requirements const left = needs(embed(pendulum, order_one_left).along(T, 1.0, 0.5));
    check_explicit(left); // the force at the end of the step
    CHECK(left.arithmetic == 7);
}

TEST_CASE("Stoermer-Verlet: one force, and nothing to solve") {
    // Broken by evaluating at the start of a step what the last one has left there, or dL/dq at both ends.
    check_explicit(needs(stoermer_verlet(pendulum).along(T, 1.0, 0.5)));
    CHECK(needs(position_verlet(pendulum).along(T, 1.0, 0.5)).functions == 1);
    CHECK(needs(compose(suzuki<4>, stoermer_verlet(pendulum)).along(T, 1.0, 0.5)).functions == 5);
}

TEST_CASE("mid-point: as many second derivatives as rounds have use for, and seven velocities") {
    // Broken by one round more than are needed, by an iteration that starts from v alone, by reading derivatives that are known.
    requirements const r = needs(embed(pendulum, mid_point).along(T, 1.0, 0.5));
    check_constant(r);
    CHECK(r.sines <= 1.5); // one a round
    CHECK(r.cosines == r.sines);
    CHECK(r.functions == r.sines + r.cosines);
    CHECK(r.divisions <= 2 * r.sines); // by h, and by the slope of the round
    CHECK(r.state_bytes == 8 * 3);
    CHECK(r.memory_bytes == 8 * (7 + 5)); // velocities; h, the weight, and where the node is
    auto const oscillator = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    requirements const linear = needs(embed(oscillator, mid_point).along(T, 1.0, 0.5));
    CHECK(linear.divisions == 1); // one round
    CHECK(linear.functions == 0);
    CHECK(linear.arithmetic < r.arithmetic);
}

TEST_CASE("no value on T_o is kept: ten points and ten thousand take the same") {
    // Broken by a table of positions, of q_o, or of steps.
    auto const allocated = [](hilger::index_type steps) {
        long const before = allocations_until_now();
        auto const path = embed(pendulum, mid_point).along(uniform(0.0, 0.05, steps), 1.0, 0.5);
        double last = 0;
        for (auto const& x : path) last = x.q;
        CHECK(std::abs(last) < 2);
        return allocations_until_now() - before;
    };
    CHECK(allocated(10) == allocated(10'000));
    requirements const few = requirements_of(embed(pendulum, mid_point).along(T, 1.0, 0.5), 8);
    requirements const many = requirements_of(embed(pendulum, mid_point).along(T, 1.0, 0.5), 2048);
    CHECK(few.memory_bytes == many.memory_bytes);
    CHECK(many.growth_in_bytes == 0);
}

TEST_CASE("what cannot be counted is said") {
    auto const path = embed(pendulum, order_one).along(T, 1.0, 0.5);
    CHECK_THROWS_WITH_AS(requirements_of(path, 0), "the requirements of a step are counted along one step or more, not 0",
                         error::invalid_parameter);
    auto const short_path = embed(pendulum, order_one).along(time_scale{0.0, 0.1, 0.3}, 1.0, 0.5);
    CHECK_THROWS_WITH_AS(requirements_of(short_path, 4), "the requirements of a step are counted along 26 steps, and this time scale has 2",
                         error::invalid_parameter);
    CHECK_FALSE(requirements_of(path, 1).allocations.has_value());
    CHECK(requirements_of(path, 1, allocations_until_now).allocations == 0);
}

} // namespace requirements_tests
