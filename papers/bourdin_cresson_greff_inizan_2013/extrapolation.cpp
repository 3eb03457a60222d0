// SPDX-License-Identifier: BSL-1.0
// The exponents of the error of two-sided fractional problems, fitted in 50 digits, and what is gained by them. An exponent that is missing
// in the sequence would be the order that is left after all others are removed; one too many would leave the order of the next.
#include <doctest/doctest.h>

#include "exact.hpp"
#include "hilger/boundary/extrapolation.hpp"
#include "hilger/multiprecision.hpp"
#include "support/two_sided.hpp"

namespace bourdin_extrapolation_tests {

using namespace hilger;
using namespace hilger::papers;
using hilger::testing::two_sided;

namespace {

using wide = float50;

/// x(1/2) for 4, 8, ..., 4 2^(count - 1) steps.
template <class L>
std::vector<wide> refined(L const& lagrangian, wide const& alpha, int count) {
    std::vector<wide> values;
    for (int N = 4; count-- > 0; N *= 2) {
        auto const T = uniform(interval{wide(0), wide(1)}, N);
        values.push_back(solve(two_sided(lagrangian, alpha, T), T, {.q0 = 0, .qN = 1})[N / 2]);
    }
    return values;
}
/// The order left after all exponents but number `kept` have been removed.
double order_of(std::vector<wide> values, std::vector<wide> const& exponents, std::size_t kept) {
    for (std::size_t e = 0; e < exponents.size(); ++e)
        if (e != kept) {
            for (std::size_t i = 0; i + 1 < values.size(); ++i)
                values[i] = values[i + 1] + (values[i + 1] - values[i]) / (pow(wide(2), exponents[e]) - 1);
            values.pop_back();
        }
    std::size_t const n = values.size();
    return static_cast<double>(log(wide((values[n - 3] - values[n - 2]) / (values[n - 2] - values[n - 1]))) / log(wide(2)));
}

} // namespace

TEST_CASE("the sequence is m (2 alpha - 1) + n, each once") {
    CHECK(error_exponents(Q(3, 4), 4) == std::vector<Q>{Q(1, 2), Q(1), Q(3, 2), Q(2)});
    CHECK(error_exponents(Q(7, 10), 5) == std::vector<Q>{Q(2, 5), Q(4, 5), Q(1), Q(6, 5), Q(7, 5)});
    CHECK(error_exponents(Q(1), 3) == std::vector<Q>{1, 2, 3});
    CHECK(error_exponents(Q(3, 4), 0).empty());
    auto const tenths = error_exponents(0.55, 12); // 3 (2 alpha - 1) is not 0.3 in double
    for (std::size_t i = 0; i < 12; ++i) CHECK(std::abs(tenths[i] - static_cast<double>(i + 1) / 10) <= 1e-15);
    CHECK_THROWS_AS((void)error_exponents(0.5, 3), error::invalid_parameter);
    CHECK_THROWS_AS((void)error_exponents(1.5, 3), error::invalid_parameter);
}

TEST_CASE("L = v^2/2: the exponents are fitted within 0.02, one by one") {
    wide const three_quarters = wide(3) / 4, nine_tenths = wide(9) / 10;
    auto const exponents = error_exponents(three_quarters, 7);
    auto const values = refined(dirichlet, three_quarters, 10);
    for (std::size_t e = 0; e < 4; ++e) CHECK(std::abs(order_of(values, exponents, e) - static_cast<double>(exponents[e])) <= 0.02);
    auto const others = refined(dirichlet, nine_tenths, 10);
    for (std::size_t e = 0; e < 2; ++e)
        CHECK(std::abs(order_of(others, error_exponents(nine_tenths, 7), e) - (e == 0 ? 0.8 : 1.0)) <= 0.02);
}

TEST_CASE("with a force the first two exponents are the same") {
    auto const oscillator = [](auto const& x, auto const& v) { return (x * x + v * v) / 2; };
    for (wide const& alpha : {wide(3) / 4, wide(9) / 10}) {
        auto const values = refined(oscillator, alpha, 9);
        auto const exponents = error_exponents(alpha, 6);
        for (std::size_t e = 0; e < 2; ++e) CHECK(std::abs(order_of(values, exponents, e) - static_cast<double>(exponents[e])) <= 0.02);
    }
}

TEST_CASE("alpha = 3/4: at most 3e-7 from N <= 2560, at every point of T") {
    for (int N : {5, 10, 20, 40}) {
        auto const T = uniform(interval{0.0, 1.0}, N);
        int levels = 0;
        while ((N << (levels + 1)) <= 2560) ++levels;
        auto const x = extrapolated(dirichlet_equation(0.75, T), boundary_values{0, 1}, levels);
        double worst = 0;
        for (int k = 0; k <= N; ++k) worst = std::max(worst, std::abs(x.q[k] - dirichlet_solution(0.75, T.point(k))));
        CHECK(worst <= (N == 5 ? 1e-10 : N == 10 ? 3e-9 : 1e-7));
        CHECK(worst <= 4 * x.change);
        CHECK(x.change <= (N == 40 ? 1e-6 : 5e-8));
        CHECK(x.q[N] == 1);
        CHECK(x.q[0] == 0);
    }
    double const plain = dirichlet_errors(0.75, 2560).largest;
    CHECK(plain > 3e-3);
}

TEST_CASE("vectors are extrapolated like scalars; no level is the solution itself; wrong exponents do not help") {
    using plane = Eigen::Vector2d;
    auto const T = uniform(interval{0.0, 1.0}, 8);
    auto const in_plane = [](auto const&, auto const& v) { return v.dot(v) / 2; };
    auto const x = extrapolated(two_sided(in_plane, 0.75, T), boundary_values{plane(0, 0), plane(1, -2)}, 5);
    auto const y = extrapolated(dirichlet_equation(0.75, T), boundary_values{0, 1}, 5);
    for (int k = 0; k <= 8; ++k) CHECK((x.q[k] - y.q[k] * plane(1, -2)).norm() <= 1024 * epsilon<double>());
    auto const none = extrapolated(dirichlet_equation(0.75, T), boundary_values{0, 1}, 0);
    CHECK(none.q[3] == solve(dirichlet_equation(0.75, T), T, boundary_values{0, 1})[3]);
    CHECK(none.change == 0);
    auto const wrong = extrapolated(dirichlet_equation(0.75, T), boundary_values{0, 1}, std::vector<double>{1, 2, 3, 4, 5});
    double const exact = dirichlet_solution(0.75, 0.5);
    CHECK(std::abs(wrong.q[4] - exact) > 100 * std::abs(y.q[4] - exact));
}

} // namespace bourdin_extrapolation_tests
