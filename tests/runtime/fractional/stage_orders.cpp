// SPDX-License-Identifier: BSL-1.0
// Orders of damping at Radau's nodes on graded T: min(2s - 1, s + 3 - mu) of positions, min(2s - 1, s + 2 - mu) of momenta, from x_0 and
// v_0 not zero, for nonlinear, forced and two-dimensional systems. The slope through the errors of N, 2N and 4N steps is that of the first
// and the last. On a T that is graded too little the start of the solution decides; see papers/hariz_jimenez_ober_blobaum_2026 too.
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
/// A flow on T graded by gamma, and six stages on all points of T for N = 64, with points between them and a graded first step.
template <class L, class V>
class compared {
public:
    compared(L l, long double mu, long double gamma, V q0, V v0)
        : l_(std::move(l)), mu_(mu), gamma_(gamma), q0_(std::move(q0)), v0_(std::move(v0)) {
        auto const T = graded(0.0L, 1.0L, most, gamma);
        std::vector<long double> points{0};
        for (int k = 1; k <= inner; ++k) points.push_back(T.element(1) * std::pow(static_cast<long double>(k) / inner, 4.0L));
        for (int i = 1; i < most; ++i) {
            points.push_back((T.element(i) + T.element(i + 1)) / 2);
            points.push_back(T.element(i + 1));
        }
        best_ = states<6>(time_scale<long double>(points));
    }
    /// The slopes of the largest errors of positions and of momenta over [0, 1], from N to 4N steps.
    template <int Stages>
    [[nodiscard]] std::pair<double, double> orders(int N) const {
        auto const first = errors<Stages>(N), last = errors<Stages>(4 * N);
        return {std::log2(first.first / last.first) / 2, std::log2(first.second / last.second) / 2};
    }

private:
    static constexpr int most = 64, inner = 24;
    template <int Stages, class Scale>
    [[nodiscard]] auto states(Scale const& T) const {
        std::vector<state<long double, V>> all;
        for (auto const& x : embed(with_fractional_damping(l_, 1.0L, mu_, exponentials{1e-17}), galerkin<Stages, radau>)
                                 .along(T, initial_velocity{q0_, v0_}))
            all.push_back(x);
        return all;
    }
    template <int Stages>
    [[nodiscard]] std::pair<double, double> errors(int N) const {
        auto const all = states<Stages>(graded(0.0L, 1.0L, N, gamma_));
        long double of_q = 0, of_p = 0;
        for (int i = 1; i <= N; ++i) {
            auto const& exact = best_[static_cast<std::size_t>(inner + 2 * (i * (most / N) - 1))];
            auto const& x = all[static_cast<std::size_t>(i)];
            of_q = std::max(of_q, magnitude(V(x.q - exact.q)));
            of_p = std::max(of_p, magnitude(V(x.p - exact.p)));
        }
        return {static_cast<double>(of_q), static_cast<double>(of_p)};
    }
    L l_;
    long double mu_, gamma_;
    V q0_, v0_;
    std::vector<state<long double, V>> best_;
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
    CHECK(std::abs(pendulum_order<4, float50>(half, 3, 8) - 6.5) <= 0.25);
}

TEST_CASE("largest errors over the interval: gamma (3 - mu) where T is graded too little, gamma (2 - mu) of momenta; 1 more for mu > 1") {
    // the solution begins like t^{3 - mu}, and for mu > 1 like t^{4 - mu}, as v_0 t is left out
    auto const check = [](auto stages, long double mu, long double gamma, double of_q, double of_p) {
        compared const of(pendulum, mu, gamma, 1.0L, 1.0L);
        auto const [q, p] = of.template orders<stages>(16);
        CAPTURE(static_cast<double>(gamma));
        CHECK(std::abs(q - of_q) <= 0.2);
        CHECK(std::abs(p - of_p) <= 0.2);
    };
    std::integral_constant<int, 3> const three;
    std::integral_constant<int, 4> const four;
    check(three, 0.5L, 1, 2.5, 1.5);
    check(four, 0.5L, 1, 2.5, 1.5);
    check(three, 0.5L, 2, 4.8, 3);
    check(four, 0.5L, 2, 5, 3);
    check(four, 0.75L, 3, 6.4, 3.75);
    check(four, 1.5L, 2, 5, 3);
}

TEST_CASE("far from the start equal steps have 5.5 with four stages") {
    auto const error = [](int N) {
        long double const at_one = end_of<4>(pendulum, 0.5L, uniform(interval{0.0L, 1.0L}, N), 1.0L, 1.0L);
        return static_cast<double>(std::abs(at_one - half.at_one));
    };
    CHECK(std::abs(std::log2(error(8) / error(32)) / 2 - 5.5) <= 0.1);
}

TEST_CASE("a forced pendulum and two coupled components have the same orders over the interval") {
    auto const check = [](auto const& of) {
        CHECK(of.template orders<2>(8).first >= 2.9);
        auto const three = of.template orders<3>(8), four = of.template orders<4>(8);
        CHECK(three.first >= 4.5);
        CHECK(four.first >= 6);
        CHECK(three.second >= 4);
        CHECK(four.second >= 4.3);
    };
    check(compared(with_force(pendulum, [](auto const& t, auto const& x, auto const&) { return 0 * x + 2 * sin(3 * t + 1); }), 0.5L, 3,
                   1.0L, 1.0L));
    auto const henon_heiles = [](auto const& q, auto const& v) {
        return v.dot(v) / 2 - q.dot(q) / 2 - q(0) * q(0) * q(1) + q(1) * q(1) * q(1) / 3;
    };
    using V = Eigen::Matrix<long double, 2, 1>;
    check(compared(henon_heiles, 0.5L, 3, V(0.3L, -0.2L), V(0.1L, 0.4L)));
}

} // namespace fractional_stage_orders_tests
