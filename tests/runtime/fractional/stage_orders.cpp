// SPDX-License-Identifier: BSL-1.0
// Orders of damping at Radau's nodes on graded T: min(2s - 1, s + 3 - mu) of positions and min(2s - 1, s + 2 - mu) of momenta, from x_0 and
// v_0 not zero, for nonlinear, forced and two-dimensional systems. The slope through the errors of N, 2N and 4N steps is that of the first
// and the last. On equal steps the start of the solution decides; papers/hariz_jimenez_ober_blobaum_2026 has orders on equal steps and
// largest errors over an interval.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "hilger/fractional/flow.hpp"
#include "hilger/multiprecision.hpp"

namespace fractional_stage_orders_tests {

using namespace hilger;

namespace {

constexpr auto pendulum = [](auto const& x, auto const& v) { return v * v / 2 + cos(x); };
/// x(1) of x'' + sin x + D^mu[x - 1 (- t)] = 0, x(0) = x'(0) = 1: with six stages and 64 steps in 50 digits.
struct known_end {
    long double mu, at_one;
};
constexpr known_end one_quarter{0.25L, 1.375777775450427784L}, half{0.5L, 1.341652124635186080L},
    three_quarters{0.75L, 1.311400608599814957L}, five_quarters{1.25L, 1.679957527364010615L}, three_halves{1.5L, 1.708271189103302414L};

template <int Stages, class S, class L, class V, class Scale>
V end_of(L const& l, S const& mu, Scale const& T, V const& q0, V const& v0) {
    double const tolerance = std::is_same_v<S, float50> ? 1e-16 : 1e-17;
    V last = q0;
    for (auto const& x :
         embed(with_fractional_damping(l, S(1), mu, exponentials{tolerance}), galerkin<Stages, radau>).along(T, initial_velocity{q0, v0}))
        last = x.q;
    return last;
}
template <int Stages, class S = long double>
double pendulum_order(known_end const& of, double gamma, int N) {
    using std::abs;
    auto const error = [&](int n) {
        return static_cast<double>(abs(S(end_of<Stages>(pendulum, S(of.mu), graded(S(0), S(1), n, S(gamma)), S(1), S(1)) - S(of.at_one))));
    };
    return std::log2(error(N) / error(4 * N)) / 2;
}
/// Largest distances of positions, and of momenta, from five stages and 64 steps at eight points of T.
template <class L, class V>
struct distances {
    L l;
    long double mu, gamma;
    V q0, v0;

    template <int Stages>
    [[nodiscard]] auto states(int N) const {
        std::vector<state<long double, V>> at;
        int i = 0;
        for (auto const& x : embed(with_fractional_damping(l, 1.0L, mu, exponentials{1e-17}), galerkin<Stages, radau>)
                                 .along(graded(0.0L, 1.0L, N, gamma), initial_velocity{q0, v0}))
            if (i++ % (N / 8) == 0) at.push_back(x);
        return at;
    }
    /// The slopes from N to 4N steps.
    template <int Stages>
    [[nodiscard]] std::pair<double, double> orders(int N) const {
        auto const best = states<5>(64), first = states<Stages>(N), last = states<Stages>(4 * N);
        auto const slope = [&](auto const& part) {
            auto const error = [&](auto const& x) {
                long double worst = 0;
                for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, magnitude(V(part(x[i]) - part(best[i]))));
                return static_cast<double>(worst);
            };
            return std::log2(error(first) / error(last)) / 2;
        };
        return {slope([](auto const& x) { return x.q; }), slope([](auto const& x) { return x.p; })};
    }
};

} // namespace

TEST_CASE("a pendulum with memory: two to five stages have the orders 2.9, 4.5, 6 and 7 at least") {
    for (known_end const& of : {one_quarter, half, three_quarters}) {
        CAPTURE(static_cast<double>(of.mu));
        CHECK(pendulum_order<2>(of, 2.5, 8) >= 2.9);
        CHECK(pendulum_order<3>(of, 3, 8) >= 4.5);
        CHECK(pendulum_order<4>(of, 3, 8) >= 6);
        CHECK(pendulum_order<5>(of, 4, 4) >= 7);
    }
}

TEST_CASE("above order 1 they are 2.7, 3.9 and 5") {
    for (known_end const& of : {five_quarters, three_halves}) {
        CAPTURE(static_cast<double>(of.mu));
        CHECK(pendulum_order<2>(of, 2.5, 8) >= 2.7);
        CHECK(pendulum_order<3>(of, 3, 16) >= 3.9);
        CHECK(pendulum_order<4>(of, 3, 8) >= 5);
    }
}

TEST_CASE("in 50 digits, and no more than min(2s - 1, s + 3 - mu)") {
    CHECK(std::abs(pendulum_order<3, float50>(half, 3, 8) - 4.75) <= 0.25);
    CHECK(std::abs(pendulum_order<4, float50>(half, 3, 8) - 6.5) <= 0.25);
}

TEST_CASE("equal steps: four stages have the order 5.5 at t = 1") {
    auto const error = [](int N) {
        long double const at_one = end_of<4>(pendulum, 0.5L, uniform(interval{0.0L, 1.0L}, N), 1.0L, 1.0L);
        return static_cast<double>(std::abs(at_one - half.at_one));
    };
    CHECK(std::abs(std::log2(error(8) / error(32)) / 2 - 5.5) <= 0.1);
}

TEST_CASE("a forced pendulum and two coupled components: positions have the same orders, and momenta one less where mu limits them") {
    auto const check = [](auto const& of) {
        auto const three = of.template orders<3>(8), four = of.template orders<4>(8);
        CHECK(three.first >= 4.5);
        CHECK(four.first >= 6);
        CHECK(three.second >= 4); // s + 2 - mu in the end
        CHECK(four.second >= 5);
    };
    auto const forced = with_force(pendulum, [](auto const& t, auto const& x, auto const&) { return 0 * x + 2 * sin(3 * t + 1); });
    check(distances<std::remove_cvref_t<decltype(forced)>, long double>{forced, 0.5L, 3, 1, 1});
    auto const henon_heiles = [](auto const& q, auto const& v) {
        return v.dot(v) / 2 - q.dot(q) / 2 - q(0) * q(0) * q(1) + q(1) * q(1) * q(1) / 3;
    };
    using V = Eigen::Matrix<long double, 2, 1>;
    check(distances<std::remove_cvref_t<decltype(henon_heiles)>, V>{henon_heiles, 0.5L, 3, V(0.3L, -0.2L), V(0.1L, 0.4L)});
}

} // namespace fractional_stage_orders_tests
