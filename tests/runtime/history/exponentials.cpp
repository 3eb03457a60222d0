// SPDX-License-Identifier: BSL-1.0
// Sums of exponentials in place of the weights: each weight within the tolerance, each sum within it of the direct one.
#include <doctest/doctest.h>

#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "histories.hpp"

namespace history_exponentials_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
/// What an engine has for w_1, w_2, ...: its answers to a single 1.
template <class Engine, class Compare>
void answers_to_one(Engine engine, hilger::index_type count, Compare const& compare) {
    for (hilger::index_type n = 1; n <= count; ++n) {
        engine.push(n == 1 ? 1 : 0);
        compare(n, engine.past());
    }
}
/// The largest |w_n - mode sum| / |w_n| for n <= count, in float50.
template <class G>
double worst_weight(double alpha, exponentials const& policy, hilger::index_type count) {
    weight_sequence<G, float50> exact{float50(alpha)};
    exact.next();
    double worst = 0;
    answers_to_one(make_history<G>(policy, alpha, 0.0), count, [&](hilger::index_type, double w) {
        auto const expected = exact.next();
        worst = std::max(worst, std::abs(static_cast<double>((float50(w) - expected) / expected)));
    });
    return worst;
}
} // namespace

TEST_CASE("every weight is within the tolerance of the weight in 50 digits, next to whole orders too") {
    for (double const alpha : {-0.75, 1e-12, 0.1, 0.5, 0.9, 1 - 1e-12, 1 + 1e-12, 1.5, 2 - 1e-12})
        for (double const tolerance : {1e-5, 1e-10, 2e-14}) {
            CAPTURE(alpha);
            CAPTURE(tolerance);
            double const rounding = 30 * epsilon<double>(); // of a sum of some ninety terms
            CHECK(worst_weight<grunwald_letnikov>(alpha, {tolerance}, 3000) <= tolerance + rounding);
            CHECK(worst_weight<bdf<2>>(alpha, {tolerance}, 3000) <= tolerance + rounding);
        }
    CHECK(worst_weight<grunwald_letnikov>(0.3, {1e-6}, 500) > 1e-8); // a wide tolerance is made use of
}

TEST_CASE("and up to the billionth, against quotients of Gamma functions") {
    using boost::math::tgamma, boost::math::lgamma;
    for (double const alpha : {-0.5, 1e-12, 0.25, 0.75, 1 - 1e-12, 1.5}) {
        detail::memory::exponential_weights<grunwald_letnikov, double> const modes(alpha, exponentials{1e-13});
        float50 const a(alpha);
        auto const T = static_cast<double>(modes.first.size());
        for (double n = 20; n <= 1e9; n = std::floor(n * 1.7)) {
            float50 sum(0);
            for (std::size_t j = 0; j < modes.rate.size(); ++j)
                if (modes.rate[j] < 1) sum += float50(modes.coefficient[j]) * exp(float50((n - T - 1) * log1p(-float50(modes.rate[j]))));
            float50 const weight = exp(float50(lgamma(float50(n - a)) - lgamma(float50(n + 1)))) / tgamma(float50(-a));
            CAPTURE(alpha);
            CAPTURE(n);
            REQUIRE(std::abs(static_cast<double>(sum / weight - 1)) <= 1e-13);
        }
    }
}

TEST_CASE("a state that grows for a long time does not stop at its last digit: 400 000 equal values") {
    // Without the low parts of slow modes the distance is 6e-14 here, and grows with the number of values. With them it keeps to the
    // tolerance, which is 64 epsilon where none is given.
    for (double const alpha : {0.05, 0.1, 0.5}) {
        auto engine = make_history<grunwald_letnikov>(exponentials{}, alpha, 0.0);
        long double product = 1;
        double worst = 0;
        for (int m = 1; m <= 400'000; ++m) {
            engine.push(1);
            product *= 1 - static_cast<long double>(alpha) / m;
            worst = std::max(worst, std::abs(static_cast<double>(1 + static_cast<long double>(engine.past()) - product)));
        }
        CAPTURE(alpha);
        CHECK(worst <= 64 * epsilon<double>());
    }
}

TEST_CASE("the state is small: less than 8 kB for G^alpha, and does not grow") {
    auto engine = make_history<bdf<2>>(exponentials{}, 0.5, 0.0);
    auto const bytes = engine.bytes();
    CHECK(bytes <= 8192);
    CHECK(engine.modes() <= 112);
    for (int m = 0; m < 1000; ++m) engine.push(1);
    CHECK(engine.bytes() == bytes);
    CHECK(make_history<bdf<2>>(exponentials{0, 100'000}, 0.5, 0.0).modes() < engine.modes()); // a short run needs fewer
}

TEST_CASE("few Gauss nodes have the moments of many") {
    detail::memory::quadrature<float50> many;
    for (int i = 0; i < 60; ++i) {
        many.node.push_back(1 / float50(1 + i * i));
        many.weight.push_back(1 / float50(2 + i));
    }
    auto const few = detail::memory::gauss(many, 6);
    REQUIRE(few.node.size() == 6);
    for (int power = 0; power <= 12; ++power) {
        float50 expected(0), sum(0);
        for (std::size_t i = 0; i < 60; ++i) expected += many.weight[i] * pow(many.node[i], power);
        for (std::size_t i = 0; i < 6; ++i) sum += few.weight[i] * pow(few.node[i], power);
        double const distance = std::abs(static_cast<double>(sum / expected - 1));
        if (power <= 11)
            CHECK(distance <= 1e-45);
        else
            CHECK(distance > 1e-20); // 2 * 6 moments, and no more
    }
    CHECK(detail::memory::gauss(many, 60).node.size() == 60);
}

} // namespace history_exponentials_tests
