// SPDX-License-Identifier: BSL-1.0
// Convolutions against the sum, at every point.
#include <doctest/doctest.h>

#include <random>

#if HILGER_HAS_FLOAT128
#include "hilger/float128.hpp"
#endif
#include "hilger/history/convolution.hpp"
#include "hilger/multiprecision.hpp"

namespace convolution_tests {

using namespace hilger;

#if !HILGER_HAS_FLOAT128
using float128 = long double;
#endif

namespace {

template <class S>
std::vector<S> some_values(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<S> x;
    for (std::size_t i = 0; i < count; ++i) x.push_back(S(static_cast<int>(random() % 2001) - 1000) / S(7));
    return x;
}
template <class S>
S norm(std::vector<S> const& x) {
    using std::sqrt;
    S sum(0);
    for (S const& value : x) sum = sum + value * value;
    return sqrt(sum);
}
/// Four epsilons times the norms for each of the passes: their error, were all roundings to add up. Some points, or all of few.
template <class S>
bool is_sum(std::vector<S> const& c, std::vector<S> const& a, std::vector<S> const& b) {
    S bound(0);
    if constexpr (not std::numeric_limits<S>::is_exact)
        bound = S(4) * S(static_cast<int>(std::bit_width(2 * a.size()))) * epsilon<S>() * norm(a) * norm(b);
    if (c.size() != a.size()) return false;
    for (std::size_t k = 0; k < a.size(); k += a.size() / 3000 + 1) {
        S sum(0);
        for (std::size_t i = 0; i <= k; ++i) sum = sum + a[i] * b[k - i];
        if (not(magnitude(S(c[k] - sum)) <= bound)) return false;
    }
    return true;
}

} // namespace

TEST_CASE_TEMPLATE("a triangle is the sum at every point, for lengths around powers of two", S, float, double, long double, float128,
                   float50, Q) {
    for (std::size_t n : {1, 2, 31, 48, 49, 64, 65, 100, 128, 129, 257}) {
        auto const a = some_values<S>(n, 3), b = some_values<S>(n, 4);
        toeplitz_triangle<S> const triangle(a);
        CHECK(is_sum(triangle(b), a, b));
        CHECK(is_sum(triangle(a), a, a)); // a second time
    }
}

TEST_CASE("transforms larger than the cache are as right") {
    for (std::size_t n : {5000, 9000, 40'000}) {
        auto const a = some_values<double>(n, 5), b = some_values<double>(n, 6);
        CHECK(is_sum(toeplitz_triangle<double>(a)(b), a, b));
    }
}

TEST_CASE("a triangle takes as many values as it has rows") {
    CHECK_THROWS_WITH_AS((void)toeplitz_triangle<double>({1.0, 2.0})({1.0}), "a triangle of 2 rows was given 1 values", error::mismatch);
}

} // namespace convolution_tests
