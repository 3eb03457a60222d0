// SPDX-License-Identifier: BSL-1.0
// The adjoint of a flow undoes its step of -h, exactly, with forces and with the time in L; for order one and theta it is the embedding
// that mirrors them.
#include <doctest/doctest.h>

#include "hilger/composition/composition.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "runtime/step/exact_steps.hpp"

namespace reversed_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// A spring with friction.
constexpr auto spring = [](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; };
constexpr auto damping = [](auto const& x, auto const& v) { return -v / 5 - x / 7; };
constexpr problem<decltype(spring), decltype(damping)> damped{spring, damping};

} // namespace

TEST_CASE("the adjoint undoes the step of -h, exactly in the rationals") {
    CHECK(undoes(embed(oscillator, order_one)));
    CHECK(undoes(embed(oscillator, theta<1, 3>)));
    CHECK(undoes(embed(driven, order_one)));
    CHECK(undoes(embed(driven, theta<1, 3>)));
    CHECK(undoes(embed(damped, order_one)));
    CHECK(undoes(embed(damped, theta<1, 3>)));
    CHECK_FALSE(steps_as(embed(oscillator, order_one), adjoint(embed(oscillator, order_one))));
}

TEST_CASE("the adjoint of order one is order one from the left, of theta 1 - theta, of mid-point itself") {
    CHECK(steps_as(adjoint(embed(oscillator, order_one)), embed(oscillator, order_one_left)));
    CHECK(steps_as(adjoint(embed(oscillator, order_one_left)), embed(oscillator, order_one)));
    CHECK(steps_as(adjoint(embed(driven, order_one)), embed(driven, order_one_left)));
    CHECK(steps_as(adjoint(embed(driven, theta<1, 3>)), embed(driven, theta<2, 3>)));
    CHECK(steps_as(adjoint(embed(driven, mid_point)), embed(driven, mid_point)));
    CHECK(steps_as(adjoint(embed(damped, order_one)), embed(damped, order_one_left)));
}

TEST_CASE("an adjoint is known by its type") {
    auto const f = embed(oscillator, order_one);
    static_assert(std::same_as<decltype(adjoint(adjoint(f))), std::remove_const_t<decltype(f)>>);
    using right = std::remove_const_t<decltype(order_one)>;
    static_assert(facts_of<reversed<right>>.one_node and facts_of<reversed<right>>.at_end and not facts_of<reversed<right>>.at_start);
    static_assert(controls_of<reversed<right>> == 2);
    auto const verlet = stoermer_verlet(oscillator);
    static_assert(std::same_as<decltype(adjoint(adjoint(verlet))), std::remove_const_t<decltype(verlet)>>);
    // The times of the nodes are read from the other end too.
    auto const b = tableau_of(reversed<std::remove_const_t<decltype(theta<1, 3>)>>{theta<1, 3>}, Q(1, 5));
    CHECK(b.time(0, Q(1), Q(1, 5)) == Q(1) + Q(2, 3) * Q(1, 5));
    CHECK(b.w(0) == Q(1, 5));
}

} // namespace reversed_tests
