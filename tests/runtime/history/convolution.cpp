// SPDX-License-Identifier: BSL-1.0
// Convolutions against the sum, at every point, and the transform that they are made of.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>
#include <random>

#if HILGER_HAS_FLOAT128
#include "hilger/float128.hpp"
#endif
#include "histories.hpp"

namespace convolution_tests {

using namespace hilger;
using namespace hilger::testing;

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

TEST_CASE("the transform has the values of the polynomial at the roots of i, each once, and the way back is the inverse") {
    for (std::size_t const length : {1, 2, 4, 8, 32, 256, 2048, 8192}) {
        detail::memory::fourier<double> transform;
        transform.reserve(length);
        detail::memory::spectrum<double> x;
        noise source;
        for (std::size_t j = 0; j < length; ++j) {
            x.re.push_back(source.next<double>());
            x.im.push_back(source.next<double>());
        }
        auto const before = x;
        // The polynomial z has the roots themselves as values: for length 1 the constant is its own.
        detail::memory::spectrum<double> z;
        z.re.assign(length, 0.0);
        z.im.assign(length, 0.0);
        z.re[length > 1 ? 1 : 0] = 1;
        transform.forward(z, length);
        if (length > 1)
            for (std::size_t j = 0; j < length; ++j)
                CHECK(std::abs(std::pow(std::complex<double>(z.re[j], z.im[j]), static_cast<int>(length)) - std::complex<double>(0, 1)) <=
                      static_cast<double>(length) * 4 * epsilon<double>());
        transform.forward(x, length);
        if (length <= 256)
            for (std::size_t j = 0; j < length; ++j) { // Horner
                std::complex<double> const root(z.re[j], z.im[j]);
                std::complex<double> value = 0;
                for (std::size_t i = length; i-- > 0;) value = value * root + std::complex<double>(before.re[i], before.im[i]);
                if (length > 1) CHECK(std::abs(value - std::complex<double>(x.re[j], x.im[j])) <= 1e-13 * static_cast<double>(length));
            }
        transform.backward(x, length);
        for (std::size_t j = 0; j < length; ++j) {
            REQUIRE(std::abs(x.re[j] / static_cast<double>(length) - before.re[j]) <= 1e-15 * 5);
            REQUIRE(std::abs(x.im[j] / static_cast<double>(length) - before.im[j]) <= 1e-15 * 5);
        }
    }
}

} // namespace convolution_tests
