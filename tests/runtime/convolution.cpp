// SPDX-License-Identifier: BSL-1.0
// Fourier transforms against their definition, convolutions against the sum, at every point.
#include <doctest/doctest.h>

#include <random>

#if HILGER_HAS_FLOAT128
#include "hilger/float128.hpp"
#endif
#include "hilger/history/convolution.hpp"
#include "hilger/multiprecision.hpp"

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
/// Four epsilons times the norms for each of the passes: their error, were all roundings to add up.
template <class S>
S bound(std::vector<S> const& a, std::vector<S> const& b) {
    auto const n = a.size() + b.size();
    return S(4) * S(static_cast<int>(std::bit_width(n))) * epsilon<S>() * norm(a) * norm(b);
}
template <class S>
bool is_sum(std::vector<S> const& c, std::vector<S> const& a, std::vector<S> const& b, std::size_t size) {
    auto const expected = detail::direct_convolution(a, b, size);
    if (c.size() != size) return false;
    for (std::size_t k = 0; k < size; ++k)
        if (not(magnitude(S(c[k] - expected[k])) <= bound(a, b))) return false;
    return true;
}

} // namespace

TEST_CASE_TEMPLATE("a transform is the sum that defines it, for every size, and its inverse undoes it", S, float, double, long double,
                   float128, float50) {
    using std::cos, std::sin, std::acos;
    for (std::size_t n : {1, 2, 4, 8, 16, 32, 64}) {
        auto const re = some_values<S>(n, 1), im = some_values<S>(n, 2);
        std::vector<complex_number<S>> x(n);
        for (std::size_t j = 0; j < n; ++j) x[j] = {re[j], im[j]};
        auto y = x;
        fft(y, false);
        S const rounding = S(16) * epsilon<S>() * (norm(re) + norm(im)) * S(static_cast<int>(n));
        for (std::size_t k = 0; k < n; ++k) {
            complex_number<S> sum{S(0), S(0)};
            for (std::size_t j = 0; j < n; ++j) {
                S const angle = S(2) * acos(S(-1)) * S(static_cast<int>(j * k % n)) / S(static_cast<int>(n));
                sum = sum + x[j] * complex_number<S>{cos(angle), S(-sin(angle))};
            }
            CHECK(magnitude(S(sum.re - y[k].re)) <= rounding);
            CHECK(magnitude(S(sum.im - y[k].im)) <= rounding);
        }
        fft(y, true);
        for (std::size_t j = 0; j < n; ++j) {
            CHECK(magnitude(S(x[j].re - y[j].re)) <= rounding);
            CHECK(magnitude(S(x[j].im - y[j].im)) <= rounding);
        }
    }
}

TEST_CASE("a transform has a power of two values") {
    std::vector<complex_number<double>> three(3), none;
    CHECK_THROWS_AS(fft(three, false), error::invalid_parameter);
    CHECK_THROWS_AS(fft(none, false), error::invalid_parameter);
}

TEST_CASE_TEMPLATE("a convolution is the sum at every point, for lengths around powers of two and any size", S, float, double, float50) {
    for (std::size_t n : {1, 2, 31, 48, 49, 64, 65, 100, 128, 129})
        for (std::size_t m : {1, 5, 49, 63, 64, 127}) {
            auto const a = some_values<S>(n, 3), b = some_values<S>(m, 4);
            for (std::size_t size : {std::size_t(1), n / 2, n, n + m - 1, n + m + 7}) CHECK(is_sum(convolve(a, b, size), a, b, size));
        }
}

TEST_CASE("transforms larger than the cache are as right") {
    for (std::size_t n : {5000, 9000, 40000}) { // packed into 8192, 16384 and 65536 numbers
        auto const a = some_values<double>(n, 5), b = some_values<double>(n - 1, 6);
        auto const c = convolve(a, b, n);
        for (std::size_t k = 0; k < n; k += n / 97) {
            double sum = 0;
            for (std::size_t i = 0; i <= std::min(k, n - 1); ++i)
                if (k - i < b.size()) sum += a[i] * b[k - i];
            CHECK(std::abs(sum - c[k]) <= bound(a, b));
        }
    }
}

TEST_CASE("exact scalars are summed, and exactly") {
    CHECK(convolve(std::vector<Q>{1, Q(1, 2)}, std::vector<Q>{3, Q(1, 3), 2}, 5) == std::vector<Q>{3, Q(11, 6), Q(13, 6), 1, 0});
    CHECK(convolve(std::vector<Q>{}, std::vector<Q>{1}, 2) == std::vector<Q>{0, 0});
    auto const a = some_values<Q>(70, 7);
    CHECK(toeplitz_triangle<Q>(a)(a) == detail::direct_convolution(a, a, 70));
}

TEST_CASE("a kernel kept is the convolution, and takes as many values as it has rows") {
    for (std::size_t n : {1, 20, 49, 64, 65, 3000}) {
        auto const a = some_values<double>(n, 8), b = some_values<double>(n, 9);
        toeplitz_triangle<double> const triangle(a);
        CHECK(is_sum(triangle(b), a, b, n));
        CHECK(is_sum(triangle(a), a, a, n)); // a second time
    }
    CHECK_THROWS_AS((void)toeplitz_triangle<double>({1.0, 2.0})({1.0}), error::mismatch);
}
