// SPDX-License-Identifier: BSL-1.0
// Weights of fractional differences against their definition and against 50 digits.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/multiprecision.hpp"
#include "hilger/operator/weights.hpp"

namespace weights_tests {

using namespace hilger;

namespace {

/// A user's own: ((1 - z)(2 - z) / (2/3 + z^2/3))^alpha
struct mine {
    template <class S>
    static constexpr std::array<S, 3> numerator() {
        return {S(2), S(-3), S(1)};
    }
    template <class S>
    static constexpr std::array<S, 3> denominator() {
        return {S(2) / S(3), S(0), S(1) / S(3)};
    }
};
/// The first n coefficients of x y.
std::vector<Q> product(std::vector<Q> const& x, std::vector<Q> const& y) {
    std::vector<Q> z(x.size(), Q(0));
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; i + j < z.size() and j < y.size(); ++j) z[i + j] += x[i] * y[j];
    return z;
}
template <class G>
void check_powers() {
    // omega^(1/3) three times is omega, omega^(2/3) omega^(-2/3) is 1
    std::size_t const n = 12;
    auto const w = first_weights<G>(Q(1, 3), n);
    CHECK(w[0] == 1);
    auto const cube = product(product(w, w), w);
    auto const p = G::template numerator<Q>();
    auto const q = G::template denominator<Q>();
    auto const back = product(cube, std::vector<Q>(q.begin(), q.end()));
    for (std::size_t i = 0; i < n; ++i) CHECK(back[i] == (i < p.size() ? Q(p[i] * q[0] / p[0]) : Q(0)));
    auto const one = product(first_weights<G>(Q(2, 3), n), first_weights<G>(Q(-2, 3), n));
    for (std::size_t i = 0; i < n; ++i) CHECK(one[i] == (i == 0 ? 1 : 0));
}
template <class G, class S>
double worst_error(S const& alpha, int count) {
    weight_sequence<G, S> w(alpha);
    weight_sequence<G, float100> exact{float100(alpha)};
    float100 worst(0);
    for (int n = 0; n <= count; ++n) {
        float100 const e = exact.next(), error = abs(float100(w.next()) - e);
        if (not(error <= worst * abs(e))) worst = error / abs(e);
    }
    return static_cast<double>(worst);
}

} // namespace

TEST_CASE("weights are the power series of a power: exactly, for every generating function") {
    check_powers<grunwald_letnikov>();
    check_powers<bdf<2>>();
    check_powers<bdf<3>>();
    check_powers<bdf<6>>();
    check_powers<trapezoid>();
    check_powers<mine>();
}

TEST_CASE("Gruenwald-Letnikov: (-alpha)(1 - alpha) ... (r - 1 - alpha) / r!, Bourdin et al. (1)") {
    Q const alpha(2, 7);
    auto const w = first_weights<grunwald_letnikov>(alpha, 9);
    Q product(1);
    for (int r = 1; r < 9; ++r) {
        product = product * (Q(r - 1) - alpha) / r;
        CHECK(w[static_cast<std::size_t>(r)] == product);
    }
    CHECK(first_weights<grunwald_letnikov>(Q(1), 5) == std::vector<Q>{1, -1, 0, 0, 0});
    CHECK(first_weights<bdf<2>>(Q(1), 5) == std::vector<Q>{1, Q(-4, 3), Q(1, 3), 0, 0});
    CHECK(first_weights<bdf<3>>(Q(1), 5) == std::vector<Q>{1, Q(-18, 11), Q(9, 11), Q(-2, 11), 0});
}

TEST_CASE("the weight of the present") {
    CHECK(leading_weight<grunwald_letnikov>(Q(1, 3)) == 1);
    CHECK(leading_weight<bdf<2>>(Q(2)) == Q(9, 4));
    CHECK(leading_weight<trapezoid>(Q(1)) == 2);
    CHECK(std::abs(leading_weight<bdf<2>>(0.5) - std::sqrt(1.5)) <= epsilon<double>());
    CHECK_THROWS_WITH_AS((void)leading_weight<bdf<2>>(Q(1, 2)), "the leading weight 3/2^1/2 is no rational number",
                         error::invalid_parameter);
}

TEST_CASE("an ulp at n = 1e5, whatever the order: the terms cancel to 1e-12 near 0 and 1") {
    for (double const alpha : {1e-12, 0.5, 1 - 1e-12}) {
        CAPTURE(alpha);
        CHECK(worst_error<grunwald_letnikov>(alpha, 100'000) <= epsilon<double>());
        CHECK(worst_error<bdf<2>>(alpha, 100'000) <= epsilon<double>());
    }
    for (double const alpha : {1e-12, 1.0 / 3, 0.75, 1 - 1e-12}) {
        CAPTURE(alpha);
        CHECK(worst_error<bdf<3>>(alpha, 3000) <= epsilon<double>());
        CHECK(worst_error<bdf<6>>(alpha, 3000) <= epsilon<double>());
        CHECK(worst_error<trapezoid>(alpha, 3000) <= epsilon<double>());
        CHECK(worst_error<mine>(alpha, 3000) <= epsilon<double>());
    }
    CHECK(worst_error<bdf<2>>(0.3f, 10'000) <= static_cast<double>(epsilon<float>()));
    CHECK(worst_error<bdf<2>>(0.3L, 10'000) <= static_cast<double>(epsilon<long double>()));
}

/// Twice the derivative to the power alpha.
struct twice {
    template <class S>
    static constexpr std::array<S, 2> numerator() {
        return {S(2), S(-2)};
    }
    template <class S>
    static constexpr std::array<S, 1> denominator() {
        return {S(1)};
    }
};
TEST_CASE("a generating function of something else") {
    CHECK_THROWS_WITH_AS(
        (weight_sequence<twice, Q>(Q(1, 2))),
        "a generating function is omega(z) = (1 - z) + O((1 - z)^2), and positive at z = 0; here omega(1) is 0, omega'(1) -2 "
        "and omega(0) 2",
        error::invalid_parameter);
}
TEST_CASE("an order that is no number") {
    CHECK_THROWS_WITH_AS((weight_sequence<grunwald_letnikov, double>(std::nan(""))),
                         "the order of a fractional difference is a finite number", error::invalid_parameter);
}

} // namespace weights_tests
