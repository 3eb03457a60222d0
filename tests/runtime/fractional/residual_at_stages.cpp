// SPDX-License-Identifier: BSL-1.0
// Trajectories damped at Radau's nodes solve their equation to the rounding of its terms, the damping summed by whole rows of weights: on
// equal, graded and uneven T, with small and large coefficients, of all orders; and what is off is seen.
#include <doctest/doctest.h>

#include "../history/stage_judge.hpp"
#include "hilger/hilger.hpp"

namespace residual_at_stages_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto pendulum = [](auto const& x, auto const& v) { return v * v / 2 + cos(x); };
template <class S>
time_scale<S> scale_of(std::vector<double> const& steps) {
    std::vector<S> points{S(0)};
    for (double const nu : steps) points.push_back(points.back() + S(nu));
    return time_scale<S>(points);
}
/// In roundings, with a history to rounding.
template <int Stages, class Scale>
double roundings(Scale const& T, double rho, double order, double tolerance = 0) {
    auto const flow = embed(with_fractional_damping(pendulum, rho, order, exponentials{tolerance}), galerkin<Stages, radau>);
    return relative_residual(flow.along(T, 1.0, 0.5));
}

} // namespace

TEST_CASE("the residual is some roundings of its terms, on any T and for any order") {
    auto const scales = steps_of_scales(12);
    for (auto const& steps : scales)
        for (double const order : {0.5, 1.5}) {
            CAPTURE(steps[0]);
            CAPTURE(order);
            CHECK(roundings<2>(scale_of<double>(steps), 0.5, order) <= 16);
            CHECK(roundings<3>(scale_of<double>(steps), 1e6, order) <= 16);
        }
    CHECK(roundings<1>(scale_of<double>(scales[1]), 0.5, 0.25) <= 16);
    CHECK(roundings<4>(scale_of<double>(scales[1]), 2.0, 0.75) <= 16);
    CHECK(roundings<2>(scale_of<double>(scales[2]), 2.0, 1.0) <= 16);
    CHECK(roundings<3>(uniform(0.0, 0.125, 12), 0.5, 0.5) <= 16);
    CHECK(roundings<3>(scale_of<double>(scales[2]), 1e-9, 1.99) <= 16);
}

TEST_CASE("the stages of Lobatto IIIC at Lobatto's nodes are judged too") {
    auto const damping = with_fractional_damping(pendulum, 0.5, 0.5, exponentials{}).damping.dampings;
    using reading = at_stages<typename std::remove_cvref_t<decltype(damping)>::value_type, 3, lobatto>;
    damped_flow const flow(embed(pendulum, galerkin<3, lobatto>), reading{damping});
    CHECK(relative_residual(flow.along(graded(0.0, 1.0, 12, 3.0), 1.0, 0.5)) <= 16);
    CHECK(largest_residual(flow.along(uniform(0.0, 0.25, 8), 1.0, 0.5)) < 1e-12);
}

TEST_CASE("a coarse history is seen, to its tolerance, and so is a damping of another order") {
    auto const T = graded(0.0, 2.0, 16, 2.0);
    double const coarse = roundings<3>(T, 1.0, 0.5, 1e-6) * epsilon<double>();
    CHECK(coarse > 1e-12);
    CHECK(coarse < 1e-5);
    auto const path =
        embed(with_fractional_damping(pendulum, 1.0, fraction<1, 2>{}, exponentials{1e-13}), galerkin<2, radau>).along(T, 1.0, 0.5);
    CHECK(largest_residual(path) < 1e-9);
    auto const undamped = equation_of(path.method().undamped(), T);
    CHECK(largest_residual(undamped, detail::positions_along(undamped, T, path)) > 1e-2);
}

TEST_CASE("several terms, forces, vectors, and 50 digits") {
    auto const T = graded(0.0, 1.0, 8, 3.0);
    auto const forced = with_force(pendulum, [](auto const& t, auto const& x, auto const& v) { return sin(t) - 0.25 * v + 0 * x; });
    std::vector<fractional_term<double>> const terms{{0.5, 0.5}, {0.25, 1.25}};
    CHECK(relative_residual(embed(with_fractional_damping(forced, terms, exponentials{}), galerkin<3, radau>).along(T, 1.0, 0.5)) <= 16);
    using V = Eigen::Vector2d;
    auto const plane = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2 + q(0) * q(1) * q(1); };
    auto const one_damped = embed(with_fractional_damping(plane, V(0.5, 0), 0.5, exponentials{}), galerkin<2, radau>);
    CHECK(relative_residual(one_damped.along(T, V(1, 0.5), V(-0.5, 0.25))) <= 16);
    auto const wide = embed(with_fractional_damping(pendulum, float50(0.5), float50(0.5), exponentials{1e-16}), galerkin<2, radau>);
    auto const path = wide.along(graded(float50(0), float50(1), 3, float50(3)), float50(1), float50(0.5));
    CHECK(relative_residual(path) * epsilon<float50>() <= 1e-15);
}

} // namespace residual_at_stages_tests
