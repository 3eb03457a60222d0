// SPDX-License-Identifier: BSL-1.0
// Steps that are long, or uneven, are made wherever the steps of all lesser lengths lead to them: Newton's method alone does not arrive.
#include <array>
#include <cmath>
#include <vector>

#include "runtime/step/whole_walks.hpp"

namespace long_steps_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// Every mid-point and every Gauss step has a solution, and mid-point one alone: p = v + h/2 (q + h v/2)^3.
struct quartic {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        if constexpr (requires { q.size(); }) {
            auto const square = q.array() * q.array();
            return v.squaredNorm() / 2 - (square * square).sum() / 4;
        } else
            return v * v / 2 - q * q * q * q / 4;
    }
};
auto const beads = mechanical(1.0, chain{[](index_type k, auto const& r) { return k == 0 ? r * r * r * r / 4 : 0 * r; }});

/// A stiff wall at 1, behind which the force begins with a kink, beside waves: V = 50 max(q - 1, 0)^2 - 3 cos(2 q).
struct wall {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        if constexpr (requires { q.size(); }) {
            auto sum = v.squaredNorm() / 2 + 0 * q(0);
            for (int k = 0; k < q.size(); ++k) {
                auto const behind = max(q(k) - 1, 0.0);
                sum += 3 * cos(2 * q(k)) - 50 * behind * behind;
            }
            return sum;
        } else {
            auto const behind = max(q - 1, 0.0);
            return v * v / 2 + 3 * cos(2 * q) - 50 * behind * behind;
        }
    }
};
auto const walled = mechanical(1.0, chain{[](index_type k, auto const& r) {
                                   auto const behind = max(r - 1, 0.0);
                                   return k == 0 ? 50 * behind * behind - 3 * cos(2 * r) : 0 * behind;
                               }});

template <class V>
double first(V x) {
    return detail::shape<V>::component(x, 0);
}

/// The velocity of the mid-point step of the quartic, between two at which p - v - h/2 (q + h v/2)^3 has both signs.
double by_bisection(double q, double p, double h) {
    double low = -1e6, high = 1e6;
    for (int round = 0; round < 200; ++round) {
        double const v = (low + high) / 2, at = q + h / 2 * v;
        (p - v - h / 2 * at * at * at > 0 ? low : high) = v;
    }
    return (low + high) / 2;
}

template <class V, class L>
void solves_long_steps(L const& l, int d) {
    CAPTURE(d);
    for (double const h : {0.5, 2.0, 8.0, 50.0, 1e5})
        for (double const q : {-9.0, 0.01, 3.0})
            for (double const p : {-7.0, 0.3, 8.0}) {
                CAPTURE(h);
                CAPTURE(q);
                CAPTURE(p);
                auto const states = record(embed(l, mid_point).along(uniform(0.0, h, 1), all<V>(d, q), all<V>(d, p))).states;
                double const v = by_bisection(q, p, h), at = q + h / 2 * v, bend = 3 * h / 2 * at * at;
                // what rounding does to the two sides, over how much their difference changes with v
                double const rounding = std::abs(p) + std::abs(v) + h / 2 * std::abs(at * at * at) + bend * (std::abs(q) + h * std::abs(v)),
                             change = 1 + h / 2 * bend;
                CHECK(std::abs(first(states.back().q) - (q + h * v)) <=
                      16 * epsilon<double>() * (h * rounding / change + std::abs(q) + h * std::abs(v)));
            }
}

/// Steps into the wall, and out of it, that have one solution each: what it leaves of p - v + h/2 F(q + h v/2) is rounding.
template <class V, class L>
void goes_through_the_wall(L const& l, int d) {
    CAPTURE(d);
    for (auto const& given : {std::array{1.75, 1.3125, 1.3125},
                              {1.1875, 1.3125, -0.4375},
                              {1.4375, 1.5, 0.0},
                              {1.125, 2.375, -0.875},
                              {1.6875, 0.3125, 2.0625},
                              {1.625, 1.125, 1.0},
                              {0.875, -0.9375, 0.0},
                              {1.1875, 0.125, 2.9375}}) {
        double const h = given[0], q = given[1], p = given[2];
        CAPTURE(h);
        CAPTURE(q);
        auto const walk = embed(l, mid_point).along(uniform(0.0, h, 1), all<V>(d, q), all<V>(d, p));
        if (walked_whole(walk, 1)) {
            double const v = (first(record(walk).states.back().q) - q) / h, at = q + h / 2 * v;
            double const rounding = std::abs(p) + std::abs(v) + h / 2 * 100 * (1 + std::abs(q) + h * std::abs(v));
            CHECK(std::abs(p - v - h / 2 * (100 * std::max(at - 1, 0.0) + 6 * std::sin(2 * at))) <= 16 * epsilon<double>() * rounding);
        }
    }
}

/// Lengths between 0.05 and 5, one unlike the next.
std::vector<double> uneven(int steps) {
    std::vector<double> t{0};
    for (int k = 0; k < steps; ++k) t.push_back(t.back() + 0.05 * std::pow(100, std::fmod(0.618033988749895 * (k + 1), 1)));
    return t;
}

template <class V, class L, class E>
void walks_unevenly(L const& l, E const& how, int d, double q0, double p0) {
    CAPTURE(how.name);
    CAPTURE(d);
    CAPTURE(q0);
    int const steps = 60;
    auto const walk = embed(l, how).along(time_scale(uneven(steps)), all<V>(d, q0), all<V>(d, p0));
    double const h = 0.05; // at a point two steps meet; d2L/dq2 = 3 q^2 at most
    if (auto const most = walked_whole(walk, steps))
        CHECK(largest_residual(walk) <= 16 * epsilon<double>() * (most->q / (h * h) + most->p / h + 3 * most->q * most->q * most->q));
}

/// The velocity of a pendulum's mid-point step as h grows by a thousandth at once.
double grown(double q, double p, double h) {
    double v = p;
    int const parts = 1000;
    for (int k = 1; k <= parts; ++k) {
        double const c = h * k / parts / 2;
        for (int round = 0; round < 20; ++round) v -= (v - p + c * std::sin(q + c * v)) / (1 + c * c * std::cos(q + c * v));
    }
    return v;
}

} // namespace

TEST_CASE("steps grow through kinks, too") {
    goes_through_the_wall<double>(wall{}, 1);
    goes_through_the_wall<Eigen::Vector2d>(wall{}, 2);
    goes_through_the_wall<Eigen::VectorXd>(wall{}, 5);
    goes_through_the_wall<Eigen::VectorXd>(walled, 1);
}
TEST_CASE("long steps have the solution that bisection finds") {
    solves_long_steps<double>(quartic{}, 1);
    solves_long_steps<Eigen::Vector2d>(quartic{}, 2);
    solves_long_steps<Eigen::VectorXd>(quartic{}, 3);
    solves_long_steps<Eigen::VectorXd>(beads, 2);
}

TEST_CASE("walks of long uneven steps are walked to their ends") {
    for (double const q0 : {1.0, 2.5, -3.0}) {
        walks_unevenly<double>(quartic{}, mid_point, 1, q0, 0.5);
        walks_unevenly<Eigen::Vector4d>(quartic{}, mid_point, 4, q0, 0.5);
        walks_unevenly<Eigen::VectorXd>(quartic{}, mid_point, 3, q0, 0.5);
        walks_unevenly<Eigen::VectorXd>(beads, mid_point, 3, q0, 0.5);
        walks_unevenly<double>(quartic{}, galerkin<2, gauss>, 1, q0, 0.5);
        walks_unevenly<Eigen::VectorXd>(quartic{}, galerkin<2, gauss>, 2, q0, 0.5);
    }
}

TEST_CASE("of several solutions the one that lesser steps lead to is found") {
    auto const pendulum = [](auto const& q, auto const& v) {
        if constexpr (requires { q.size(); })
            return v.squaredNorm() / 2 + q.array().cos().sum();
        else
            return v * v / 2 + cos(q);
    };
    // Newton's method does not arrive from p; by steps that grow too fast it arrives at others.
    for (auto const& given : {std::array{1.42, -2.84, 4.18},
                              {1.52, 1.27, 4.76},
                              {1.96, 1.31, 3.69},
                              {-0.55, 2.78, 3.58},
                              {-2.28, -1.1, 4.02},
                              {2.05, 1.02, 5.45},
                              {-2.35, -0.76, 3.74},
                              {2.6, 0.5, 3.94}}) {
        double const q = given[0], p = given[1], h = given[2];
        CAPTURE(q);
        double const v = grown(q, p, h);
        auto const T = uniform(0.0, h, 1);
        double const end = q + h * v, bound = 1e-12 * (std::abs(q) + h * std::abs(v));
        CHECK(std::abs(record(embed(pendulum, mid_point).along(T, q, p)).states.back().q - end) <= bound);
        CHECK(std::abs(
                  record(embed(pendulum, mid_point).along(T, all<Eigen::VectorXd>(2, q), all<Eigen::VectorXd>(2, p))).states.back().q(1) -
                  end) <= bound);
    }
}

TEST_CASE("a step that no lesser step leads to is refused, and the next one is of its own length") {
    // The equation has two solutions, which meet in a fold as h grows, and behind it none; its mass is not constant, so that Galerkin
    // steps solve it too.
    auto const falling = [](auto const& q, auto const& v) {
        if constexpr (requires { q.size(); })
            return (1 + q(0) * q(0) / 64) * v.squaredNorm() / 2 + 1 / q(0);
        else
            return (1 + q * q / 64) * v * v / 2 + 1 / q;
    };
    // The force jumps at 0, and the root with it; both branches are looked for, and the continuation is tried last.
    auto const with_a_jump = [](auto const& q, auto const& v) {
        if constexpr (requires { q.size(); })
            return (1 + q(0) * q(0) / 64) * v.squaredNorm() / 2 - abs(q(0));
        else
            return (1 + q * q / 64) * v * v / 2 - abs(q);
    };
    auto const refuses = []<class V>(std::type_identity<V>, auto const& flow, int d, double q) {
        using stepper = typename std::remove_cvref_t<decltype(flow)>::template stepper<double, V>;
        double const h = 0.25;
        V const at_rest = all<V>(d, 0);
        state<double, V> near{0, all<V>(d, q), at_rest}, far{0, all<V>(d, 1), at_rest}, same = far;
        stepper used(flow, h, at_rest), fresh(flow, h, at_rest);
        CHECK_THROWS_AS(used.advance(flow, near, h), error::no_convergence);
        CHECK(first(near.q) == q);
        used.advance(flow, far, h);
        fresh.advance(flow, same, h);
        CHECK(std::abs(first(far.q) - first(same.q)) <= 4 * epsilon<double>());
        CHECK(first(same.q) < 0.98);
    };
    auto const all_refuse = [&](auto const& L, double q) {
        refuses(std::type_identity<double>{}, embed(L, mid_point), 1, q);
        refuses(std::type_identity<Eigen::Vector2d>{}, embed(L, mid_point), 2, q);
        refuses(std::type_identity<Eigen::VectorXd>{}, embed(L, mid_point), 2, q);
        refuses(std::type_identity<double>{}, embed(L, galerkin<2, gauss>), 1, q);
        refuses(std::type_identity<Eigen::VectorXd>{}, embed(L, galerkin<2, gauss>), 2, q);
    };
    all_refuse(falling, 0.1);
    all_refuse(with_a_jump, 0.002);
}

} // namespace long_steps_tests
