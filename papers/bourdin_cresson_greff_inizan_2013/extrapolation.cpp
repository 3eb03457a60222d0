// SPDX-License-Identifier: BSL-1.0
// The exponents of the error of two-sided fractional problems, fitted in 50 digits. An exponent that is missing in the sequence would be
// the order that is left after all others are removed; one too many would leave the order of the next.
//
// For L = v^2 / 2, x(t_0) = 0 and 1/2 < alpha <= 1 the solution is  Q_k = sum_j beta_{k-j} beta_{N-j} / sum_j beta_j^2 x(t_N).  At a fixed
// t the sum above is a Gruenwald-Letnikov integral of a smooth function, right up to h, h^2, ...; the one below is a sum of j^(2 alpha - 2)
// (1 + c / j + ...), an integral up to h^(2 alpha - 1), h, h^2, ... So the quotient has errors with the exponents
//   { m (2 alpha - 1) + n,  m, n = 0, 1, ... } without 0:  1/2, 1, 3/2, 2, ... for alpha = 3/4.
// An L that depends on x has the same first two, 2 alpha - 1 and (for alpha >= 3/4) 1, and others too, 1 + alpha among them.
#include <doctest/doctest.h>

#include <algorithm>

#include "exact.hpp"
#include "hilger/boundary/solve.hpp"
#include "hilger/multiprecision.hpp"
#include "support/two_sided.hpp"

namespace bourdin_extrapolation_tests {

using namespace hilger;
using namespace hilger::papers;
using hilger::testing::two_sided;

namespace {

using wide = float50;

/// The first `count` exponents of h in the error of L = v^2 / 2, ascending.
template <class S>
std::vector<S> error_exponents(S const& alpha, int count) {
    S const step = S(2) * alpha - S(1);
    std::vector<S> all;
    for (int m = 0; m <= count; ++m)
        for (int n = 0; n <= count; ++n)
            if (m + n > 0) all.push_back(S(m) * step + S(n));
    std::sort(all.begin(), all.end());
    std::vector<S> exponents;
    for (S const& e : all) // those that differ by rounding are one
        if (exponents.empty() or exponents.back() * (S(1) + S(64) * epsilon<S>()) < e) exponents.push_back(e);
    exponents.resize(static_cast<std::size_t>(count));
    return exponents;
}
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

} // namespace bourdin_extrapolation_tests
