// SPDX-License-Identifier: BSL-1.0
// Sums of exponentials in place of the weights: each weight within the tolerance, each sum within it of the direct one.
#include <doctest/doctest.h>

#include <cmath>

#include "histories.hpp"

using namespace hilger;
using namespace hilger::testing;

namespace {
/// What an engine has for w_1, w_2, ...: its answers to a single 1.
template <class Engine, class Compare>
void answers_to_one(Engine engine, hilger::index count, Compare const& compare) {
    for (hilger::index n = 1; n <= count; ++n) {
        engine.push(n == 1 ? 1 : 0);
        compare(n, engine.past());
    }
}
/// The largest |w_n - mode sum| / |w_n| for n <= count, in float50.
template <class G>
double worst_weight(double alpha, exponentials const& policy, hilger::index count) {
    weight_sequence<G, float50> exact{float50(alpha)};
    exact.next();
    double worst = 0;
    answers_to_one(make_history<G>(policy, alpha, 0.0), count, [&](hilger::index, double w) {
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
            // After n steps a state carries the rounding of n products, at most half an epsilon each.
            double const rounding = 3000 * 0x1p-53;
            CHECK(worst_weight<grunwald_letnikov>(alpha, {tolerance}, 3000) <= tolerance + rounding);
            CHECK(worst_weight<bdf<2>>(alpha, {tolerance}, 3000) <= tolerance + rounding);
        }
}
