// SPDX-License-Identifier: BSL-1.0
// Sums and products with what rounding cuts off are exact, whatever the compiler makes of a b + c.
#include <array>

#include <doctest/doctest.h>

#include "hilger/error_free.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/operator/weights.hpp"
#include "hilger/simd.hpp"
#include "support/there.hpp"

namespace error_free_tests {

using namespace hilger;

namespace {

template <class S>
std::vector<S> numbers() {
    std::vector<S> all{S(1), S(-3), S(1) / 3, S(-1) / 10, S(1) - epsilon<S>(), S(7) / 5, S(1e5) / 7, S(-1e-5) / 9};
    for (std::size_t i = 1; i <= 12; ++i) all.push_back(all[i] * all[i - 1] / S(1.7) + S(1) / 13);
    return all;
}
template <class S>
long inexact_products() {
    long wrong = 0;
    for (S const& x : numbers<S>())
        for (S const& y : numbers<S>()) {
            S product, rest;
            detail::two_product(x, y, product, rest);
            wrong += product == x * y and Q(product) + Q(rest) == Q(x) * Q(y) ? 0 : 1;
        }
    return wrong;
}
template <class S>
long inexact_sums() {
    long wrong = 0;
    for (S const& x : numbers<S>())
        for (S const& y : numbers<S>()) {
            S sum, rest;
            detail::two_sum(x, y, sum, rest);
            wrong += sum == x + y and Q(sum) + Q(rest) == Q(x) + Q(y) ? 0 : 1;
            S const& large = std::abs(x) < std::abs(y) ? y : x;
            S const& small = std::abs(x) < std::abs(y) ? x : y;
            detail::fast_two_sum(large, small, sum, rest);
            wrong += sum == x + y and Q(sum) + Q(rest) == Q(x) + Q(y) ? 0 : 1;
        }
    return wrong;
}

#if defined(__GNUC__) && defined(__x86_64__)
#define FUSED __attribute__((target("fma"), noinline, optimize("O3")))
#if defined(__clang__)
#undef FUSED
#define FUSED __attribute__((target("fma"), noinline))
#endif
/// What a user's function for processors with fused products makes of it.
FUSED double rest_of_product(double x, double y) {
    double product, rest;
    detail::two_product(x, y, product, rest);
    return rest;
}
/// (x y + 1/3) - 1/3 - x y in double-double numbers is zero to their rounding.
FUSED double difference(double x, double y) {
    using wide = detail::double_double<double>;
    wide const p = wide(x) * wide(y), third = wide(1.0) / 3.0;
    return static_cast<double>(((p + third) - third) - p);
}
FUSED std::vector<double> weights(double alpha, index_type n) { return first_weights<bdf<2>>(alpha, n); }
#endif

} // namespace

TEST_CASE("sum + rest and product + rest are what was added and multiplied") {
    CHECK(inexact_sums<double>() == 0);
    CHECK(inexact_sums<float>() == 0);
    CHECK(inexact_sums<long double>() == 0);
    CHECK(inexact_products<double>() == 0);
    CHECK(inexact_products<float>() == 0);
    CHECK(inexact_products<long double>() == 0);
}

TEST_CASE("also at compile time") {
    constexpr auto both = [] {
        std::array<double, 2> r{};
        detail::two_product(0.1, 0.3, r[0], r[1]);
        return r;
    }();
    CHECK(Q(both[0]) + Q(both[1]) == Q(0.1) * Q(0.3));
}

TEST_CASE("a sum into one of its terms, and of vectors") {
    double x = 1, y = 0x1p-60;
    detail::two_sum(x, y, x, y);
    CHECK(x == 1.0);
    CHECK(y == 0x1p-60);
    detail::two_sum(y, x, y, x);
    CHECK(y == 1.0);
    CHECK(x == 0x1p-60);
}

#if defined(__GNUC__) && defined(__x86_64__)
TEST_CASE("inlined into a function for processors with fused products") {
    using namespace detail::memory;
    if (not testing::is_there(available_instructions() >= instructions::avx2, "fused product")) return;
    for (double const x : numbers<double>())
        for (double const y : numbers<double>()) {
            double const product = x * y;
            CHECK(Q(product) + Q(rest_of_product(x, y)) == Q(x) * Q(y));
            CHECK(std::abs(difference(x, y)) <= 8 * epsilon<double>() * epsilon<double>() * (std::abs(product) + 1));
        }
    for (double const alpha : {0.5, 1 - 1e-12}) {
        auto const here = weights(alpha, 2000), there = first_weights<bdf<2>>(alpha, 2000);
        CHECK(here == there);
    }
}
#endif

} // namespace error_free_tests
