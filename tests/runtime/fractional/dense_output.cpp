// SPDX-License-Identifier: BSL-1.0
// Between the points of a damped trajectory, and at its events: slopes with the force of the history, so that what is between the points
// is as good as they are.
#include <doctest/doctest.h>

#include "hilger/trajectory/events.hpp"
#include "orders.hpp"
#include "support/systems.hpp"

namespace fractional_dense_output_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto momentum = [](auto const& x) { return x.p; };

/// u'' + 1.5 D^(1/2) u + 4 u = 0 from u = 1 at rest, over [0, 4].
constexpr lagrangian stiffer{[](auto const& x, auto const& v) { return v * v / 2 - 2 * x * x; }};
template <class Damped>
auto along(Damped const& damped, int N) {
    return embed(damped, mid_point).along(uniform(interval{0.0, 4.0}, N), 1.0, 0.0);
}
/// The first time at which u' is zero again, by bisection of the series.
double time_of_rest() {
    fractional_oscillator<float50> const wide{float50(3) / 2, float50(1) / 2, 4, 1, 0, 0};
    float50 left = float50("1.3"), right = float50("1.4");
    while (right - left > float50("1e-16")) {
        float50 const middle = (left + right) / 2;
        (wide.at(middle).v < 0 ? left : right) = middle;
    }
    return static_cast<double>(left);
}
/// The order with which `error(N)` falls.
template <class Error>
double order_in(Error const& error, int coarsest = 320) {
    std::vector<double> all;
    for (int const N : {coarsest, 2 * coarsest, 4 * coarsest}) all.push_back(error(N));
    return fitted_slope(all);
}
/// |p' + u - F| at t = 1/2, p' by a central difference, and F the force at the point reached last or, one step later, at the one before.
template <class Damped>
double force_error(Damped const& damped, int N, bool back) {
    double const h = 1.0 / N;
    auto const path = embed(damped, mid_point).along(uniform(0.0, h, N), u0, v0);
    auto at = path.begin();
    while (at.number() < N / 2 - 1) ++at;
    double const before = at->p;
    double const here = (++at)->q;
    double force = at.remembered().damping_force();
    ++at;
    if (back) force = at.remembered().damping_force(true);
    return std::abs((at->p - before) / (2 * h) + here - force);
}

} // namespace

TEST_CASE("the force of a mean damping at the points is of order two") {
    for (bool const back : {false, true}) {
        CAPTURE(back);
        auto const order = [&](auto const& damped) { return order_in([&](int N) { return force_error(damped, N, back); }); };
        CHECK(std::abs(order(with_fractional_damping(spring, c, fraction<1, 2>{})) - 2) < 0.02);
        CHECK(std::abs(order(with_fractional_damping(spring, c, fraction<1>{})) - 2) < 0.02);
        CHECK(std::abs(order(with_fractional_damping<bdf<2>>(spring, c, 0.75)) - 2) < 0.02);
        CHECK(std::abs(order(with_fractional_impulses(spring, c, fraction<1, 2>{})) - 1) < 0.02);
    }
}

TEST_CASE("dense output of a damped path has the order of its points, in q and in p") {
    fractional_oscillator<float50> const wide{float50(3) / 2, float50(1) / 2, 4, 1, 0, 0};
    auto const exact = wide.at(float50(10) / 3);
    auto const error = [&](auto const& damped, bool of_p) {
        auto const at_once = [&](int N) {
            auto const x = dense_output(along(damped, N))(10.0 / 3);
            return of_p ? std::abs(x.p - static_cast<double>(exact.v)) : std::abs(x.q - static_cast<double>(exact.u));
        };
        return order_in(at_once, 640);
    };
    for (bool const of_p : {false, true}) {
        CHECK(std::abs(error(with_fractional_damping(stiffer, 1.5, fraction<1, 2>{}), of_p) - 2) < 0.02);
        CHECK(std::abs(error(with_fractional_damping<bdf<2>>(stiffer, 1.5, fraction<1, 2>{}), of_p) - 2) < 0.02);
    }
    // At the points it is what it was made of.
    auto const path = along(with_fractional_damping(stiffer, 1.5, fraction<1, 2>{}), 40);
    dense_output const between(path);
    for (auto const& x : path) CHECK(between(x.t) == x);
}

TEST_CASE("events of a damped path are where the fine steps have them") {
    double const exact = time_of_rest();
    CHECK(exact == doctest::Approx(1.377991).epsilon(1e-6));
    auto const error = [&](auto const& damped, int coarsest) {
        return order_in(
            [&](int N) {
                auto const path = along(damped, N);
                auto const rests = events(path, momentum);
                return std::abs((*rests.begin()).t - exact);
            },
            coarsest);
    };
    CHECK(std::abs(error(with_fractional_damping(stiffer, 1.5, fraction<1, 2>{}), 320) - 2) < 0.02);
    CHECK(std::abs(error(with_fractional_impulses(stiffer, 1.5, fraction<1, 2>{}), 640) - 1) < 0.02);
    // From a checkpoint, the history of which goes on.
    auto const path = along(with_fractional_damping(stiffer, 1.5, fraction<1, 2>{}), 160);
    auto at = path.begin();
    while (at.number() < 40) ++at;
    auto const rest = path.resume(at.checkpoint());
    auto const all = events(path, momentum);
    auto const later = events(rest, momentum);
    CHECK(*all.begin() == *later.begin());
}

TEST_CASE("vectors, with a damping of one component and of several terms") {
    constexpr lagrangian two{[](auto const& x, auto const& v) { return v.dot(v) / 2 - 2 * x(0) * x(0) - 2 * x(1) * x(1); }};
    auto const one = with_fractional_damping(two, Eigen::Vector2d(0, 1.5), fraction<1, 2>{});
    auto const T = uniform(interval{0.0, 4.0}, 80);
    Eigen::Vector2d const q(1, 1), zero(0, 0);
    auto const both = embed(one, mid_point).along(T, q, zero);
    auto const terms = embed(with_fractional_damping(stiffer, {{1.0, 0.5}, {0.5, 0.5}}), mid_point).along(T, 1.0, 0.0);
    auto const first = embed(stiffer, mid_point).along(T, 1.0, 0.0);
    auto const second = along(with_fractional_damping(stiffer, 1.5, fraction<1, 2>{}), 80);
    dense_output const together(both);
    dense_output const free(embed(stiffer, mid_point).mechanics(), record(first).states); // the cubic, as with a history
    dense_output const damped(second);
    dense_output const added(terms);
    for (double const t : {0.3, 1.01, 2.222, 3.99}) {
        auto const x = together(t);
        CHECK(std::abs(x.p(0) - free(t).p) < 64 * epsilon<double>());
        CHECK(std::abs(x.p(1) - damped(t).p) < 64 * epsilon<double>());
        CHECK(std::abs(x.q(1) - damped(t).q) < 64 * epsilon<double>());
        CHECK(std::abs(added(t).p - damped(t).p) < 64 * epsilon<double>());
    }
}

} // namespace fractional_dense_output_tests
