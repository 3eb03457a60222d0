// SPDX-License-Identifier: BSL-1.0
// The weights of powers on floats: against divided differences in 250 digits, against the roots of the triangle, and against the weights of
// equal steps. An error is some tens of epsilon, those of the nodes, and one more for each factor of the products.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/calculus.hpp"
#include "hilger/multiprecision.hpp"

namespace power_weights_tests {

using namespace hilger;

namespace {

/// Divided differences of 24 steps lose up to 150 digits.
using wide = mp::number<mp::cpp_bin_float<250>, mp::et_off>;

template <class S>
std::vector<S> row_of(S const& alpha, std::vector<S> const& w) {
    return detail::power_row(alpha, static_cast<hilger::index_type>(w.size()),
                             [&](hilger::index_type n) { return w[static_cast<std::size_t>(n)]; });
}
/// Opitz: (C^alpha)_{0n} = (-1)^n (prod_{m<n} z_m) [z_0, ..., z_n] z^alpha, z_m = 1/w_m all different.
template <class S>
std::vector<wide> by_divided_differences(S const& alpha, std::vector<S> const& w) {
    std::vector<wide> z, difference, row;
    for (std::size_t n = 0; n < w.size(); ++n) {
        z.push_back(1 / wide(w[n]));
        difference.push_back(pow(z[n], wide(alpha)));
        wide before(0), product(1);
        for (std::size_t i = n; i-- > 0;) {
            swap(before, difference[i]);
            difference[i] = (difference[i + 1] - before) / (z[n] - z[i]);
            product *= -z[i];
        }
        row.push_back(product * difference[0]);
    }
    return row;
}
/// The largest relative error of an entry, in epsilon of S and divided by 64 plus its number.
template <class S, class R>
double worst_error(std::vector<S> const& row, std::vector<R> const& exact) {
    REQUIRE(row.size() == exact.size());
    wide worst(0);
    for (std::size_t n = 0; n < row.size(); ++n) {
        wide const e(exact[n]), error = abs((wide(row[n]) - e) / e) / (64 + n);
        if (not(error <= worst)) worst = error;
    }
    return static_cast<double>(worst / wide(epsilon<S>()));
}
/// n different steps without pattern, between 1 and `ratio`.
template <class S>
std::vector<S> uneven_steps(std::size_t n, S const& ratio) {
    using std::pow;
    std::vector<S> w;
    for (std::size_t i = 0; i < n; ++i) w.push_back(pow(ratio, S(S((37 * i + 5) % 101) / S(101))));
    return w;
}

} // namespace

TEST_CASE_TEMPLATE("entries against divided differences", S, float, double, long double, float50) {
    for (S const& alpha :
         {S(1) / S(1000), S(1) / S(4), S(1) / S(2), S(3) / S(4), S(999) / S(1000), S(-1) / S(1000), S(-1) / S(2), S(-999) / S(1000)})
        for (S const& ratio : {S(2), S(1000), S(1'000'000)}) {
            auto const w = uneven_steps(24, ratio);
            CHECK(worst_error(row_of(alpha, w), by_divided_differences(alpha, w)) <= 1);
        }
}
TEST_CASE_TEMPLATE("steps that grow by a million, and equal steps among others", S, double, float50) {
    std::vector<S> growing{S(1)}, falling, repeated;
    for (int i = 0; i < 4; ++i) growing.push_back(growing.back() * S(1'000'000));
    falling.assign(growing.rbegin(), growing.rend());
    for (int i = 0; i < 40; ++i) repeated.push_back(S(i % 3 == 0 ? 4 : i % 7 == 0 ? 1 : 9));
    std::vector<wide> roots;
    for (S const& w : repeated) roots.push_back(1 / sqrt(wide(w)));
    for (S const& alpha : {S(1) / S(4), S(1) / S(2), S(7) / S(8), S(-1) / S(3), S(-7) / S(8)})
        for (auto const& w : {growing, falling}) {
            CHECK(worst_error(row_of(alpha, w), by_divided_differences(alpha, w)) <= 1);
        }
    CHECK(worst_error(row_of(S(S(1) / S(2)), repeated), detail::row_of_root(roots, 1, 2)) <= 1);
    for (wide& r : roots) r = 1 / r;
    CHECK(worst_error(row_of(S(S(-1) / S(2)), repeated), detail::row_of_root(roots, 1, 2, true)) <= 1);
}
TEST_CASE_TEMPLATE("equal steps have the weights of Gruenwald and Letnikov", S, float, double, long double) {
    std::vector<S> const w(2000, S(1));
    for (S const& alpha : {S(1) / S(1000), S(1) / S(2), S(999) / S(1000), S(-1) / S(2)})
        CHECK(worst_error(row_of(alpha, w), first_weights<grunwald_letnikov>(wide(alpha), 2000)) <= 1);
}

namespace {

/// f without pattern, positive, on uneven steps.
template <class S>
constexpr int steps = std::floating_point<S> ? 40 : 8; // a row of 50 digits takes time
template <class S>
auto positive(int seed) {
    std::vector<S> points{S(1)}, values{S(3)};
    for (S const& w : uneven_steps(steps<S>, S(1000))) {
        points.push_back(points.back() + w);
        values.push_back(S(1 + (points.size() * 41 + static_cast<std::size_t>(seed)) % 17));
    }
    return function_on(time_scale<S>(points), values);
}
/// The sums of the sizes of the terms of Delta_-^alpha[f], whose weights are negative beside the diagonal.
template <class S, class F>
auto sizes_of(S const& alpha, F const& f) {
    using std::pow;
    std::vector<S> sizes;
    auto const d = Delta_minus(alpha)[f];
    for (hilger::index_type k = d.first(); k <= d.last(); ++k)
        sizes.push_back(S(2) * pow(f.root().step(std::max<hilger::index_type>(k - 1, 0)), S(-alpha)) * f[k] - d[k]);
    return function_on(f.root(), sizes);
}

} // namespace

TEST_CASE_TEMPLATE("orders add up, within the rounding of the weights", S, float, double, long double, float50) {
    auto const f = positive<S>(1);
    S const rounding = S(2 * (64 + steps<S>)) * epsilon<S>();
    for (S const& alpha : {S(1) / S(4), S(1) / S(2), S(7) / S(8)}) {
        S const rest = S(1) - alpha;
        auto const once = tabulate(Delta_minus(alpha)[f]);
        auto const twice = Delta_minus(rest)[once];
        auto const whole = Delta_minus(1)[f];
        auto const above = (Delta_minus(1) * Delta_minus(alpha))[f]; // an order above 1
        auto const difference = Delta_minus[once];
        auto const bound = sizes_of(rest, sizes_of(alpha, f));
        for (hilger::index_type k = 0; k <= steps<S>; ++k) CHECK(magnitude(S(twice[k] - whole[k])) <= rounding * bound[k]);
        for (hilger::index_type k = 1; k <= steps<S>; ++k) CHECK(above[k] == difference[k]);
    }
}
TEST_CASE_TEMPLATE("integration by parts, within the rounding of the weights", S, float, double, long double, float50) {
    auto const f = positive<S>(1), g = positive<S>(5);
    for (S const& alpha : {S(1) / S(4), S(1) / S(2), S(7) / S(8)}) {
        auto const parts = by_parts(Delta_minus(alpha), f, g);
        auto const sizes = sizes_of(alpha, f);
        S size(0);
        for (hilger::index_type k = 0; k <= steps<S>; ++k)
            size = size + f.root().step(std::max<hilger::index_type>(k - 1, 0)) * g[k] * sizes[k];
        CHECK(magnitude(S(parts.left - parts.interior - parts.boundary)) <= S(2 * (64 + steps<S>)) * epsilon<S>() * size);
        CHECK(magnitude(S(parts.left - parts.interior)) > S(1) / S(10000) * size);
    }
}
TEST_CASE("steps at the ends of the range of a double") {
    time_scale<double> const T{0, 1e-305, 1, 2, 1e300, 2e300};
    auto const f = function_on(T, std::vector{1.0, 2.0, 5.0, 4.0, 3.0, 7.0});
    auto const minus = Delta_minus(0.5)[f];
    auto const plus = Delta_plus(0.9)[f];
    auto const sums = Delta_plus(-0.9)[f];
    for (hilger::index_type k = 0; k <= 5; ++k) CHECK(is_finite(minus[k]));
    for (hilger::index_type k = 0; k <= 5; ++k) CHECK((is_finite(plus[k]) and is_finite(sums[k])));
}

} // namespace power_weights_tests
