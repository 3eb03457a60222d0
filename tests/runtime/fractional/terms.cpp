// SPDX-License-Identifier: BSL-1.0
// Several fractional dampings at once are added up, however they are written: of order two against a power series, and what one term of
// the same sum would be.
#include <doctest/doctest.h>

#include "orders.hpp"
#include "support/histories.hpp"
#include "support/systems.hpp"

namespace fractional_terms_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// u(1) and u'(1) of u'' + c_1 D^a u + c_2 D^b u + u = 0, Caputo, as the power series of its Laplace transform: with
/// 1 / (s^2 + X) = sum_n (-X)^n s^{-2n-2}, X = c_1 s^a + c_2 s^b + 1, and s^-e the transform of t^{e-1} / Gamma(e).
std::array<long double, 2> two_terms(long double c1, long double a, long double c2, long double b, long double u, long double v) {
    std::array<long double, 2> sum{0, 0};
    auto const add = [&](long double factor, long double power_of_s) {
        for (int n = 0; n <= 40; ++n)
            for (int i = 0; i <= n; ++i)
                for (int j = 0; i + j <= n; ++j) {
                    long double const ways =
                        std::tgamma(n + 1.0L) / (std::tgamma(i + 1.0L) * std::tgamma(j + 1.0L) * std::tgamma(n - i - j + 1.0L));
                    long double const e = 2 * n + 2 - power_of_s - a * i - b * j;
                    long double const term = factor * (n % 2 == 0 ? 1 : -1) * ways * std::pow(c1, i) * std::pow(c2, j);
                    sum[0] += term / std::tgamma(e);
                    sum[1] += term * (e - 1) / std::tgamma(e);
                }
    };
    add(u, 1), add(v, 0);
    for (auto const& [c, order] : {std::array{c1, a}, std::array{c2, b}}) {
        add(c * u, order - 1);
        if (order > 1) add(c * v, order - 2);
    }
    return sum;
}
template <class Flow>
void is_of_order_two(Flow const& flow, std::array<long double, 2> const& exact) {
    std::vector<double> eq, ep;
    for (int const N : {512, 1024, 2048}) {
        state<double, double> last;
        for (auto const& x : flow.along(uniform(interval{0.0, 1.0}, N), u0, v0)) last = x;
        eq.push_back(static_cast<double>(std::abs(last.q - exact[0])));
        ep.push_back(static_cast<double>(std::abs(last.p - exact[1])));
    }
    CHECK(std::abs(fitted_slope(eq) - 2) < 0.02);
    CHECK(std::abs(fitted_slope(ep) - 2) < 0.02);
}

} // namespace

TEST_CASE("the series with one term is the series of one term") {
    auto const both = two_terms(0.3L, 0.5L, 0.4L, 0.5L, 1, -0.5L);
    auto const one = reference(fraction<1, 2>{}, initial_history::caputo);
    CHECK(std::abs(static_cast<double>(both[0]) - one.u) < 1e-15);
    CHECK(std::abs(static_cast<double>(both[1]) - one.v) < 1e-15);
}

TEST_CASE("two terms, below and above order 1, have order two") {
    auto const low = two_terms(0.4L, 0.25L, 0.3L, 0.75L, u0, v0), high = two_terms(0.4L, 0.5L, 0.3L, 1.25L, u0, v0);
    is_of_order_two(embed(with_fractional_damping(spring, {{0.4, 0.25}, {0.3, 0.75}}), mid_point), low);
    is_of_order_two(embed(with_fractional_damping<bdf<2>>(spring, {{0.4, 0.25}, {0.3, 0.75}}), mid_point), low);
    is_of_order_two(embed(with_fractional_damping(spring, {{0.4, 0.5}, {0.3, 1.25}}, blocks{}), mid_point), high);
}

TEST_CASE("the sum of terms is the same however it is written") {
    auto const T = uniform(0.0, 0.05, 100);
    auto const one = positions(embed(with_fractional_damping(pendulum, 0.5, 0.75), mid_point), T, 1.0, 0.5);
    auto const listed = positions(embed(with_fractional_damping(pendulum, {{0.2, 0.75}, {0.3, 0.75}}), mid_point), T, 1.0, 0.5);
    std::vector<fractional_term<double>> const made{{0.2, 0.75}, {0.3, 0.75}};
    CHECK(positions(embed(with_fractional_damping(pendulum, made), mid_point), T, 1.0, 0.5) == listed);
    for (std::size_t k = 0; k < one.size(); ++k) CHECK(std::abs(one[k] - listed[k]) < 64 * epsilon<double>());
    CHECK(positions(embed(with_fractional_damping(pendulum, {{0.0, 0.5}, {0, 0.75}}), mid_point), T, 1.0, 0.5) ==
          positions(embed(pendulum, mid_point, compensated), T, 1.0, 0.5)); // as orders that may be above 1 are
    auto const kept =
        positions(embed(with_fractional_damping(pendulum, {{0.2, 0.5}, {0.3, 1.25}}, exponentials{0, 100}), mid_point), T, 1.0, 0.5);
    auto const summed = positions(embed(with_fractional_damping(pendulum, {{0.2, 0.5}, {0.3, 1.25}}), mid_point), T, 1.0, 0.5);
    for (std::size_t k = 0; k < kept.size(); ++k) CHECK(std::abs(kept[k] - summed[k]) < 1024 * epsilon<double>());

    // Two springs beside each other, each with a damper of its own.
    constexpr lagrangian two{[](auto const& x, auto const& v) { return v.dot(v) / 2 + cos(x(0)) + cos(x(1)); }};
    auto const apart = with_fractional_damping(two, Eigen::Vector2d(0.5, 0.2), 0.75);
    auto const vectors = positions(embed(apart, mid_point), T, Eigen::Vector2d(1, -1), Eigen::Vector2d(0.5, 0));
    auto const second = positions(embed(with_fractional_damping(pendulum, 0.2, 0.75), mid_point), T, -1.0, 0.0);
    for (std::size_t k = 0; k < one.size(); ++k) {
        CHECK(std::abs(vectors[k](0) - one[k]) < 64 * epsilon<double>());
        CHECK(std::abs(vectors[k](1) - second[k]) < 64 * epsilon<double>());
    }
    // One history for each component of each term.
    auto const both = with_fractional_damping(two, {{0.5, 0.75}, {0.2, 0.5}});
    auto const path = embed(both, mid_point).along(T, Eigen::Vector2d(1, -1), Eigen::Vector2d(0.5, 0));
    auto at = path.begin();
    for (int k = 0; k < 20; ++k) ++at;
    CHECK(testing::numbers_of_histories(at.remembered(), path.method()) == 4 * 21);
}

TEST_CASE("each term is checked") {
    CHECK_THROWS_AS((void)with_fractional_damping(pendulum, {{0.1, 0.5}, {0.1, 2.0}}), error::invalid_parameter);
    CHECK_THROWS_AS((void)with_fractional_damping(pendulum, {{std::nan(""), 0.5}}), error::invalid_parameter);
}

} // namespace fractional_terms_tests
