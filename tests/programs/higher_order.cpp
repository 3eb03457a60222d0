// SPDX-License-Identifier: BSL-1.0
// Programs with steps of higher order. Their equations are in positions that a trajectory does not have: compositions are judged by the
// steps that they are made of, and Galerkin's of Gauss nodes by the collocation that they are.
#include "hilger/composition/methods.hpp"
#include "programs.hpp"
#include "systems.hpp"

namespace higher_order_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

constexpr auto friction = [](auto const& q, auto const& v) { return -v / 4 - q * q * v / 8; };

/// The distance of a walk along `path` from one that takes the parts of each step by hand: part(x, h).
template <class Path, class Part>
double distance_from_its_parts(Path const& path, Part const& part) {
    double worst = 0;
    auto y = *path.begin();
    for (auto const& x : path) {
        y.t = x.t;
        worst =
            std::max({worst, double(magnitude(plain_t<decltype(x.q)>(x.q - y.q))), double(magnitude(plain_t<decltype(x.p)>(x.p - y.p)))});
        if (x.t < path.scale().max()) y = part(y, path.scale().h());
    }
    return worst;
}
/// Rounding of N steps, each of so many parts, grows no faster than this for systems that are not chaotic.
double rounding(int steps, int parts) { return 64 * steps * parts * epsilon<double>(); }

/// Two Gauss nodes collocate the equation: q' = p, p' = -sin q + f(q, p) for a pendulum with friction, iterated until nothing changes.
state<double, double> collocated(state<double, double> const& x, double h) {
    double const r = std::sqrt(3.0) / 6;
    double const a[2][2] = {{0.25, 0.25 - r}, {0.25 + r, 0.25}};
    double v[2] = {x.p, x.p}, f[2] = {0, 0};
    for (int round = 0; round < 60; ++round) {
        double next_v[2], next_f[2];
        for (int k = 0; k < 2; ++k) {
            next_v[k] = x.p + h * (a[k][0] * f[0] + a[k][1] * f[1]);
            double const q = x.q + h * (a[k][0] * v[0] + a[k][1] * v[1]);
            next_f[k] = -std::sin(q) + friction(q, next_v[k]);
        }
        for (int k = 0; k < 2; ++k) v[k] = next_v[k], f[k] = next_f[k];
    }
    return {x.t + h, x.q + h * (v[0] + v[1]) / 2, x.p + h * (f[0] + f[1]) / 2};
}

} // namespace

TEST_CASE("a composition makes the steps of its parts, forces included") {
    auto const T = uniform(0.0, 0.125, 40);
    auto const flow = embed(with_force(pendulum, friction), mid_point);
    auto const path = compose(shares<fraction<1, 3>, fraction<2, 3>>{}, flow).along(T, 1.0, 0.5);
    CHECK(distance_from_its_parts(path, [&](auto const& x, double h) { return flow.step(flow.step(x, h / 3), 2 * h / 3); }) <
          rounding(40, 2));
    auto const right = embed(row_of_contacts, order_one);
    auto const left = embed(row_of_contacts, order_one_left);
    using V = Eigen::Vector2d;
    CHECK(distance_from_its_parts(stoermer_verlet(row_of_contacts).along(T, place<V>(), push<V>()),
                                  [&](auto const& x, double h) { return left.step(right.step(x, h / 2), h / 2); }) < rounding(40, 2));
}

TEST_CASE("a Galerkin step of Gauss nodes collocates, forces included") {
    auto const path = embed(with_force(pendulum, friction), galerkin<2, gauss>).along(uniform(0.0, 0.125, 40), 1.0, 0.5);
    CHECK(distance_from_its_parts(path, collocated) < rounding(40, 1));
}

} // namespace higher_order_tests
