// SPDX-License-Identifier: BSL-1.0
// What the oscillator's energy, which these schemes keep, changes by in many steps is rounding alone. With compensated sums what a step
// leaves is of the size of h epsilon, and of either sign: a random walk, and no multiple of the number of steps.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "hilger/hilger.hpp"

namespace leaning_tests {

using namespace hilger;

/// The distance of the energy of each component from that of the start, in units of epsilon.
template <class Flow, class V>
double farthest(Flow const& flow, double h, int steps, V const& q, V const& p) {
    auto last = state<double, V>{0.0, q, p};
    for (auto const& x : flow.along(uniform(0.0, h, steps), q, p)) last = x;
    auto const energy = [](state<double, V> const& x, int c) {
        long double const a = detail::shape<V>::component(x.q, c), b = detail::shape<V>::component(x.p, c);
        return (a * a + b * b) / 2;
    };
    long double most = 0;
    for (int c = 0; c < detail::shape<V>::dimension(q); ++c) {
        long double const start = energy({0.0, q, p}, c);
        most = std::max(most, std::abs(energy(last, c) - start) / start);
    }
    return static_cast<double>(most) / std::numeric_limits<double>::epsilon();
}
/// Three deviations of n errors of at most h epsilon each, and the rounding of the state itself.
double bound(double h, int steps) { return 3 * h * std::sqrt(static_cast<double>(steps)) + 4; }

TEST_CASE("one node: with h = 0.02 half of it makes few residues of positions and momenta") {
    auto const oscillator = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    CHECK(farthest(embed(oscillator, mid_point, compensated), 0.02, 100'000, 1.0, 0.0) < bound(0.02, 100'000));
    auto const pair = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; };
    Eigen::Vector2d const q(1, 1), p(0, 0);
    CHECK(farthest(embed(pair, mid_point, compensated), 0.02, 100'000, q, p) < bound(0.02, 100'000));
}

TEST_CASE("theta, whose numbers are rounded: what is said of q + c v and of p + f dL/dq adds up to one step") {
    auto const oscillator = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    // the energy that theta keeps: p^2/2 + q^2/2 + (1 - 2 theta) h p q / 2
    double const h = 0.5;
    int const n = 30'000;
    auto last = state<double, double>{0.0, 1.0, 0.0};
    for (auto const& x : embed(oscillator, theta<1, 3>, compensated).along(uniform(0.0, h, n), 1.0, 0.0)) last = x;
    long double const q = last.q, p = last.p, third = h * p * q / 6;
    long double const kept = (q * q + p * p) / 2, other = std::min(std::abs(kept + third - 0.5L), std::abs(kept - third - 0.5L));
    CHECK(static_cast<double>(other) < bound(h, n) * std::numeric_limits<double>::epsilon());
}

TEST_CASE("Galerkin: the numbers of the table are rounded, to the same side in every step") {
    auto const oscillator = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    int const n = 50'000;
    CHECK(farthest(embed(oscillator, galerkin<2, gauss>, compensated), 0.3, n, 1.0, 0.0) < bound(0.3, n));
    CHECK(farthest(embed(oscillator, galerkin<4, gauss>, compensated), 0.3, n, 1.0, 0.0) < bound(0.3, n));
}

TEST_CASE("five components, whose equation is linear: the factors of its matrix are rounded") {
    auto const five = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; };
    Eigen::VectorXd const q = Eigen::VectorXd::Constant(5, 1.0), p = Eigen::VectorXd::Zero(5);
    CHECK(farthest(embed(five, mid_point, compensated), 0.3, 30'000, q, p) < bound(0.3, 30'000));
}

} // namespace leaning_tests
