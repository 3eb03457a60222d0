// SPDX-License-Identifier: BSL-1.0
// All differences of a sequence at once, and the wrong answers that other packages give to it.
#include <doctest/doctest.h>

#include <cmath>
#include <complex>

#include "histories.hpp"

namespace history_convolve_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
template <class G, class V>
void right_at_every_point(detail::memory::component_t<V> const& alpha, hilger::index_type N, double bound) {
    using S = detail::memory::component_t<V>;
    auto const x = random_values<V>(N);
    auto const expected = sums_as_written<G>(alpha, x); // [m - 1]: for the value m
    auto const y = convolve<G>(alpha, x);
    REQUIRE(y.size() == x.size());
    for (std::size_t k = 0; k < x.size(); ++k) {
        V const at_k = k == 0 ? x[0] : V(x[k] + expected[k - 1]);
        CAPTURE(N);
        CAPTURE(k);
        REQUIRE(static_cast<double>(magnitude(V(y[k] - at_k))) <= bound * static_cast<double>(epsilon<S>()));
    }
}
} // namespace

TEST_CASE("every point is right, whatever the length: powers of two, their neighbours, odd and even powers") {
    for (hilger::index_type const N : {1, 2, 3, 4, 5, 7, 8, 9, 63, 64, 65, 100, 1023, 1024, 1025, 2049, 5000}) {
        right_at_every_point<grunwald_letnikov, double>(0.5, N, 10);
        right_at_every_point<bdf<2>, float>(0.3F, N, 15);
    }
    right_at_every_point<trapezoid, double>(0.4, 2000, 100);
    right_at_every_point<bdf<2>, Eigen::Vector3d>(0.5, 3000, 15);
    right_at_every_point<bdf<6>, double>(0.5, 2000, 100);
    right_at_every_point<grunwald_letnikov, float50>(float50(1) / 3, 300, 20);
    right_at_every_point<grunwald_letnikov, Q>(Q(2, 3), 65, 0);
    CHECK(convolve<grunwald_letnikov>(0.5, std::vector<double>{}).empty());
}

TEST_CASE("a transform that is not padded is right at the last point only (differint): here the first is, too") {
    // Values that are large at the end would come round to the beginning.
    std::vector<double> x(4096, 0.0);
    x.back() = 1e6;
    x[1] = 1;
    auto const y = convolve<grunwald_letnikov>(0.5, x);
    auto const w = first_weights<grunwald_letnikov>(0.5, 4096);
    for (std::size_t k = 0; k + 1 < x.size(); ++k) REQUIRE(std::abs(y[k] - (k == 0 ? 0 : w[k - 1])) <= 1e6 * 10 * epsilon<double>());
    CHECK(y.back() == doctest::Approx(1e6 + w[4094]).epsilon(1e-15));
}

TEST_CASE("weights in reversed order beyond n = 64: an impulse shows every engine's weights one by one") {
    auto const check = [](auto engine) {
        weight_sequence<grunwald_letnikov, double> w(0.4);
        w.next();
        for (int n = 1; n <= 700; ++n) {
            engine.push(n == 1 ? 1 : 0);
            REQUIRE(engine.past() == doctest::Approx(w.next()).epsilon(1e-11));
        }
    };
    check(make_history<grunwald_letnikov>(direct{}, 0.4, 0.0));
    check(make_history<grunwald_letnikov>(blocks{}, 0.4, 0.0));
    check(make_history<grunwald_letnikov>(exponentials{}, 0.4, 0.0));
}

TEST_CASE("memory sums that are overwritten instead of added: of constant values the sum is the product formula") {
    // w_0 + ... + w_m = (1 - alpha)(1 - alpha/2)...(1 - alpha/m)
    auto const check = [](auto engine) {
        double product = 1;
        for (int m = 1; m <= 20'000; ++m) {
            engine.push(1);
            product *= 1 - 0.3 / m;
            REQUIRE(std::abs(1 + engine.past() - product) <= 1e-13);
        }
    };
    check(make_history<grunwald_letnikov>(blocks{}, 0.3, 0.0));
    check(make_history<grunwald_letnikov>(exponentials{}, 0.3, 0.0));
    auto const all = convolve<grunwald_letnikov>(0.3, std::vector<double>(20'000, 1.0));
    double product = 1;
    for (std::size_t m = 0; m < all.size(); ++m) {
        if (m > 0) product *= 1 - 0.3 / static_cast<double>(m);
        REQUIRE(std::abs(all[m] - product) <= 1e-13);
    }
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

} // namespace history_convolve_tests
